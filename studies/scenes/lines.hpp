#pragma once
// What scenes of gases and elastic lines share: media and states from parameters, and where the line is observed.
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/text.hpp"
#include "oracles/oracle.hpp"
#include "solvers/media/line.hpp"

namespace ordo::studies {

/// The exact solution of that name, from those values that it declares and from `fixed`.
inline oracles::Exact exact_of(const oracles::Oracle& oracle, const Values& values, const Given& fixed = {}) {
    Given given = fixed;
    for (const auto& [name, value] : values.all()) {
        if (find_parameter(oracle.parameters, name)) given.emplace(name, value);
    }
    return oracle.bind(resolve(oracle.parameters, given, "scene", oracle.name));
}

inline std::vector<Parameter> observed_parameters(double from, double to) {
    return {number("x_left", "m", from, finite, "the line is observed from here"),
            number("x_right", "m", to, finite, "to here")};
}

/// The places of those names, which must rise. Throws InputError with the nearest value of one that does not.
inline std::vector<double> rising(const std::string& scene, const Values& values,
                                  const std::vector<std::string>& names) {
    std::vector<double> places;
    for (const auto& name : names) {
        const double place = values.number(name);
        if (!places.empty() && !(place > places.back()))
            throw InputError("scene " + scene, name + " = " + shortest(place) + " m, but must be > " +
                                                   shortest(places.back()) +
                                                   " m; nearest: " + shortest(places.back() + 1));
        places.push_back(place);
    }
    return places;
}

/// x_left, the two sides of a strip around x = 0, x_right. Throws InputError for a strip that is not within them.
inline std::vector<double> around(const std::string& scene, const Values& values, double width) {
    const double from = values.number("x_left");
    const double to = values.number("x_right");
    const auto refuse = [&](const std::string& name, double value, const std::string& rule, double nearest) {
        throw InputError("scene " + scene, name + " = " + shortest(value) + " m, but must be " + rule +
                                               shortest(nearest / 2) + " m; nearest: " + shortest(nearest));
    };
    if (!(from < -width / 2)) refuse("x_left", from, "< ", -width);
    if (!(to > width / 2)) refuse("x_right", to, "> ", width);
    return {from, -width / 2, width / 2, to};
}

/// Contents of a gas from rho, v and p with this ending.
inline solvers::Contents gas_contents(const solvers::IdealGas& gas, const Values& values, const std::string& ending) {
    return gas.contents(values.number("rho" + ending), values.number("v" + ending), values.number("p" + ending));
}

/// The law named by a `material` word, A, B, C or linear; heat exerts no stress in the linear one.
inline solvers::Medium elastic_medium(const std::string& material, const Values& values) {
    const auto with = [&]<class Energy>(Energy) -> solvers::Medium {
        return solvers::ElasticMedium<Energy>{.E = values.number("E"),
                                              .rho0 = values.number("rho0"),
                                              .c_v = values.number("c_v"),
                                              .k = material == "linear" ? 0 : values.number("k")};
    };
    if (material == "linear") return with(solvers::HookeEnergy{});
    if (material == "A") return with(solvers::RubberEnergy{});
    if (material == "B") return with(solvers::ReciprocalEnergy{});
    return with(solvers::LogarithmicEnergy{});
}

/// Contents of an elastic line of that stretch, velocity and temperature.
inline solvers::Contents elastic_contents(const solvers::Medium& medium, double lambda, double v, double T) {
    const auto of = [&](const auto& law) -> solvers::Contents { return law.contents(lambda, v, T); };
    return std::visit(of, medium);
}

/// The same from lambda, v and T with this ending.
inline solvers::Contents elastic_contents(const solvers::Medium& medium, const Values& values,
                                          const std::string& ending) {
    return elastic_contents(medium, values.number("lambda" + ending), values.number("v" + ending),
                            values.number("T" + ending));
}

}  // namespace ordo::studies
