#include "oracles/bars/end_load.hpp"

#include <boost/math/constants/constants.hpp>
#include <boost/math/special_functions/sinc.hpp>
#include <limits>

namespace ordo::oracles::bars {
namespace {

constexpr double pi = boost::math::constants::pi<double>();

/// From the loaded end to the fixed one in even transits, back in odd ones.
double front_at(const Transit& way, double L) { return way.outward() ? L * (1 - way.part) : L * way.part; }

double sign_of(double m) { return m == 2 * std::floor(m / 2) ? 1 : -1; }  // (-1)^m

/// 1 - sin(z)/z without cancellation.
double one_minus_sinc(double z) {
    if (std::abs(z) > 1) return 1 - boost::math::sinc_pi(z);
    double sum = 0;
    for (int n = 16; n >= 2; n -= 2) sum = z * z / (n * (n + 1)) * (1 - sum);
    return sum;
}

}  // namespace

StepLoad::StepLoad(double L, double c, double e, double t)
    : L_(L), c_(c), e_(e), way_(t, c, L), front_(t > 0 ? front_at(way_, L) : std::numeric_limits<double>::infinity()) {}

Fields StepLoad::left(double X) const {
    const double strain = way_.phase == 1 || way_.phase == 2 ? 2 * e_ : 0;
    return {strain * X, 0, strain};
}

Fields StepLoad::right(double X) const {
    const double part = L_ * way_.part;
    switch (way_.phase) {
        case 0: return {e_ * (X - L_ + part), c_ * e_, e_};
        case 1: return {e_ * (X + part), c_ * e_, e_};
        case 2: return {e_ * (X + (L_ - part)), -c_ * e_, e_};
        default: return {e_ * (X - part), -c_ * e_, e_};
    }
}

Fields StepLoad::mean(double a, double b) const {
    return mean_in_parts(a, b, front_, [&](double low, double high) { return at((low + high) / 2); });
}

SineLoad::SineLoad(double L, double c, double e, double omega, double t)
    : L_(L), c_(c), e_(e), k_(omega / c), way_(t, c, L), front_(front_at(way_, L)) {
    const double pairs = std::floor(way_.count / 2);
    const double theta = omega * L / c;
    const double transits = way_.count + way_.part;
    sign_ = sign_of(pairs);
    right_ = alternating(pairs, theta, transits);
    left_ = way_.outward() ? right_ : alternating(pairs + 1, theta, transits);
}

SineLoad::Sums SineLoad::alternating(double M, double theta, double transits) {
    const double q = std::round(theta / pi - 0.5);
    const double d = theta - (q + 0.5) * pi;  // resonance is d = 0
    if (std::abs(d) < pi / 4) {
        const double quotient = std::abs(d) < 1e-300 ? M : std::sin(M * d) / std::sin(d);
        const double phase = (transits - 1) * theta - (M - 1) * d;
        return {quotient * std::sin(phase), quotient * std::cos(phase)};
    }
    const double phase = (transits - M) * theta;
    if (sign_of(M) > 0) {
        const double quotient = std::sin(M * theta) / std::cos(theta);
        return {quotient * std::cos(phase), -quotient * std::sin(phase)};
    }
    const double quotient = std::cos(M * theta) / std::cos(theta);
    return {quotient * std::sin(phase), quotient * std::cos(phase)};
}

Fields SineLoad::standing(const Sums& sums, double a, double b) const {
    const double phase = k_ * ((a + b) / 2);
    const double weight = 2 * e_ * boost::math::sinc_pi(k_ * (b - a) / 2);
    return {weight * sums.sine * std::sin(phase) / k_, weight * sums.cosine * c_ * std::sin(phase),
            weight * sums.sine * std::cos(phase)};
}

Fields SineLoad::last_image(double a, double b) const {
    const double middle = (a + b) / 2;
    const double half = k_ * (b - a) / 2;
    const double phase = k_ * (way_.outward() ? (middle - L_) + L_ * way_.part : middle + L_ * way_.part);
    const double sine = std::sin(phase) * boost::math::sinc_pi(half);
    const double half_sine = std::sin(phase / 2);
    const double bulge = 2 * half_sine * half_sine + std::cos(phase) * one_minus_sinc(half);
    return {sign_ * e_ * bulge / k_, sign_ * e_ * c_ * sine, sign_ * e_ * sine};
}

Fields SineLoad::mean(double a, double b) const {
    return mean_in_parts(a, b, front_, [&](double low, double high) {
        if ((low + high) / 2 >= front_) return standing(right_, low, high) + last_image(low, high);
        return standing(left_, low, high);
    });
}

}  // namespace ordo::oracles::bars
