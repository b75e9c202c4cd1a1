#include "oracles/blasts/noh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "core/text.hpp"

namespace ordo::oracles {
namespace {

const std::vector<FieldInfo> gas_fields{
    {"velocity", "m/s", 1}, {"density", "kg/m^3", 0}, {"pressure", "Pa", 0}, {"energy", "J/kg", 0}};

double power(double base, int exponent) {
    double product = 1;
    for (int k = 0; k < exponent; ++k) product *= base;
    return product;
}

/// (b^j - a^j) / (b - a), which does not cancel where a is near b.
double divided_difference(double a, double b, int j) { return j == 1 ? 1 : j == 2 ? a + b : a * a + a * b + b * b; }

std::array<double, 4> row(const Noh::State& state) {
    return {state.velocity, state.density, state.pressure, state.energy};
}

Constants constants_of(const Noh& gas, std::optional<double> t) {
    const auto inside = gas.post_shock();
    Constants constants{{"shock_speed", gas.shock_speed()},
                        {"rho_post", inside.density},
                        {"p_post", inside.pressure},
                        {"e_post", inside.energy}};
    if (t) constants.push_back({"r_shock", gas.shock_speed() * *t});
    return constants;
}

/// Every field jumps at the shock; on both sides fields are analytic.
std::vector<Feature> features_of(const Noh& gas, double t) { return {{Feature::Kind::shock, gas.shock_speed() * t}}; }

Exact bind(const Values& values) {
    const auto& word = values.word("geometry");
    const Noh gas{.geometry = word == "planar"        ? Noh::Geometry::planar
                              : word == "cylindrical" ? Noh::Geometry::cylindrical
                                                      : Noh::Geometry::spherical,
                  .gamma = values.number("gamma"),
                  .rho0 = values.number("rho0"),
                  .v0 = values.number("v0")};
    if (const auto inside = gas.post_shock(); !std::isfinite(inside.density) || !std::isfinite(inside.pressure))
        throw InputError("oracle noh", "gamma = " + shortest(gas.gamma) + ", rho0 = " + shortest(gas.rho0) +
                                           " and v0 = " + shortest(gas.v0) +
                                           " make a post-shock state beyond 1.8e308; move gamma away from 1");
    return {.dim = 1,
            .coordinates = Coordinates::spatial,
            .lower = {0},
            .upper = {std::numeric_limits<double>::max()},
            .times = between(0, 1e300 / std::max(gas.v0, gas.shock_speed())),
            .fields = gas_fields,
            .sample = along_a_line([gas](double r, double t) { return row(gas.at(r, t)); }),
            .averages = over_cells([gas](double a, double b, double t) { return row(gas.mean(a, b, t)); }),
            .jumps = [gas](double t) { return t > 0 ? std::vector{gas.shock_speed() * t} : std::vector<double>{}; },
            .features = [gas](const std::string&, double t) { return features_of(gas, t); },
            .constants = [gas](std::optional<double> t) { return constants_of(gas, t); }};
}

}  // namespace

double Noh::shock_speed() const { return 0.5 * (gamma - 1) * v0; }

Noh::State Noh::post_shock() const {
    const double rho = rho0 * power((gamma + 1) / (gamma - 1), static_cast<int>(geometry));
    const double e = 0.5 * v0 * v0;
    return {0, rho, (gamma - 1) * rho * e, e};
}

Noh::State Noh::at(double r, double t) const {
    if (t > 0 && (r < shock_speed() * t || r == 0)) return post_shock();
    // At t = 0 the data, the centre included: there v0 t / r would be 0 / 0.
    const double compression = t > 0 ? 1 + v0 * t / r : 1;
    return {-v0, rho0 * power(compression, static_cast<int>(geometry) - 1), 0, 0};
}

Noh::State Noh::mean(double a, double b, double t) const {
    const int j = static_cast<int>(geometry);
    const auto inside = post_shock();
    const double s = std::clamp(shock_speed() * t, a, b);
    // Lengths in units of b. rho r^(j-1) = rho0 (r + v0 t)^(j-1) ahead of the shock has the integral
    // rho0 (r + v0 t)^j / j.
    const double volume = (b - a) / b * divided_difference(a / b, 1, j);
    const double behind = (s - a) / b * divided_difference(a / b, s / b, j) / volume;
    const double ahead = (b - s) / b * divided_difference(s / b, 1, j) / volume;
    if (!(ahead > 0)) return inside;
    const double shift = v0 * t / b;
    const double mass = rho0 * (b - s) / b * divided_difference(s / b + shift, 1 + shift, j) / volume;
    return {-v0 * ahead, inside.density * behind + mass, inside.pressure * behind, inside.energy * behind};
}

Oracle noh() {
    return {
        .name = "noh",
        .about = "Noh's implosion: a cold gas that runs into a wall, an axis or a centre; exact for any gamma",
        .source = {"Noh1987"},
        .explanation =
            "Euler equations of an ideal gas, p = (gamma - 1) rho e, energy e per mass; at t = 0 everywhere u = -v0,\n"
            "rho = rho0, p = 0. A shock runs outwards from r = 0 at the speed S = (gamma - 1) v0 / 2.\n"
            "j = 1 planar, 2 cylindrical, 3 spherical:\n"
            "  r < S t:   u = 0,    rho = rho0 ((gamma + 1) / (gamma - 1))^j,  e = v0^2 / 2,  p = (gamma - 1) rho e\n"
            "  r >= S t:  u = -v0,  rho = rho0 (1 + v0 t / r)^(j - 1),         e = 0,         p = 0\n"
            "x is the distance r >= 0 from the wall, axis or centre in space; the velocity is positive outwards.\n"
            "At the shock the state ahead of it holds; t = 0 gives the data, at r = 0 too.\n"
            "Cell averages are means over the shell a < r < b by volume, that is with the weight r^(j - 1) dr.\n"
            "constants: shock_speed, rho_post, p_post, e_post (behind the shock), and with t: r_shock",
        .example = "noh --set geometry=spherical --t 0.6 --grid 0:1:101",
        .parameters = {word("geometry", "spherical",
                            {{"planar", "onto a wall, j = 1"},
                             {"cylindrical", "onto an axis, j = 2"},
                             {"spherical", "onto a centre, j = 3"}},
                            "what the gas runs into"),
                       number("gamma", "-", 5.0 / 3, {.low = 1, .low_excluded = true}, "ratio of the specific heats"),
                       number("rho0", "kg/m^3", 1, between(1e-100, 1e100), "density at t = 0"),
                       number("v0", "m/s", 1, between(1e-100, 1e100), "speed of the inflow, towards r = 0")},
        .fields = gas_fields,
        .smoothness = "a shock at r = (gamma - 1) v0 t / 2; analytic on both sides",
        .accuracy = "8 ulp of each value, 16 ulp of each mean; 2 ulp of the shock's place",
        .bind = bind};
}

}  // namespace ordo::oracles
