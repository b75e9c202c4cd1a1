#pragma once
// Random manufactured motions through their declarations, each held to the balance of momentum at one random point.
#include <functional>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "tests/catch.hpp"
#include "tests/oracles/fuzz.hpp"
#include "tests/oracles/manufactured/motion_gate.hpp"

namespace ordo::oracles::gate::manufactured {

/// Any two constants of a random solid, or none.
inline Given random_solid(Random& random) {
    const double E = random.log_uniform(1e-6, 1e12);
    const auto all = elastic_constants({Elastic::E, E}, {Elastic::nu, random.uniform(-0.6, 0.45)}, "");
    switch (random.whole(0, 4)) {
        case 0: return {};
        case 1: return {{"E", all.E}, {"nu", all.nu}};
        case 2: return {{"G", all.G}, {"K", all.K}};
        case 3: return {{"lambda", all.lambda}, {"G", all.G}};
        default: return {{"M", all.M}, {"K", all.K}};
    }
}

/// How fine a motion is.
struct Grain {
    double length;  ///< over which it changes [m]
    double margin;  ///< least det F, or what stands for it
};

/// The motion that an exact solution samples.
template <std::size_t dim>
Motion<dim> motion_of(const Exact& exact, double rho, const Grain& grain) {
    const Constants constants = exact.constants(std::nullopt);
    const auto named = [&](const std::string& name) {
        for (const auto& constant : constants) {
            if (constant.name == name) return std::get<double>(constant.value);
        }
        throw std::out_of_range(name);
    };
    const auto at = [&exact](const Place<dim>& X, double t) {
        std::array<double, 3 * dim + 4 * dim * dim> row{};
        exact.sample(X, t, row);
        MaterialPoint<dim> p{};
        auto from = row.begin();
        const auto take = [&](auto& field) {
            std::copy(from, from + static_cast<std::ptrdiff_t>(field.size()), field.begin());
            from += static_cast<std::ptrdiff_t>(field.size());
        };
        take(p.u), take(p.v), take(p.stress), take(p.strain), take(p.b), take(p.F), take(p.P);
        return p;
    };
    return {.at = at,
            .elastic = {named("E"), named("nu"), named("K"), named("G"), named("lambda"), named("M")},
            .rho = rho,
            .length = grain.length,
            .omega = named("omega"),
            .points = {},
            .digits = 16 * eps / std::min(1.0, grain.margin),
            .share = 0.05 * std::min(1.0, grain.margin)};
}

/// One random call: it must be refused exactly where it is not `possible`, and else obey the gates at a random point.
template <std::size_t dim, class RandomPlace>
void fuzz(const Oracle& oracle, const Given& given, bool possible, const Grain& grain, RandomPlace&& place,
          Random& random, Tally& tally) {
    Exact exact;
    try {
        exact = oracle.bind(resolve(oracle.parameters, given, "", oracle.name));
    } catch (const InputError& refusal) {
        ++tally.refused;
        INFO(refusal.what());
        REQUIRE_FALSE(possible);
        return;
    }
    REQUIRE(possible);
    const auto rho = given.find("rho");
    auto motion = motion_of<dim>(exact, std::get<double>(rho->second), grain);
    motion.points = {place(random)};
    for (int n = 0; n < 6; ++n) motion.peaks.push_back(place(random));
    motion.phases = {random.uniform(0.3, 20)};
    bool sharp = true;
    for (const auto& [name, gate] : gates<dim>) {
        const Defect defect = gate(motion);
        INFO(name << ": defect " << defect.found << ", allowed " << defect.allowed);
        REQUIRE(defect.found <= defect.allowed);
        sharp = sharp && defect.allowed < 1e-5;
    }
    tally.checked += sharp;  // near det F = 0 differences may be too blunt to count
}

}  // namespace ordo::oracles::gate::manufactured
