// Energy released in a thin strip of gas at rest: the planar blast of Sedov and Taylor, seen on both sides. The truth
// has a plane instead of the strip and no pressure ahead; here the gas must be able to carry sound, so that it has the
// pressure p_ahead. What they change is of the order of width / r_shock and p_ahead / p_post. The strip holds twice the
// truth's energy, which counts one side.   [KammTimmes2007], [Walker2017]
#include <cmath>

#include "oracles/blasts/sedov.hpp"
#include "oracles/riemann/gas_record.hpp"
#include "studies/engine/scene_entry.hpp"
#include "studies/scenes/lines.hpp"

namespace ordo::studies {
namespace {

std::vector<Parameter> parameters() {
    const std::vector<Parameter> own{
        oracles::gamma_parameter(), number("rho0", "kg/m^3", 1, positive, "density of the gas"),
        number("energy", "J/m^2", 0.06734285, positive, "released at t = 0, to one side"),
        number("width", "m", 0.001, positive, "of the strip, around x = 0, that it is released in"),
        number("p_ahead", "Pa", 1e-8, positive, "pressure of the gas ahead")};
    return appended(own, observed_parameters(-0.75, 0.75));
}

/// The truth of r >= 0 on both sides of the plane.
oracles::Exact truth(const Values& values) {
    auto exact = exact_of(oracles::sedov(), values, {{"geometry", std::string("planar")}});
    const auto to_both_sides = [](const oracles::Exact& one_side) {
        return [half = one_side.sample, width = one_side.width(), v = *one_side.offset("velocity")](
                   std::span<const double> x, double t, std::span<double> rows) {
            std::vector<double> r(x.begin(), x.end());
            for (double& place : r) place = std::abs(place);
            half(r, t, rows);
            for (std::size_t i = 0; i < x.size(); ++i) {
                if (x[i] < 0) rows[i * width + v] *= -1;
            }
        };
    };
    exact.sample = to_both_sides(exact);
    exact.lower = {-exact.upper.front()};
    exact.jumps = [right = exact.jumps](double t) {
        const double r = right(t).back();
        return std::vector{-r, r};
    };
    exact.waves = [jumps = exact.jumps](double t) {
        std::vector<oracles::Wave> list;
        for (const double place : jumps(t)) list.push_back({oracles::Wave::Kind::shock, place, place});
        return list;
    };
    return exact;
}

solvers::Scene problem(const Values& values) {
    truth(values);  // refuses what has no solution: `ordo solve` asks for the problem alone
    const solvers::IdealGas gas{values.number("gamma")};
    const double rho = values.number("rho0");
    const double p_ahead = values.number("p_ahead");
    const double width = values.number("width");
    const auto ahead = gas.contents(rho, 0, p_ahead);
    const auto hot = gas.contents(rho, 0, p_ahead + (gas.gamma - 1) * 2 * values.number("energy") / width);
    return solvers::LineScene{
        .medium = gas, .edges = around("gas_blast", values, width), .pieces = {ahead, hot, ahead}};
}

const bool enrolled = enrol({.name = "gas_blast",
                             .about = "Energy released in a thin strip of gas: the planar blast of Sedov and Taylor",
                             .source = {"KammTimmes2007", "Walker2017"},
                             .units = "dimensionless",
                             .parameters = parameters(),
                             .oracle = "sedov",
                             .problem = problem,
                             .truth = truth});

}  // namespace
}  // namespace ordo::studies
