#pragma once
// Exact solutions of one field on a line, made by hand for the tests of what is measured on cells.
#include <array>
#include <limits>
#include <utility>
#include <vector>

#include "oracles/oracle.hpp"

namespace ordo::tests {

/// The field "density" = f(x) on the whole line, with these jumps and waves at all times.
template <class F>
oracles::Exact on_a_line(F f, std::vector<double> jumps = {}, std::vector<oracles::Wave> waves = {}) {
    constexpr double furthest = std::numeric_limits<double>::max();
    oracles::Exact exact;
    exact.coordinates = oracles::Coordinates::spatial;
    exact.lower = {-furthest};
    exact.upper = {furthest};
    exact.fields = {{"density", "kg/m^3", 0}};
    exact.sample = oracles::along_a_line([f](double x, double) { return std::array{f(x)}; });
    exact.jumps = [jumps](double) { return jumps; };
    if (!waves.empty()) exact.waves = [waves](double) { return waves; };
    return exact;
}

/// `cells` equal ones over [from, to]: their n + 1 edges.
inline std::vector<double> equal_edges(double from, double to, std::size_t cells) {
    std::vector<double> edges;
    for (std::size_t i = 0; i <= cells; ++i)
        edges.push_back(from + (to - from) * static_cast<double>(i) / static_cast<double>(cells));
    return edges;
}

/// 0 left of x = 0, 1 right of x = 1 and linear between them: a fan of linear rise.
inline double ramp(double x) { return x < 0 ? 0 : x < 1 ? x : 1; }

}  // namespace ordo::tests
