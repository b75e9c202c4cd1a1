// The blast as the catalogue knows it: what is declared, and how the numbers are filled in.
#include <array>
#include <limits>

#include "oracles/blasts/sedov.hpp"
#include "oracles/features.hpp"

namespace ordo::oracles {
namespace {

const std::vector<FieldInfo> gas_fields{
    {"velocity", "m/s", 1}, {"density", "kg/m^3", 0}, {"pressure", "Pa", 0}, {"energy", "J/kg", 0}};

Sedov given_by(const Values& values) {
    const auto& word = values.word("geometry");
    return {.geometry = word == "planar"        ? Sedov::Geometry::planar
                        : word == "cylindrical" ? Sedov::Geometry::cylindrical
                                                : Sedov::Geometry::spherical,
            .gamma = values.number("gamma"),
            .omega = values.number("omega"),
            .energy = values.number("energy"),
            .rho0 = values.number("rho0")};
}

Constants constants_of(const SedovBlast& blast, std::optional<double> t) {
    constexpr std::array kinds{"standard", "singular", "vacuum"};
    const auto kind = blast.profiles().kind();
    const auto& [J1, J2, alpha] = blast.integrals();
    Constants constants{
        {"kind", std::string(kinds[static_cast<std::size_t>(kind)])}, {"alpha", alpha}, {"J1", J1}, {"J2", J2}};
    if (!t) return constants;
    const auto [r, speed, core, behind] = blast.front(*t);
    constants.insert(constants.end(), {{"r_shock", r},
                                       {"shock_speed", speed},
                                       {"v_post", behind.velocity},
                                       {"rho_post", behind.density},
                                       {"p_post", behind.pressure},
                                       {"e_post", behind.energy}});
    if (kind == BlastKind::vacuum) constants.push_back({"r_vacuum", core});
    return constants;
}

std::vector<double> jumps_of(const SedovBlast& blast, double t) {
    const auto front = blast.front(t);
    if (blast.profiles().kind() == BlastKind::vacuum) return {front.core, front.r};
    return {front.r};
}

/// The shock, and the core's edge, where gas touches nothing.
std::vector<Wave> waves_of(const SedovBlast& blast, double t) {
    const auto front = blast.front(t);
    std::vector<Wave> waves;
    if (blast.profiles().kind() == BlastKind::vacuum) waves.push_back({Wave::Kind::contact, front.core, front.core});
    waves.push_back({Wave::Kind::shock, front.r, front.r});
    return waves;
}

void sample(const SedovBlast& blast, std::span<const double> x, double t, std::span<double> values) {
    const auto front = blast.front(t);
    auto out = values.begin();
    for (const double r : x) {
        const auto [velocity, density, pressure, energy] = blast.at(r, front);
        for (const double value : {velocity, density, pressure, energy}) *out++ = value;
    }
}

Exact bind(const Values& values) {
    const SedovBlast blast(given_by(values));
    Exact exact{.dim = 1,
                .coordinates = Coordinates::spatial,
                .lower = {0},
                .upper = {std::numeric_limits<double>::max()},
                .times = positive,
                .fields = gas_fields,
                .sample = [blast](std::span<const double> x, double t,
                                  std::span<double> values) { sample(blast, x, t, values); },
                .jumps = [blast](double t) { return jumps_of(blast, t); },
                .waves = [blast](double t) { return waves_of(blast, t); },
                .constants = [blast](std::optional<double> t) { return constants_of(blast, t); }};
    // Behind the shock fields are powers of r; of an empty core the edge is singular, and told among the waves.
    exact.features = with_singular_centre(features_of_waves(exact), blast.profiles().kind() != BlastKind::vacuum);
    return exact;
}

const std::string explanation =
    "Euler equations of an ideal gas, p = (gamma - 1) rho e, energy e per mass. Ahead: u = 0, p = 0, rho = rho0 "
    "r^-omega.\n"
    "At t = 0 `energy` is released at r = 0: at a point (spherical, j = 3) [J], on a line (cylindrical, j = 2) [J/m] "
    "or\n"
    "in a plane (planar, j = 1) [J/m^2]. Planar energy counts ONE side; a blast to both sides takes twice as much.\n"
    "  r_shock = (energy t^2 / (alpha rho0))^(1/n),  n = j + 2 - omega,  speed U = 2 r_shock / (n t)\n"
    "  behind it u2 = 2 U / (gamma + 1), rho2 = rho0 r_shock^-omega (gamma + 1) / (gamma - 1),\n"
    "            p2 = 2 rho0 r_shock^-omega U^2 / (gamma + 1);  u / u2, rho / rho2, p / p2 are functions of r / "
    "r_shock\n"
    "x is the distance r >= 0 from the centre, axis or plane in space; u is positive outwards; t > 0.\n"
    "kind: standard (gas down to the centre), singular (u = (r / r_shock) u2) or vacuum (an empty core r < r_vacuum), "
    "for\n"
    "omega below, at or above (3j - 2 + gamma (2 - j)) / (gamma + 1). One closed form serves them all; nothing happens "
    "at\n"
    "omega = j (2 - gamma) or (2 (gamma - 1) + j) / gamma, where the textbook's exponents are infinite.\n"
    "At the shock the state ahead of it holds. In the core density and pressure are 0, velocity and energy have no "
    "value;\n"
    "neither has, at r = 0 or at the core's edge, a density or energy that grows there without limit.\n"
    "Refused: omega >= j, since every neighbourhood of r = 0 would hold infinite mass. No cell averages: of the "
    "fields\n"
    "only the mass has a closed integral (SedovBlast::mass).\n"
    "constants: kind, alpha, J1, J2 (alpha = J1 / 2 + J2 / (gamma - 1), planar; (j - 1) pi (J1 + 2 J2 / (gamma - 1))\n"
    "otherwise), and with t: r_shock, shock_speed, v_post, rho_post, p_post, e_post (behind the shock), r_vacuum";

}  // namespace

Oracle sedov() {
    return {.name = "sedov",
            .about = "Sedov-Taylor blast, planar, cylindrical or spherical, in a gas of density rho0 r^-omega",
            .source = {"Sedov1959", "KammTimmes2007"},
            .explanation = explanation,
            .example = "sedov --set geometry=spherical --set gamma=1.4 --t 1 --grid 0:1.2:101",
            .parameters = {word("geometry", "spherical",
                                {{"planar", "from a plane, j = 1; energy of one side"},
                                 {"cylindrical", "from a line, j = 2"},
                                 {"spherical", "from a point, j = 3"}},
                                "where the energy is released"),
                           number("gamma", "-", 1.4, {.low = 1, .low_excluded = true}, "ratio of the specific heats"),
                           number("omega", "-", 0, finite, "the density ahead is rho0 r^-omega; omega < j"),
                           number("energy", "J/m^(3-j)", 0.851072, positive, "released at t = 0; planar: to one side"),
                           number("rho0", "kg/m^(3-omega)", 1, positive, "density ahead, where r = 1 m")},
            .fields = gas_fields,
            .smoothness = "a shock at r_shock, a core's edge at r_vacuum; analytic between; powers of r at the centre",
            .accuracy = "alpha 1e-14; fields 1e-13 times how much they magnify a relative error of x, gamma or omega",
            .bind = bind};
}

}  // namespace ordo::oracles
