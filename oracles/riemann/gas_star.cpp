#include "oracles/riemann/gas_star.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "oracles/numerics/newton.hpp"

namespace ordo::oracles {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double smallest = std::numeric_limits<double>::min();
constexpr double half_ulp = 0.5 * std::numeric_limits<double>::epsilon();

/// One gas behind its wave to the pressure p; against its own lowest one nothing is left of a warm gas.
GasSide::Behind behind(const GasSide& side, double p) {
    const double d = p - side.gas.p;
    return d >= 0 ? side.behind_shock(d) : side.behind_fan(side.log_ratio(d, p + side.gas.p_inf));
}

/// One velocity from those of two sides of a contact. What round-off has left of F is shared as a pressure between them
/// would share it: the larger impedance Z = rho a moves less.
double shared(double v_L, double Z_L, double v_R, double Z_R) {
    if (Z_L > Z_R) return v_L + Z_R / (Z_L + Z_R) * (v_R - v_L);
    if (Z_R > Z_L) return v_R + Z_L / (Z_L + Z_R) * (v_L - v_R);
    return 0.5 * v_L + 0.5 * v_R;
}

/// A Riemann problem of two gases that are both there, by pressure instead of by side.
class Problem {
public:
    Problem(const GasSide& left, const GasSide& right)
        : left_(left),
          right_(right),
          low_(left.gas.p <= right.gas.p ? left : right),
          high_(left.gas.p <= right.gas.p ? right : left),
          dv_(right.gas.v - left.gas.v),
          p_inf_(std::min(left.gas.p_inf, right.gas.p_inf)) {}

    GasStar solve() const;

private:
    /// Both waves to the pressure base + x.
    ValueAndSlope waves(double base, double x) const {
        const auto to = [&](const GasSide& side) {
            return side.wave((base - side.gas.p) + x, (base + side.gas.p_inf) + x);
        };
        const auto a = to(low_), b = to(high_);
        return {(a.f + b.f) + dv_, a.slope + b.slope};
    }
    GasStar parted() const;
    GasStar two_fans(const ValueAndSlope& at_low, double F_lowest) const;
    GasStar two_shocks(const ValueAndSlope& at_high) const;
    GasStar shock_and_fan(double floor, const ValueAndSlope& at_floor, const ValueAndSlope& at_high) const;
    GasStar joined(double p, const GasSide::Behind& of_low, const GasSide::Behind& of_high) const;
    double log_ratio_of(const GasSide& side, double s) const;

    const GasSide &left_, &right_, &low_, &high_;
    double dv_;     // v_R - v_L
    double p_inf_;  // of the gas that is first to come apart
};

GasStar Problem::solve() const {
    const ValueAndSlope at_high = waves(high_.gas.p, 0);
    if (at_high.value <= 0) return two_shocks(at_high);
    const double floor = std::max(low_.gas.p, -p_inf_);
    const ValueAndSlope at_floor = waves(floor, 0);
    if (at_floor.value <= 0) return shock_and_fan(floor, at_floor, at_high);
    if (floor == -p_inf_) return parted();
    const double F_lowest = (behind(left_, -p_inf_).f + behind(right_, -p_inf_).f) + dv_;
    return F_lowest < 0 ? two_fans(at_floor, F_lowest) : parted();
}

GasStar Problem::joined(double p, const GasSide::Behind& of_low, const GasSide::Behind& of_high) const {
    const bool left_is_low = &low_ == &left_;
    GasStar star{.p = p, .left = left_is_low ? of_low : of_high, .right = left_is_low ? of_high : of_low};
    star.v = shared(left_.gas.v - star.left.f, star.left.rho * star.left.a, right_.gas.v + star.right.f,
                    star.right.rho * star.right.a);
    return star;
}

GasStar Problem::parted() const {
    return {.vacuum = true, .p = 0 - p_inf_, .left = behind(left_, -p_inf_), .right = behind(right_, -p_inf_)};
}

/// x >= 0 above the higher pressure. One shock alone has d = f (g f + sqrt(g^2 f^2 + 4 Z^2)) / 2 with Z = rho a and
/// g = (gamma + 1) rho / 2; two are near it with 1/Z and 1/sqrt(g) added up.
GasStar Problem::two_shocks(const ValueAndSlope& at_high) const {
    const double base = high_.gas.p;
    const double closing = -at_high.value;
    const auto strong = [](const GasSide& side) { return 1 / (std::sqrt(0.5 * (side.gas.gamma + 1)) * side.root_rho); };
    const double root_g = 1 / (strong(low_) + strong(high_));
    const double by_strength = root_g * root_g * closing;
    const double start = 0.5 * closing * (by_strength + std::hypot(by_strength, 2 / at_high.slope));
    const auto F = [&](double rise) { return waves(base, rise); };
    const double x = start > 0 ? newton_root(F, 0, infinity, start, half_ulp * std::abs(dv_)) : 0;
    return joined(base + x, low_.behind_shock((base - low_.gas.p) + x), high_.behind_shock(x));
}

/// x above `floor`, below the higher pressure.
GasStar Problem::shock_and_fan(double floor, const ValueAndSlope& at_floor, const ValueAndSlope& at_high) const {
    const double range = high_.gas.p - floor;
    // Neither wave's f passes its value at its own end of the range, and they differ by dv.
    const double largest = std::min(std::abs(at_floor.value - dv_), std::abs(at_high.value - dv_)) + std::abs(dv_);
    const double noise = half_ulp * largest;
    const auto F = [&](double x) { return waves(floor, x); };
    // Down from the higher pressure along the power law of P = p + p_inf that has F's value, slope and curvature there.
    const double P_high = high_.gas.p + p_inf_;
    const double step = at_high.value / (at_high.slope * P_high);
    const double power =
        1 + P_high * (low_.curvature(range + (floor - low_.gas.p)) + high_.curvature(0)) / at_high.slope;
    const double fall = step * power < 1 ? std::log1p(-step * power) / power : -step;
    const double start = range + P_high * std::expm1(fall);
    // From a floor of no pressure the root may lie below all doubles: the shock is then none, and the fan all there is.
    const bool cold = floor == -p_inf_;
    const bool unseen = cold && F(smallest).value >= 0;
    // F is concave: its tangent at the floor meets zero before the root.
    const double least = cold ? smallest : -at_floor.value / at_floor.slope;
    const double x = unseen ? 0 : newton_root(F, std::min(least, range), range, start, noise);
    const auto shocked = low_.behind_shock((floor - low_.gas.p) + x);
    const double P_star = (floor + high_.gas.p_inf) + x;
    const double s = P_star >= smallest ? high_.log_ratio(x - range, P_star)
                                        : std::log1p(-(dv_ + shocked.f) / (high_.n * high_.a)) / high_.m;
    return joined(floor + x, shocked, high_.behind_fan(s));
}

/// ln(P* / P) of one gas when the lower pressure falls by exp(s), P counted with the smaller p_inf.
double Problem::log_ratio_of(const GasSide& side, double s) const {
    const double floor = low_.gas.p + p_inf_;
    if (side.gas.p_inf == p_inf_) return side.log_ratio(low_.gas.p - side.gas.p, floor) + s;
    return side.log_ratio((low_.gas.p - side.gas.p) + floor * std::expm1(s),
                          floor * std::exp(s) + (side.gas.p_inf - p_inf_));
}

/// s = ln(P* / P) from the lower pressure down, P counted with the smaller p_inf. How far F is above its lowest value
/// goes like exp(m s) in one kind of gas, and nearly so in two.
GasStar Problem::two_fans(const ValueAndSlope& at_low, double F_lowest) const {
    const double P = low_.gas.p + p_inf_;
    const double height = at_low.value - F_lowest;
    const bool one_gas = low_.gas.gamma == high_.gas.gamma && low_.gas.p_inf == high_.gas.p_inf;
    const double m = one_gas ? low_.m : P * at_low.slope / height;
    const double gone = at_low.value / height;
    double s = (gone < 0.5 ? std::log1p(-gone) : std::log(-F_lowest / height)) / m;
    if (!one_gas) {
        const auto F = [&](double s) {
            const auto of = [&](const GasSide& side) {
                const double r = log_ratio_of(side, s);
                auto fan = side.fan(r);
                if (side.gas.p_inf != p_inf_) fan.slope *= P * std::exp(s - r) / side.P;  // dr/ds
                return fan;
            };
            const auto a = of(low_), b = of(high_);
            return ValueAndSlope{(a.f + b.f) + dv_, a.slope + b.slope};
        };
        s = newton_root(F, -infinity, 0, s, half_ulp * std::abs(dv_), 1e-11);
    }
    // Whichever keeps the digits of p*, which may be small beside p or beside p_inf.
    const double p = s > -0.5 ? low_.gas.p + P * std::expm1(s) : P * std::exp(s) - p_inf_;
    return joined(p, low_.behind_fan(log_ratio_of(low_, s)), high_.behind_fan(log_ratio_of(high_, s)));
}

}  // namespace

GasStar star_between(const GasSide& left, const GasSide& right) {
    if (!left.empty() && !right.empty()) return Problem(left, right).solve();
    GasStar star{.vacuum = true, .p = left.empty() ? left.gas.p : right.gas.p};
    if (!left.empty()) star.left = behind(left, star.p);
    if (!right.empty()) star.right = behind(right, star.p);
    return star;
}

}  // namespace ordo::oracles
