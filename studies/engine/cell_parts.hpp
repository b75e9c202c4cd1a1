#pragma once
// Cells cut into parts on which an exact solution is smooth, and the nodes by which they are integrated.
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "oracles/oracle.hpp"

namespace ordo::studies {

/// Kronrod's nodes on (0, 1), rising, between two beside the ends that only look for changes of sign.
struct Kronrod {
    static constexpr std::size_t size = 17;
    using Values = std::array<double, size>;

    Values place{};
    Values weight{};
    Values coarse{};       ///< of Gauss's rule, on every other node
    Values barycentric{};  ///< of the polynomial through all nodes

    /// At s the polynomial through these values at the nodes.
    double interpolated(const Values& values, double s) const;
    /// Its integral from one place to another, exactly.
    double integral(const Values& values, double from, double to) const;
    /// Places of its zeros between nodes of either sign beyond `noise`, rising, to 1e-9.
    std::vector<double> sign_changes(const Values& values, double noise) const;
};
const Kronrod& kronrod();

/// A part of a cell without a jump or a fan's edge inside.
struct CellPart {
    double a, b;
    std::size_t cell;
    bool in_fan;     ///< in the middle half of one
    bool near_wave;  ///< no further than `near` from where a field is not smooth

    bool has_inside() const { return std::nextafter(a, b) < b; }
    /// Strictly inside, in the smallest part too.
    double node(std::size_t i) const {
        const double x = a + kronrod().place[i] * (b - a);
        return x <= a ? std::nextafter(a, b) : x >= b ? std::nextafter(b, a) : x;
    }
};

/// All cells between these rising edges, cut where the exact solution is not smooth at time t and at the quarters of
/// its fans; where `near` is not 0, as far from what is not smooth too.
std::vector<CellPart> parts_of(const oracles::Exact& exact, double t, std::span<const double> edges, double near = 0);

/// Whether x is no further than `near` from one of these places.
bool is_near(double x, std::span<const double> places, double near);

/// Rows of the exact solution at the nodes of all parts, in one call.
std::vector<double> rows_at_nodes(const oracles::Exact& exact, double t, std::span<const CellPart> parts);

}  // namespace ordo::studies
