#include "oracles/riemann/riemann_linear_elastic.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "core/text.hpp"
#include "oracles/features.hpp"
#include "oracles/riemann/elastic_record.hpp"

namespace ordo::oracles {
namespace {

using elastic::Row;
using elastic::State;

const char* where = "oracle riemann_linear_elastic";

Exact bind(const Values& values) {
    const auto state = [&](const std::string& side) {
        return State{values.number("lambda_" + side), values.number("v_" + side), values.number("T_" + side)};
    };
    const RiemannLinearElastic problem(values.number("E"), values.number("rho0"), values.number("c_v"), state("L"),
                                       state("R"), values.number("x0"));
    constexpr double furthest = std::numeric_limits<double>::max();
    Exact exact{.dim = 1,
                .coordinates = Coordinates::spatial,
                .lower = {-furthest},
                .upper = {furthest},
                .fields = elastic::fields(),
                .sample = along_a_line([problem](double x, double t) { return problem.fields(x, t); }),
                .averages = over_cells([problem](double a, double b, double t) { return problem.averages(a, b, t); }),
                .jumps = [problem](double t) { return problem.jumps(t); },
                .waves = [problem](double t) { return problem.waves(t); },
                .constants = [problem](std::optional<double> t) { return problem.constants(t); }};
    exact.features = features_of_waves(exact, Feature::Kind::linear);
    return exact;
}

std::vector<Parameter> parameters() {
    return appended(elastic::state_parameters(positive),
                    {number("E", "Pa", 1, positive, "Young's modulus"),
                     number("rho0", "kg/m^3", 1, positive, "density where lambda = 1"),
                     number("c_v", "J/(m^3 K)", 1, positive, "heat capacity per reference volume"),
                     number("x0", "m", 0, finite, "where the states meet at t = 0")});
}

}  // namespace

RiemannLinearElastic::RiemannLinearElastic(double E, double rho0, double c_v, const State& left, const State& right,
                                           double x0)
    : rho0_(rho0), x0_(x0) {
    const double c0 = std::sqrt(E / rho0);
    lambda_ = 0.5 * (left.lambda + right.lambda) + 0.5 * (right.v - left.v) / c0;
    if (!(lambda_ > 0))
        throw InputError(where, "v_L - v_R = " + shortest(left.v - right.v) +
                                    " m/s crushes the material to zero length, but must be < c0 (lambda_L + "
                                    "lambda_R) = " +
                                    shortest(c0 * (left.lambda + right.lambda)) + " m/s");
    sigma_ = E * (lambda_ - 1);
    const double v = 0.5 * (left.v + right.v) + 0.5 * c0 * (right.lambda - left.lambda);
    speeds_ = {left.v - c0 * left.lambda, v, right.v + c0 * right.lambda};
    const LinearElastic material{{E}, {c_v, 0}, rho0};
    rows_ = {fields_of(material, left), fields_of(material, {lambda_, v, left.T}),
             fields_of(material, {lambda_, v, right.T}), fields_of(material, right)};
    for (const Row& row : rows_) {
        for (const double value : row) {
            if (!std::isfinite(value))
                throw InputError(where,
                                 "a field of these states leaves the numbers of a double; nearest: smaller ones");
        }
    }
}

Row RiemannLinearElastic::fields(double x, double t) const {
    std::size_t piece = 0;
    while (piece < 3 && !(x < x0_ + speeds_[piece] * t)) ++piece;
    return rows_[piece];
}

Row RiemannLinearElastic::averages(double a, double b, double t) const {
    Row sum{};
    double from = a;
    for (std::size_t piece = 0; piece < 4; ++piece) {
        const double to = piece < 3 ? std::clamp(x0_ + speeds_[piece] * t, from, b) : b;
        for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += rows_[piece][k] * ((to - from) / (b - a));
        from = to;
    }
    return sum;
}

std::vector<double> RiemannLinearElastic::jumps(double t) const {
    std::vector<double> places;
    for (std::size_t wave = 0; wave < 3; ++wave) {
        if (jumps_at(wave)) places.push_back(x0_ + speeds_[wave] * t);
    }
    return places;
}

std::vector<Wave> RiemannLinearElastic::waves(double t) const {
    constexpr std::array kinds{Wave::Kind::shock, Wave::Kind::contact, Wave::Kind::shock};
    std::vector<Wave> waves;
    for (std::size_t wave = 0; wave < 3; ++wave) {
        const double x = x0_ + speeds_[wave] * t;
        if (jumps_at(wave)) waves.push_back({kinds[wave], x, x});
    }
    return waves;
}

Constants RiemannLinearElastic::constants(std::optional<double> t) const {
    std::vector<Constants> waves;
    const std::array<const char*, 3> kinds{"acoustic", "contact", "acoustic"};
    const std::array<const char*, 3> sides{"left", "middle", "right"};
    for (std::size_t wave = 0; wave < 3; ++wave) {
        if (jumps_at(wave)) waves.push_back(elastic::wave_record(kinds[wave], sides[wave], speeds_[wave], x0_, t));
    }
    constexpr std::size_t temperature = 4;
    return {{"sigma_star", sigma_},
            {"v_star", v_star()},
            {"rho_star_L", rho0_ / lambda_},
            {"rho_star_R", rho0_ / lambda_},
            {"T_star_L", rows_[1][temperature]},
            {"T_star_R", rows_[2][temperature]},
            {"waves", waves}};
}

Oracle riemann_linear_elastic() {
    return {
        .name = "riemann_linear_elastic",
        .about = "Riemann problem of linear elasticity with heat: two acoustic jumps and a contact, in closed form",
        .source = {"Walker2017"},
        .explanation =
            "rho_t + (rho v)_x = 0,  (rho v)_t + (rho v^2 - sigma)_x = 0,  e_t + ((e - sigma) v)_x = 0\n"
            "lambda = rho0 / rho = dx/dX,  sigma = E (lambda - 1),  C = E (lambda - 1)^2 / 2 + c_v T,\n"
            "e = rho v^2 / 2 + C / lambda (per volume in space, total_energy); energy = C / rho0 (per mass)\n"
            "Two uniform states meet at x0 at t = 0. With c0 = sqrt(E / rho0), Z = sqrt(E rho0):\n"
            "  sigma* = (sigma_L + sigma_R)/2 + Z (v_R - v_L)/2,  lambda* = 1 + sigma*/E on both sides\n"
            "  v* = (v_L + v_R)/2 + (sigma_R - sigma_L)/(2 Z),  T*_L = T_L,  T*_R = T_R\n"
            "  jumps at (x - x0)/t = v_L - c0 lambda_L,  v* (T only),  v_R + c0 lambda_R\n"
            "Heat exerts no stress and nothing dissipates. Stress: tension positive. x is the position in space; at a\n"
            "jump the state on its right holds. Refused: v_L - v_R >= c0 (lambda_L + lambda_R), which would crush the\n"
            "material to zero length (the law does so with finite work), where the theory ends.\n"
            "constants: sigma_star, v_star, rho_star_L, rho_star_R, T_star_L, T_star_R, waves [{kind acoustic |\n"
            "contact, side, speed}]; with t their places too",
        .example = "riemann_linear_elastic --t 1 --grid -2:2:9",
        .parameters = parameters(),
        .fields = elastic::fields(),
        .smoothness = "uniform between its three jumps",
        .accuracy =
            "4 ulp of |v_L| + |v_R| + c0 (lambda_L + lambda_R) in velocity, of Z times that in stress; places "
            "of jumps 4 ulp of |x0| + (that) t",
        .bind = bind};
}

}  // namespace ordo::oracles
