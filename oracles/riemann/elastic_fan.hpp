#pragma once
// Rarefactions of elastic materials: T is constant, and v -+ integral of a d ln lambda is too.
#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <vector>

#include "oracles/riemann/elastic_material.hpp"

namespace ordo::oracles::elastic {

/// What a wave runs into, but for its velocity.
struct Origin {
    Stretch stretch;
    double T;
};

/// The origin stretched by the factor e^h.
inline Stretch stretched(const Origin& origin, double h) {
    return {origin.stretch.lambda * std::exp(h), origin.stretch.log + h};
}

/// Integral of the sound speed a dh over [from, to] by Gauss-Legendre, to round-off: with the half-width of a panel at
/// 1/8 (7 nodes) or 1/2 (15 nodes) of the distance to the nearest singularity, the error is below 1e-16 of it.
template <class M>
double speed_integral(const M& material, const Origin& origin, double from, double to) {
    using boost::math::quadrature::gauss;
    const auto a = [&](double h) {
        const Stretch s = stretched(origin, h);
        return material.sound_speed(s, material.at(s, origin.T));
    };
    const double strip = material.analytic_strip();
    if (std::abs(to - from) <= 0.25 * strip) return gauss<double, 7>::integrate(a, from, to);
    const int panels = static_cast<int>(std::ceil(std::abs(to - from) / strip));
    const double width = (to - from) / panels;
    double sum = 0;
    for (int i = 0; i < panels; ++i) sum += gauss<double, 15>::integrate(a, from + i * width, from + (i + 1) * width);
    return sum;
}

/// A rarefaction fan, which stretches its origin by e^h, 0 <= h <= reach, at the speeds eta(h) in space, relative to
/// the origin's velocity and the same for both sides: eta = xi - v_L in a left fan, v_R - xi in a right one;
///   eta = integral_0^h a dh' - a(h),  rising from -a(0).
template <class M>
class Fan {
public:
    Fan(const M& material, const Origin& origin, double reach)
        : material_(material), origin_(origin), short_way_(material.analytic_strip() / 1000) {
        const int panels = std::max(1, static_cast<int>(std::ceil(4 * reach / material.analytic_strip())));
        knots_.reserve(static_cast<std::size_t>(panels) + 1);
        knots_.push_back(knot(0, 0));
        for (int i = 1; i <= panels; ++i) knots_.push_back(moved(knots_.back(), reach * i / panels));
    }

    double tail() const { return knots_.back().eta; }

    /// eta and d eta / dh at h.
    struct Place {
        double eta, spread;
    };
    Place at(double h) const {
        const auto right = std::upper_bound(knots_.begin() + 1, knots_.end() - 1, h,
                                            [](double value, const Knot& knot) { return value < knot.h; });
        const Knot knot = moved(*(right - 1), h);
        return {knot.eta, knot.spread};
    }

    /// h at eta, by Newton's method from a cubic between the two nearest knots; the integral is carried along.
    double stretch(double eta) const {
        const auto right = std::upper_bound(knots_.begin() + 1, knots_.end() - 1, eta,
                                            [](double value, const Knot& knot) { return value < knot.eta; });
        const Knot& left = *(right - 1);
        Knot at = left;
        double h = first_guess(left, *right, eta);
        for (int i = 0; i < most_steps; ++i) {
            at = moved(at, h);
            const double step = (eta - at.eta) / at.spread;
            h = std::clamp(h + step, left.h, right->h);
            if (std::abs(step) <= converged) break;
        }
        return h;
    }

private:
    struct Knot {
        double h, integral, a, eta, spread;  ///< spread = d eta / dh = a - da/dh
    };
    static constexpr int most_steps = 20;
    static constexpr double converged = 1e-8;  ///< of h; the next step of a quadratic iteration is below round-off

    Knot knot(double h, double integral) const {
        const Stretch s = stretched(origin_, h);
        const Jet jet = material_.at(s, origin_.T);
        const double a = material_.sound_speed(s, jet);
        return {h, integral, a, integral - a, material_.fan_spread(s, jet, a)};
    }

    /// The same at another h. A short integral is the trapezoid's with its first correction, to 1e-14 of it.
    Knot moved(const Knot& from, double h) const {
        const double way = h - from.h;
        if (std::abs(way) > short_way_) return knot(h, from.integral + speed_integral(material_, origin_, from.h, h));
        Knot to = knot(h, from.integral);
        const double slopes = (from.a - from.spread) - (to.a - to.spread);
        const double integral = way * (0.5 * (from.a + to.a) + way / 12 * slopes);
        to.integral += integral;
        to.eta += integral;
        return to;
    }

    /// Hermite's cubic for h(eta), exact in value and slope at both knots.
    static double first_guess(const Knot& left, const Knot& right, double eta) {
        const double width = right.eta - left.eta;
        if (!(width > 0)) return left.h;
        const double s = (eta - left.eta) / width;
        const double r = 1 - s;
        const double guess =
            left.h + (right.h - left.h) * s * s * (1 + 2 * r) + width * s * r * (r / left.spread - s / right.spread);
        return std::clamp(guess, left.h, right.h);
    }

    M material_;
    Origin origin_;
    double short_way_;  ///< of h
    std::vector<Knot> knots_;
};

}  // namespace ordo::oracles::elastic
