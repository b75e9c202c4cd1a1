#include "solvers/godunov/options.hpp"

#include <array>

#include "core/error.hpp"
#include "core/text.hpp"

namespace ordo::solvers::godunov {
namespace {

using Kind = LineEnd::Kind;

/// What a word of an option stands for: the alternative of that name.
template <class Choice, std::size_t n>
Choice chosen(const std::string& word, const std::array<std::pair<const char*, Choice>, n>& choices) {
    for (const auto& [name, choice] : choices) {
        if (word == name) return choice;
    }
    throw std::logic_error("no choice is called '" + word + "'");
}

const std::array<std::pair<const char*, Limiter>, 5> limiters{{{"minmod", Minmod{}},
                                                               {"van_leer", VanLeer{}},
                                                               {"mc", MonotonizedCentral{}},
                                                               {"superbee", Superbee{}},
                                                               {"central", Central{}}}};

const std::array<std::pair<const char*, SpeedEstimate>, 4> estimates{
    {{"davis", Davis{}}, {"einfeldt", Einfeldt{}}, {"pressure", PressureBased{}}, {"acoustic", Acoustic{}}}};

bool is_gas(const Medium& medium) { return std::holds_alternative<IdealGas>(medium); }

SpeedEstimate speeds_from(const Medium& medium, const Values& values) {
    // estimates of the star pressure may be too low for HLL, whose mean must hold all waves
    const bool from_pressure = is_gas(medium) && values.word("flux") == "hllc";
    if (!values.has("speeds")) return from_pressure ? SpeedEstimate{PressureBased{}} : SpeedEstimate{Davis{}};
    if (values.word("speeds") == "pressure" && !is_gas(medium))
        throw InputError(
            "solver godunov",
            "'speeds' is \"pressure\", which estimates the shocks of an ideal gas, but the line is elastic "
            "(nearest: 'davis' or 'einfeldt')");
    return chosen(values.word("speeds"), estimates);
}

void check_end(const LineEnd& end, const LineEnd& other, const std::string& side) {
    const std::string at = "the " + side + " end ";
    if (end.kind == Kind::free)
        throw InputError("solver godunov", at +
                                               "is free and moves with the material, but the cells stand still (valid: "
                                               "reservoir, wall at rest, prescribed, periodic)");
    if (end.kind == Kind::wall && end.velocity != 0)
        throw InputError("solver godunov", at + "is a wall that moves with " + shortest(end.velocity) +
                                               " m/s, but the cells stand still (nearest: a wall at rest)");
    if (end.kind == Kind::periodic && other.kind != Kind::periodic)
        throw InputError("solver godunov", at + "is periodic and the other is not: both must be");
}

void check_contents(const Medium& medium, const Contents& q, const std::string& whose) {
    const Flow f = std::visit([&](const auto& kind) { return kind.flow(q); }, medium);
    if (!f.physical())
        throw InputError("solver godunov", "the contents of " + whose + ", density " + shortest(q.mass) +
                                               " and pressure " + shortest(f.p) +
                                               ", have no speed of sound: density must be > 0, and the pressure of a "
                                               "gas too");
}

}  // namespace

std::vector<Parameter> option_parameters() {
    return {
        word("order", "second",
             {{"first", "uniform cells [Godunov1959]"},
              {"second", "MUSCL-Hancock: limited linear cells, whose faces go ahead by half a step [VanLeer1979]"}},
             "of the reconstruction"),
        word("flux", "hllc",
             {{"hll", "one state between two waves [Einfeldt1988]"},
              {"hllc", "two states, with the contact between them [ToroSpruceSpeares1994]"}},
             "approximate Riemann solver"),
        without_default(
            word("speeds", "davis",
                 {{"davis", "min and max of v -+ a of both sides [Davis1988]"},
                  {"einfeldt", "v -+ a of a weighted average too [Einfeldt1988]"},
                  {"pressure", "of a gas: that of a shock where an estimated pressure has one [ToroSpruceSpeares1994]"},
                  {"acoustic", "v_L - a_L and v_R + a_R; with hllc linearised impedances, exact for Hooke's law"}},
                 "wave speeds of the Riemann solver; absent: pressure for a gas with hllc, else davis")),
        word("limiter", "mc",
             {{"minmod", "the smaller difference"},
              {"van_leer", "harmonic mean of the differences"},
              {"mc", "monotonized central [VanLeer1979]"},
              {"superbee", "the steepest that keeps total variation [Toro2009]"},
              {"central", "none: smooth flow only"}},
             "of density, velocity and pressure (elastic: temperature), for order second"),
    };
}

std::vector<Parameter> resolution_parameters() {
    return {required(whole("cells", 2, between(2, 1e8), "equal cells between the ends")),
            number("courant", "-", 0.45, {.low = 0, .high = 4, .low_excluded = true},
                   "dt (|v| + a) / h of the fastest cell, in each step")};
}

Options options_from(const Medium& medium, const Values& values) {
    return {.second_order = values.word("order") == "second",
            .riemann = values.word("flux") == "hllc" ? RiemannSolver{Hllc{}} : RiemannSolver{Hll{}},
            .speeds = speeds_from(medium, values),
            .limiter = chosen(values.word("limiter"), limiters)};
}

Resolution resolution_from(const LineScene& scene, const Values& values) {
    const int cells = values.whole("cells");
    return {
        .cells = cells, .h = (scene.edges.back() - scene.edges.front()) / cells, .courant = values.number("courant")};
}

void check(const LineScene& scene) {
    check_end(scene.ends[0], scene.ends[1], "left");
    check_end(scene.ends[1], scene.ends[0], "right");
    for (std::size_t k = 0; k < scene.pieces.size(); ++k)
        check_contents(scene.medium, scene.pieces[k], "piece " + std::to_string(k));
    for (const LineEnd& end : scene.ends) {
        if (end.kind == Kind::prescribed) check_contents(scene.medium, end.outside, "a prescribed end");
    }
}

}  // namespace ordo::solvers::godunov
