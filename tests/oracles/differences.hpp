#pragma once
// What the gates of exact solutions share: a defect with what is allowed of it, and derivatives that know their error.
#include <algorithm>
#include <array>
#include <cmath>

namespace ordo::oracles::gate {

/// How far a statement is from true, and how far it may be; both relative. A gate whose own error is not small against
/// the faults it looks for says nothing, so it does not hold either.
struct Defect {
    double found = 0;
    double allowed = 0;

    bool holds() const { return allowed < 1e-7 && found <= allowed; }
    void add(double difference, double tolerance, double scale) {
        if (std::isnan(found)) return;  // once NaN, it stays
        if (!(std::abs(difference) / scale <= found)) found = std::abs(difference) / scale;
        allowed = std::max(allowed, tolerance / scale);
    }
};

/// A derivative by eighth-order central differences. Its error: what halving the step changed (far more than what is
/// left), and the values' round-off `noise` over the step.
struct Derivative {
    double value;
    double error;
};

template <class F>
Derivative first_derivative(F&& f, double x, double step, double noise) {
    constexpr std::array weights{4.0 / 5, -1.0 / 5, 4.0 / 105, -1.0 / 280};
    const auto with = [&](double s) {
        double sum = 0;
        for (int k = 1; k <= 4; ++k) sum += weights[k - 1] * (f(x + k * s) - f(x - k * s));
        return sum / s;
    };
    const double fine = with(step / 2);
    return {fine, std::abs(fine - with(step)) + 2.1 * noise / (step / 2)};  // 2.1 > sum of |weights|
}

template <class F>
Derivative second_derivative(F&& f, double x, double step, double noise) {
    constexpr std::array weights{8.0 / 5, -1.0 / 5, 8.0 / 315, -1.0 / 560};
    const auto with = [&](double s) {
        double sum = -205.0 / 72 * f(x);
        for (int k = 1; k <= 4; ++k) sum += weights[k - 1] * (f(x + k * s) + f(x - k * s));
        return sum / (s * s);
    };
    const double fine = with(step / 2);
    return {fine, std::abs(fine - with(step)) + 6.6 * noise / (step * step / 4)};
}

}  // namespace ordo::oracles::gate
