// Uniaxial strain of a plastic bar: a von Mises solid along x, held at its sides and at X = 0, is drawn out at X = L
// with constant speed. It starts with the speed rate X of a uniform stretch F = 1 + rate t, which nothing then
// accelerates: what is wrong is the law, its history, or the moving face. The law adds up strain increments of the
// deformed body, so that small-strain plasticity holds in the logarithmic strain ln F, to the order of the time step.
// [SimoHughes1998]
#include <cmath>

#include "core/elastic_constants.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "oracles/plasticity/j2_uniaxial_strain.hpp"
#include "studies/engine/scene_entry.hpp"
#include "studies/scenes/fields.hpp"

namespace ordo::studies {
namespace {

using oracles::J2UniaxialStrain;
using solvers::Face;
using solvers::Vec;

constexpr const char* where = "scene uniaxial_strain";
constexpr double greatest_stretch = 1e15;  // beyond, F no longer tells 1 + rate t from rate t
constexpr double least_stretch = 1e-3;

/// j2_parameters() and not what the oracle declares: that one may not be built yet when a scene enrols.
std::vector<Parameter> parameters() {
    auto solid = oracles::j2_parameters();
    std::erase_if(solid, [](const Parameter& known) { return known.name != "Y0" && known.name != "H"; });
    solid = appended(elastic_parameters("E 2e11, nu 0.3"), solid);
    return appended(solid, {number("rate", "1/s", 1, finite, "dF/dt, of either sign"),
                            number("L", "m", 1, between(1e-100, 1e100), "length"),
                            number("rho", "kg/m", 7850, positive, "density")});
}

ElasticConstants elastic_of(const Values& values) {
    const J2UniaxialStrain fallback;
    return elastic_constants(values, elastic_constants({Elastic::K, fallback.K}, {Elastic::G, fallback.G}, where),
                             where);
}

oracles::Exact truth(const Values& values) {
    const double L = values.number("L");
    const double rate = values.number("rate");
    if (!std::isfinite(rate * L)) throw InputError(where, "rate = " + shortest(rate) + ": rate L is out of range");
    const auto elastic = elastic_of(values);
    const J2UniaxialStrain solid{.K = elastic.K,
                                 .G = elastic.G,
                                 .Y0 = values.number("Y0"),
                                 .H = values.number("H"),
                                 .path = {.rate = rate < 0 ? -1.0 : 1.0}};
    const double furthest = rate < 0 ? 1 - least_stretch : greatest_stretch;
    return {.dim = 1,
            .coordinates = oracles::Coordinates::material,
            .lower = {0},
            .upper = {L},
            .times = rate == 0 ? at_least(0) : between(0, furthest / std::abs(rate)),
            .fields = standard_fields(),
            .sample = oracles::along_a_line([=](double X, double t) {
                const double stress = solid.at(std::abs(std::log1p(rate * t))).stress;
                return std::array{rate * t * X, rate * X, stress, rate * t};
            }),
            .jumps = oracles::no_jumps};
}

solvers::Scene problem(const Values& values) {
    truth(values);  // refuses what has no solution: `ordo solve` asks for the problem alone
    const double rate = values.number("rate");
    const auto elastic = elastic_of(values);
    const auto stretching = along_x([rate](double X, double) { return rate * X; });
    return solvers::SolidScene<1>{.lower = Vec<1>(0.0),
                                  .upper = Vec<1>(values.number("L")),
                                  .rho = values.number("rho"),
                                  .law = solvers::J2Law{.C = {.lambda = elastic.lambda, .mu = elastic.G},
                                                        .yield = values.number("Y0"),
                                                        .hardening = values.number("H")},
                                  .faces = {{{Face::fixed, Face::fixed}}},
                                  .velocity = stretching,
                                  .face_velocity = stretching};
}

const bool enrolled = enrol({.name = "uniaxial_strain",
                             .about = "Von Mises solid in uniform uniaxial stretch at constant speed of its end",
                             .source = {"SimoHughes1998"},
                             .units = "SI",
                             .parameters = parameters(),
                             .oracle = "j2_uniaxial_strain",
                             .problem = problem,
                             .truth = truth});

}  // namespace
}  // namespace ordo::studies
