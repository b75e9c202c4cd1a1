// The series of the oedometer, truncated where a paper truncated it: the static column, and its modes in time.
#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/sinc.hpp>
#include <complex>

#include "oracles/bars/gravity.hpp"
#include "oracles/bars/oedometer.hpp"

namespace ordo::oracles {
namespace {

using Complex = std::complex<double>;
constexpr double pi = boost::math::constants::pi<double>();

/// int_0^t r'(s) exp(i w (t - s)) ds: the response of a mode of frequency w to the ramp of gravity. Over few radians by
/// Gauss-Legendre; else by parts, where the derivatives of the quartic r' end after four.
Complex response(const bars::Ramp& ramp, double w, double t) {
    if (ramp.T == 0) return std::polar(1.0, w * t);
    const double a = std::min(t / ramp.T, 1.0);
    const double z = w * ramp.T;
    if (z * a < 8) {
        const auto share = [&](double s) { return ramp.rate(s) * std::polar(1.0, w * (t - s)); };
        using Rule = boost::math::quadrature::gauss<double, 30>;
        const double half = a * ramp.T / 2;
        Complex sum = 0;
        for (std::size_t i = 0; i < Rule::weights().size(); ++i) {
            const double away = half * Rule::abscissa()[i];
            sum += half * Rule::weights()[i] * (share(half - away) + share(half + away));
        }
        return sum;
    }
    const Complex iz(0, z);
    const auto antiderivative = [&](double s) {  // of 30 s^2 (1 - s)^2 exp(-i z s), without the exponential
        const double p0 = s * s * (1 - s) * (1 - s), p1 = 2 * s * (1 - s) * (1 - 2 * s), p2 = 2 - 12 * s * (1 - s);
        const double p3 = 24 * s - 12, p4 = 24;
        return -30.0 / iz * (p0 + (p1 + (p2 + (p3 + p4 / iz) / iz) / iz) / iz);
    };
    return std::polar(1.0, w * (t - a * ramp.T)) * antiderivative(a) - std::polar(1.0, w * t) * antiderivative(0);
}

}  // namespace

bars::Fields Oedometer::series(double a, double b, double t, int count) const {
    const double middle = (a + b) / 2;
    const double width = b - a;
    const bars::Ramp gravity{ramp};
    const double weight = rho * g / E;
    const double sunk = weight * (middle * (middle - 2 * H) / 2 + width * width / 24);
    const double r = ramp > 0 ? gravity.value(t) : 1;
    bars::Fields sum{r * sunk + p0 / E * middle, gravity.rate(t) * sunk, r * weight * (middle - H) + p0 / E};
    for (int n = count; n >= 1; --n) {
        const double odd = 2 * n - 1;
        const double k = odd * pi / (2 * H);
        const double w = wave_speed() * k;
        const double pulled = 16 * weight * H * H / (odd * odd * odd * pi * pi * pi);
        const double pushed = (n % 2 == 0 ? 8 : -8) * H * p0 / (odd * odd * pi * pi * E);
        const Complex swing = response(gravity, w, t);
        const double now = pulled * swing.real() + pushed * std::cos(w * t);
        const double rate = pulled * (gravity.rate(t) - w * swing.imag()) - pushed * w * std::sin(w * t);
        const double flat = boost::math::sinc_pi(k * width / 2);
        const double sine = flat * std::sin(k * middle);
        sum = sum + bars::Fields{now * sine, rate * sine, now * k * flat * std::cos(k * middle)};
    }
    return sum;
}

/// What is left of sum 1/(2n-1)^p after N terms is below the integral from N + 1/2: the terms are convex.
double Oedometer::series_bound(int count) const {
    const double N = count;
    return rho * g * H * H / (pi * pi * pi * E * N * N) + 2 * H * std::abs(p0) / (pi * pi * E * N);
}

}  // namespace ordo::oracles
