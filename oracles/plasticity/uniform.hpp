#pragma once
// Fields that are the same everywhere, and what two solids on a strain path declare alike.
#include <algorithm>
#include <limits>

#include "oracles/oracle.hpp"
#include "oracles/plasticity/scalar_j2.hpp"

namespace ordo::oracles {

/// A Sample from a function f(t) that returns the fields of every point as a std::array.
template <class F>
Exact::Sample uniform(F f) {
    return [=](std::span<const double>, double t, std::span<double> values) {
        const auto row = f(t);
        for (auto out = values.begin(); out != values.end();) out = std::copy(row.begin(), row.end(), out);
    };
}

/// A solid on a strain path: row(t) returns its fields as a std::array.
template <class F>
Exact on_strain_path(const StrainPath& path, const std::vector<FieldInfo>& fields, F row, const Constants& constants) {
    constexpr double anywhere = std::numeric_limits<double>::max();
    return {.dim = 1,
            .coordinates = Coordinates::material,
            .lower = {-anywhere},
            .upper = {anywhere},
            .times = between(0, path.last_time()),
            .fields = fields,
            .sample = uniform(row),
            .jumps = no_jumps,
            .features = no_features,
            .constants = [constants](std::optional<double>) { return constants; }};
}

}  // namespace ordo::oracles
