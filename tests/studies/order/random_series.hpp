#pragma once
// Synthetic convergence series, seeded and stratified: what an order estimator must be right on.
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "studies/order/order_fit.hpp"

namespace ordo::series {

/// (a) A h^p; (b) A h^p + f; (c) A h^p + B h^q, B of either sign; (d) what does not converge.
enum class Kind { power, floor, second_power, non_converging };

struct Series {
    std::vector<studies::FitPoint> points;
    double order = std::numeric_limits<double>::quiet_NaN();  ///< NaN where there is none
    std::string shape;
};

/// The strata, over place i of a list: levels 4 .. 10 in turn, every third batch of seven with uneven ratios; drawn at
/// random: mean ratio 1.2 .. 4 and log-normal noise 1e-3 .. 0.1 (uniform in the logarithm), order 0.5 .. 4, q - p
/// 0.5 .. 3. Where two terms are equal is drawn in levels from the finest, over the whole window and beyond:
///   floor          from two levels below the finest to the coarsest point
///   second power   B > 0: from the second finest to two levels above the coarsest; B < 0: 0.3 to 3 levels above it
///   non_converging one fifth each: constant; growing; falling, then growing; |A h^p - B h^q| that changes its sign
///                  within two levels of the finest; a floor from the second coarsest point on
class Draw {
public:
    explicit Draw(std::uint64_t seed) : random_(seed) {}

    Series next(Kind kind, int place) {
        const int levels = 4 + place % 7;
        const bool uneven = place / 7 % 3 == 0;
        const double step = between(std::log(1.2), std::log(4.0));
        const double noise = std::exp(between(std::log(1e-3), std::log(0.1)));
        const double order = between(0.5, 4);
        const double size = std::exp(between(-5, 5));
        std::vector<double> x{0};
        for (int k = 1; k < levels; ++k) x.push_back(x.back() + step * (uneven ? between(0.7, 1.3) : 1));
        Series series{.points = {}, .order = order, .shape = "power"};
        const Terms terms = terms_of(kind, series, x.back(), levels);
        for (auto at = x.rbegin(); at != x.rend(); ++at)
            series.points.push_back({1e-3 * std::exp(*at), size * terms.error(*at) * std::exp(noise * normal())});
        return series;
    }

private:
    /// e(x) = |e^(p x) + f + b e^(q x)|, x = ln(h / finest h)
    struct Terms {
        double p = 0, f = 0, b = 0, q = 0;

        double error(double x) const { return std::abs(std::exp(p * x) + f + (b == 0 ? 0 : b * std::exp(q * x))); }
    };

    double between(double low, double high) {
        return low + (high - low) * (static_cast<double>(random_() >> 11) * 0x1p-53);
    }
    double normal() {
        const double radius = std::sqrt(-2 * std::log(between(1e-300, 1)));
        return radius * std::cos(2 * std::numbers::pi * between(0, 1));
    }

    Terms terms_of(Kind kind, Series& series, double length, int levels) {
        Terms terms{.p = series.order};
        const double coarsest = levels - 1;
        const double level = length / coarsest;
        const auto second = [&](double sign, double from, double to) {
            terms.q = terms.p + between(0.5, 3);
            terms.b = sign * std::exp((terms.p - terms.q) * between(from, to) * level);
        };
        const auto floor = [&](double from, double to) { terms.f = std::exp(terms.p * between(from, to) * level); };
        if (kind == Kind::floor) floor(-2, coarsest);
        if (kind == Kind::second_power) {
            if (random_() % 2 == 0) second(1, 1, coarsest + 2);
            else second(-1, coarsest + 0.3, coarsest + 3);
        }
        if (kind == Kind::non_converging) spoil(terms, series, level, coarsest, second, floor);
        return terms;
    }

    template <class Second, class Floor>
    void spoil(Terms& terms, Series& series, double level, double coarsest, Second second, Floor floor) {
        static const std::vector<std::string> shapes{"constant", "growing", "turning", "sign change", "early floor"};
        const auto shape = random_() % 5;
        series.order = std::numeric_limits<double>::quiet_NaN();
        series.shape = shapes[shape];
        if (shape == 0) terms.p = 0;
        if (shape == 1) terms.p = -between(0.2, 2);
        if (shape == 2) {
            terms.q = -between(0.3, 2);
            terms.b = std::exp((terms.p - terms.q) * between(0.5, coarsest - 0.5) * level);
        }
        if (shape == 3) second(-1, 0, 2);
        if (shape == 4) floor(coarsest - 1, coarsest);
    }

    std::mt19937_64 random_;
};

}  // namespace ordo::series
