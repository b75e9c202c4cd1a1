#pragma once
// Symmetric compositions of drifts and kicks.
#include <cmath>
#include <vector>

namespace ordo::solvers::mpm {

/// Shares of dt: drift[0], kick[0], drift[1], kick[1], ..., drift[n].
struct Composition {
    std::vector<double> drift, kick;
};

/// Leapfrogs of the given shares of dt, one after the other.
inline Composition leapfrogs(const std::vector<double>& shares) {
    Composition scheme{{0}, {}};
    for (const double share : shares) {
        scheme.drift.back() += share / 2;
        scheme.kick.push_back(share);
        scheme.drift.push_back(share / 2);
    }
    return scheme;
}

/// Order 4 of three leapfrogs, and order 6 of seven (his solution A).   [Yoshida1990]
inline Composition yoshida4() {
    const double w1 = 1 / (2 - std::cbrt(2.0));
    return leapfrogs({w1, 1 - 2 * w1, w1});
}
inline Composition yoshida6() {
    const double w1 = -0.117767998417887e1;
    const double w2 = 0.235573213359357;
    const double w3 = 0.784513610477560;
    return leapfrogs({w3, w2, w1, 1 - 2 * (w1 + w2 + w3), w1, w2, w3});
}

}  // namespace ordo::solvers::mpm
