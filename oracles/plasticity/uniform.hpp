#pragma once
// Fields that are the same everywhere.
#include <algorithm>

#include "oracles/oracle.hpp"

namespace ordo::oracles {

/// A Sample from a function f(t) that returns the fields of every point as a std::array.
template <class F>
Exact::Sample uniform(F f) {
    return [=](std::span<const double>, double t, std::span<double> values) {
        const auto row = f(t);
        for (auto out = values.begin(); out != values.end();) out = std::copy(row.begin(), row.end(), out);
    };
}

}  // namespace ordo::oracles
