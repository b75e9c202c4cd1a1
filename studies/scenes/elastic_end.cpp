// A uniform elastic bar on [x0, x0 + length] whose left end a wall pushes, pulls or stops, or is let go (`end`); on its
// right the bar goes on without end. What is observed begins at the end, wherever that is. A free end moves by itself
// and may be found beyond its exact place: there the truth is its state at the end.   [Walker2017]
#include "oracles/lines/elastic_end.hpp"

#include "studies/engine/scene_entry.hpp"
#include "studies/scenes/lines.hpp"

namespace ordo::studies {
namespace {

using solvers::LineEnd;

std::vector<Parameter> parameters() {
    return appended(oracles::elastic_end().parameters,
                    {number("length", "m", 3, positive, "of the bar that is observed at t = 0")});
}

/// The end's exact place at t.
double end_of(const oracles::Exact& exact, double t) {
    const auto list = exact.constants(t);
    return std::get<double>(std::ranges::find(list, "x_end", &oracles::Constant::name)->value);
}

oracles::Exact truth(const Values& values) {
    auto exact = exact_of(oracles::elastic_end(), values);
    const auto up_to_its_end = [exact](const oracles::Exact::Sample& given) {
        return [exact, given](std::span<const double> x, double t, std::span<double> rows) {
            std::vector<double> inside(x.begin(), x.end());
            const double end = end_of(exact, t);
            for (double& place : inside) place = std::max(place, end);
            given(inside, t, rows);
        };
    };
    exact.sample = up_to_its_end(exact.sample);
    exact.averages = up_to_its_end(exact.averages);
    return exact;
}

solvers::Scene problem(const Values& values) {
    truth(values);  // refuses what has no solution: `ordo solve` asks for the problem alone
    const auto medium = elastic_medium(values.word("material"), values);
    const double x0 = values.number("x0");
    const LineEnd wall{.kind = LineEnd::Kind::wall, .velocity = values.number("V")};
    const LineEnd let_go{.kind = LineEnd::Kind::free};
    return solvers::LineScene{.medium = medium,
                              .edges = {x0, x0 + values.number("length")},
                              .pieces = {elastic_contents(medium, values, "")},
                              .ends = {values.word("end") == "free" ? let_go : wall, LineEnd{}}};
}

const bool enrolled = enrol({.name = "elastic_end",
                             .about = "An elastic bar that a wall moves or stops at its end, or whose end is let go",
                             .source = {"Walker2017"},
                             .units = "dimensionless",
                             .parameters = parameters(),
                             .oracle = "elastic_end",
                             .problem = problem,
                             .truth = truth});

}  // namespace
}  // namespace ordo::studies
