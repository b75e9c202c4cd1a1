// Modes of the bar fixed at X = 0 and loaded at X = L: k_n = (2n-1) pi / (2L), omega_n = c k_n. The sums run from the
// smallest term to the largest. Their bounds compare what is left with an integral: the terms are convex in n, so that
// f(omega_n) spacing <= int f over the spacing around omega_n, spacing = pi c / L.
#include <boost/math/constants/constants.hpp>
#include <boost/math/special_functions/sinc.hpp>
#include <limits>

#include "oracles/bars/bar_traction.hpp"

namespace ordo::oracles {
namespace {

constexpr double pi = boost::math::constants::pi<double>();
constexpr double infinite = std::numeric_limits<double>::infinity();

/// sum_{n <= terms} amplitude(omega_n) (-1)^(n+1) sin(k_n X).
template <class F>
double modes(const BarTraction& bar, double X, int terms, F amplitude) {
    double sum = 0;
    for (int n = terms; n >= 1; --n) {
        const double shape = std::sin((n - 0.5) * pi * X / bar.L);
        sum += amplitude(bar.eigenfrequency(n)) * (n % 2 == 0 ? -shape : shape);
    }
    return sum;
}

}  // namespace

double BarTraction::modal_displacement(double X, double t, int terms) const {
    const double weight = 2 * tau / (rho * L);
    if (profile == Profile::step) {
        return modes(*this, X, terms, [&](double w) {
            const double s = std::sin(w * t / 2) / w;
            return weight * 2 * s * s;
        });
    }
    // [w sin omega t - omega sin w t] / (w (w^2 - omega^2)), with the factor omega - w divided out.
    return modes(*this, X, terms, [&](double w) {
        const double beat = boost::math::sinc_pi((omega - w) * t / 2);
        return weight * (std::sin(w * t) - w * t * std::cos((omega + w) * t / 2) * beat) / (w * (omega + w));
    });
}

double BarTraction::modal_bound(int terms) const {
    const double spacing = pi * wave_speed() / L;
    const double cut = terms * spacing;
    const double weight = 2 * std::abs(tau) / (rho * L * spacing);
    if (profile == Profile::step) return 2 * weight / cut;
    return omega < cut ? weight * -std::log1p(-omega / cut) / omega : infinite;
}

double BarTraction::lifted_displacement(double X, double t, int terms) const {
    const double weight = 2 * tau / (rho * L);
    if (profile == Profile::step) {
        return tau * X / E - modes(*this, X, terms, [&](double w) { return weight * std::cos(w * t) / (w * w); });
    }
    const double k = omega / wave_speed();
    const double forced = tau / (E * k) * std::sin(k * X) * std::sin(omega * t) / std::cos(k * L);
    return forced + modes(*this, X, terms,
                          [&](double w) { return weight * omega / (w * (omega - w) * (omega + w)) * std::sin(w * t); });
}

double BarTraction::lifted_bound(int terms) const {
    const double spacing = pi * wave_speed() / L;
    const double cut = terms * spacing;
    const double weight = 2 * std::abs(tau) / (rho * L * spacing);
    if (profile == Profile::step) return weight / cut;
    if (resonant_mode() > 0 || omega >= cut) return infinite;
    return weight * -std::log1p(-(omega / cut) * (omega / cut)) / (2 * omega);
}

}  // namespace ordo::oracles
