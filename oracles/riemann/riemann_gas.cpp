#include "oracles/riemann/riemann_gas.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "core/text.hpp"

namespace ordo::oracles {
namespace {

constexpr double furthest = std::numeric_limits<double>::max();  // of the border of an empty side

enum Region { left_gas, left_fan, left_star, cavity, right_star, right_fan, right_gas };

[[noreturn]] void refuse(const std::string& problem) { throw InputError("oracle riemann_gas", problem); }

std::string named(const std::string& symbol, const std::string& side, double value) {
    return symbol + "_" + side + " = " + shortest(value);
}

void require(const Gas& gas, const std::string& side) {
    for (const double value : {gas.rho, gas.v, gas.p, gas.gamma, gas.p_inf}) {
        if (!std::isfinite(value)) refuse("the state " + side + " holds " + shortest(value) + ", but must be finite");
    }
    if (gas.rho < 0) refuse(named("rho", side, gas.rho) + " kg/m^3, but a density is >= 0 (0: vacuum)");
    if (!(gas.gamma > 1)) refuse(named("gamma", side, gas.gamma) + ", but must be > 1");
    if (gas.p_inf < 0) refuse(named("p_inf", side, gas.p_inf) + " Pa, but must be >= 0 (0: ideal gas)");
    if (!(gas.p + gas.p_inf >= 0))
        refuse(named("p", side, gas.p) + " Pa, but p + p_inf must be >= 0: the least is " + shortest(0 - gas.p_inf));
    if (gas.rho == 0 && gas.p != 0 && gas.p != -gas.p_inf)
        refuse(named("p", side, gas.p) + " Pa where rho_" + side + " = 0, but a vacuum has no pressure: give p_" +
               side + " = 0");
}

/// A vacuum of the pressure p beside a gas that comes apart at a higher one, or beside another vacuum.
void require_vacuum(const Gas& empty, const Gas& other, const std::string& side) {
    const double least = other.rho == 0 ? other.p : -other.p_inf;
    if (empty.rho == 0 && empty.p < least)
        refuse(named("p", side, empty.p) + " Pa in a vacuum, but the gas beside it comes apart at " + shortest(least) +
               " Pa: give p_" + side + " = " + shortest(least));
}

GasFields data_fields(const GasSide& side) { return side.empty() ? nothing(side.gas.p) : fields_of(side.gas, side.P); }

GasFields star_fields(const GasSide& side, const GasSide::Behind& star, double p, double v) {
    Gas gas = side.gas;
    gas.rho = star.rho;
    gas.v = v;
    gas.p = p;
    GasFields fields = fields_of(gas, star.P);
    if (star.d < 0) {  // as inside the fan
        fields.energy = side.P / side.gas.rho * star.c * star.c / (gas.gamma - 1);
        if (gas.p_inf > 0) fields.energy += gas.p_inf / gas.rho;
    }
    return fields;
}

/// How fast the head, the tail and the inner edge of one gas move outwards, relative to the gas ahead.
std::array<double, 3> outwards(const GasSide& side, const GasSide::Behind& star) {
    if (side.empty()) return {furthest, furthest, furthest};
    const double edge = star.f;
    if (star.d > 0) {
        const double shock = std::max(side.shock_speed(star.d), edge);
        return {shock, shock, edge};
    }
    const double tail = std::min(side.a, star.a + edge);
    return {side.a, tail, std::min(tail, edge)};
}

}  // namespace

RiemannGas::RiemannGas(const Gas& left, const Gas& right, double x0) : left_(left), right_(right), x0_(x0) {
    require(left, "L");
    require(right, "R");
    require_vacuum(left, right, "L");
    require_vacuum(right, left, "R");
    star_ = star_between(left_, right_);
    const auto l = outwards(left_, star_.left), r = outwards(right_, star_.right);
    const auto [v_L, v_R] = std::array{left_.empty() ? 0 : left.v, right_.empty() ? 0 : right.v};
    speeds_ = {v_L - l[0], v_L - l[1], v_L - l[2], v_R + r[2], v_R + r[1], v_R + r[0]};
    if (!star_.vacuum) speeds_[2] = speeds_[3] = star_.v;
    // What round-off has put out of order.
    speeds_[1] = std::min(speeds_[1], speeds_[2]);
    speeds_[0] = std::min(speeds_[0], speeds_[1]);
    speeds_[4] = std::max(speeds_[4], speeds_[3]);
    speeds_[5] = std::max(speeds_[5], speeds_[4]);
    const auto none = nothing(star_.p);
    fields_ = {data_fields(left_), none, none, none, none, none, data_fields(right_)};
    if (!left_.empty()) fields_[left_star] = star_fields(left_, star_.left, star_.p, speeds_[2]);
    if (!right_.empty()) fields_[right_star] = star_fields(right_, star_.right, star_.p, speeds_[3]);
    require_finite();
}

void RiemannGas::require_finite() const {
    const auto sound = [](const GasFields& fields) {
        const auto row = fields.row();
        return std::all_of(row.begin(), row.end(), [](double value) { return std::isfinite(value); });
    };
    const auto wide = [&](std::size_t border) { return speeds_[border + 1] > speeds_[border]; };
    const bool all = (left_.empty() || sound(fields_[left_gas])) && (right_.empty() || sound(fields_[right_gas])) &&
                     (left_.empty() || !wide(1) || sound(fields_[left_star])) &&
                     (right_.empty() || !wide(3) || sound(fields_[right_star])) && std::isfinite(star_.p) &&
                     std::all_of(speeds_.begin(), speeds_.end(), [](double speed) { return std::isfinite(speed); });
    if (!all) refuse("a state of this solution is beyond 1.8e308; rescale the units of mass, length or time");
}

double RiemannGas::position(double speed, double t) const { return x0_ + speed * t; }

std::array<double, RiemannGas::regions - 1> RiemannGas::positions(double t) const {
    auto borders = speeds_;
    for (double& border : borders) border = position(border, t);
    return borders;
}

GasFields RiemannGas::at(double x, double t) const {
    int region = 0;
    for (const double border : positions(t)) region += x >= border;
    if (region == left_fan) return GasFan{left_, 1, star_.left.c}.at(left_depth(x, t));
    if (region == right_fan) return GasFan{right_, -1, star_.right.c}.at(right_depth(x, t));
    return fields_[static_cast<std::size_t>(region)];
}

double RiemannGas::left_depth(double x, double t) const {
    return std::clamp((x - x0_) / t - speeds_[0], 0.0, speeds_[1] - speeds_[0]);
}
double RiemannGas::right_depth(double x, double t) const {
    return std::clamp(speeds_[5] - (x - x0_) / t, 0.0, speeds_[5] - speeds_[4]);
}

GasFields RiemannGas::mean_within(int region, double a, double b, double t) const {
    if (region == left_fan) return GasFan{left_, 1, star_.left.c}.mean(left_depth(a, t), left_depth(b, t));
    if (region == right_fan) return GasFan{right_, -1, star_.right.c}.mean(right_depth(b, t), right_depth(a, t));
    return fields_[static_cast<std::size_t>(region)];
}

GasFields RiemannGas::mean(double a, double b, double t) const {
    if (!(a < b)) return at(a, t);
    const auto borders = positions(t);
    GasFields sum{};
    double from = a;
    for (int region = 0; region < regions; ++region) {
        const double to = region < regions - 1 ? std::min(b, borders[static_cast<std::size_t>(region)]) : b;
        if (!(to > from)) continue;
        const double share = (to - from) / (b - a);
        const GasFields part = mean_within(region, from, to, t);
        if (share == 1) return part;
        sum.add(share, part);
        from = to;
    }
    return sum;
}

std::vector<GasWave> RiemannGas::waves() const {
    using enum GasWave::Kind;
    using enum GasWave::Side;
    std::vector<GasWave> list;
    const auto outer = [&](const GasSide::Behind& star, GasWave::Side side, double head, double tail) {
        if (star.d != 0) list.push_back({star.d > 0 ? shock : rarefaction, side, head, tail});
    };
    outer(star_.left, left, speeds_[0], speeds_[1]);
    if (!star_.vacuum) list.push_back({contact, middle, star_.v, star_.v});
    else if (!left_.empty() && !right_.empty()) list.push_back({vacuum, middle, speeds_[2], speeds_[3]});
    else if (!right_.empty()) list.push_back({vacuum, left, speeds_[3], speeds_[3]});
    else if (!left_.empty()) list.push_back({vacuum, right, speeds_[2], speeds_[2]});
    outer(star_.right, right, speeds_[5], speeds_[4]);
    return list;
}

std::vector<double> RiemannGas::jumps(double t) const {
    const auto differ = [](const GasFields& a, const GasFields& b) {
        return a.density != b.density || (a.density > 0 && !(a == b));
    };
    if (t == 0) return differ(fields_[left_gas], fields_[right_gas]) ? std::vector{x0_} : std::vector<double>{};
    std::vector<double> places;
    const auto add = [&](bool there, std::size_t border) {
        if (there) places.push_back(position(speeds_[border], t));
    };
    add(star_.left.d > 0, 0);
    if (star_.vacuum) {
        add(star_.left.rho > 0, 2);
        add(star_.right.rho > 0, 3);
    } else {
        add(differ(fields_[left_star], fields_[right_star]), 2);
    }
    add(star_.right.d > 0, 5);
    return places;
}

}  // namespace ordo::oracles
