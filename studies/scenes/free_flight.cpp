// Free flight: an unstressed elastic box, free on all sides, moves along x and falls along the last axis. Nothing may
// deform it. It turns on what the bars lack: the body force, the half kick, and the second and third dimension.
#include "oracles/free_flight.hpp"

#include "core/elastic_constants.hpp"
#include "studies/engine/scene_entry.hpp"

namespace ordo::studies {
namespace {

using solvers::Vec;

constexpr ElasticConstants unit_solid{.E = 1, .nu = 0, .K = 1.0 / 3, .G = 0.5, .lambda = 0, .M = 1};

template <int dim>
solvers::Scene box(const Values& values) {
    const Vec<dim> start = values.number("v0") * Vec<dim>::Unit(0);
    const Vec<dim> pull = values.number("g") * Vec<dim>::Unit(dim - 1);
    const auto everywhere = [](const Vec<dim>& vector) -> solvers::VectorField<dim> {
        return [vector](std::span<const Vec<dim>>, double, std::span<Vec<dim>> out) {
            std::fill(out.begin(), out.end(), vector);
        };
    };
    const auto solid = elastic_constants(values, unit_solid, "scene free_flight");
    return solvers::SolidScene<dim>{
        .lower = Vec<dim>::Zero(),
        .upper = Vec<dim>::Constant(values.number("L")),
        .rho = values.number("rho"),
        .law = solvers::make_law(values.word("law"), {.lambda = solid.lambda, .mu = solid.G}),
        .faces = {},
        .velocity = everywhere(start),
        .body_force = everywhere(pull)};
}

solvers::Scene problem(const Values& values) {
    const int dim = values.whole("dim");
    return dim == 1 ? box<1>(values) : dim == 2 ? box<2>(values) : box<3>(values);
}

std::vector<Parameter> parameters() {
    const auto solid = appended(oracles::free_flight().parameters, elastic_parameters("E 1, nu 0"));
    return appended(solid, {number("rho", "kg/m^dim", 1, positive, "density"), solvers::law_parameter("E ln F")});
}

const bool enrolled = enrol({.name = "free_flight",
                             .about = "Unstressed elastic box in free flight under a constant force per mass",
                             .source = {"Newton1687"},
                             .units = "SI",
                             .parameters = parameters(),
                             .oracle = "free_flight",
                             .problem = problem,
                             .truth = [](const Values& values) { return oracles::free_flight().bind(values); }});

}  // namespace
}  // namespace ordo::studies
