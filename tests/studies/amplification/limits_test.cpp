// Limits by runs, by the matrix of one step and in closed form, against each other and against seeded faults.
#include "studies/amplification/limits.hpp"

#include <cmath>

#include "core/error.hpp"
#include "studies/engine/scene_entry.hpp"
#include "tests/catch.hpp"

using namespace ordo;
using namespace ordo::studies;

namespace {

Scheme scheme_of(const Given& scene, const std::string& solver, const Given& options, const Given& resolution) {
    const auto& entry = scene_named("bar_vibration", "");
    const auto& found = solvers::solver_named(solver, "");
    return {entry.problem(resolve(entry.parameters, scene, "", "scene")), &found,
            resolve(found.options, options, "", solver), resolve(found.resolution, resolution, "", solver)};
}

Scheme periodic(const Given& options, double cells = 8, double ppc = 2) {
    return scheme_of({{"L", 3.0}, {"E", 7.0}, {"rho", 2.0}, {"ends", "periodic"}, {"law", "E(F-1)"}}, "mpm", options,
                     {{"cells", cells}, {"ppc", ppc}});
}

Scheme bounded(const std::string& solver, const Given& options, const Given& resolution) {
    return scheme_of({{"L", 3.0}, {"E", 7.0}, {"rho", 2.0}, {"law", "E(F-1)"}}, solver, options, resolution);
}

const Stability asked{.crossings = 500, .tolerance = 1e-4};

}  // namespace

TEST_CASE("first limit: up from below, the first change, inside the tolerance", "[unit]") {
    const auto below = [](double limit) { return [=](double courant) { return courant <= limit; }; };
    for (const double limit : {0.11, 0.7559, 1.0, 3.99}) {
        const Limit found = first_limit(below(limit), asked);
        CHECK(found.stable <= limit);
        CHECK(found.unstable > limit);
        CHECK(found.unstable - found.stable <= 1e-4);
    }
    // An island of stability above the limit is not the limit.
    const auto island = [](double courant) { return courant < 0.5 || (courant > 1 && courant < 2); };
    CHECK(first_limit(island, asked).value() == Approx(0.5).margin(1e-4));
    CHECK(first_limit(below(0.01), asked).stable == 0);
    CHECK(std::isinf(first_limit(below(10), asked).value()));
}

TEST_CASE("matrix of one step: waves on the periodic body have the eigenvalues of the whole", "[property]") {
    for (const auto* basis : {"linear", "quadratic", "cubic"}) {
        for (const auto* order : {"usl", "musl", "usf"}) {
            const OneStep step(periodic({{"basis", basis}, {"stress_update", order}}));
            for (const double courant : {0.3, 1.1, 3.0}) {
                // Differences of 1e-10 in the matrix, their root at defective pairs.
                CHECK(spectral_radius(waves_of(step, courant, 8)) ==
                      Approx(spectral_radius(step.matrix(courant))).epsilon(2e-5));
            }
        }
    }
}

TEST_CASE("limits: closed form and matrix agree on the periodic bar, in other units and places", "[property]") {
    for (const auto& options :
         std::vector<Given>{{{"stress_update", "usl"}}, {{"stress_update", "musl"}}, {{"mass", "consistent"}}}) {
        for (const double ppc : {2.0, 3.0}) {
            const Scheme scheme = periodic(options, 8, ppc);
            REQUIRE(limit_by_theory(scheme));
            CHECK(limit_by_matrix(scheme, asked).value() == Approx(*limit_by_theory(scheme)).margin(2e-4));
        }
    }
}

TEST_CASE("limits: a solver with 2 % too much stiffness or inertia is found out by its matrix", "[alarm]") {
    for (const double factor : {1.02, 0.98}) {
        Scheme scheme = periodic({{"stress_update", "usl"}});
        solvers::Solver broken = *scheme.solver;
        broken.start = [factor, good = scheme.solver->start](const solvers::Scene& scene, const Values& options,
                                                             const Values& resolution,
                                                             std::span<const std::string> fields) {
            auto body = std::get<solvers::SolidScene<1>>(scene);
            body.rho *= factor;
            Given step = resolution.all();
            // The same dt: its Courant number was of the right density.
            step.insert_or_assign("courant", resolution.number("courant") / std::sqrt(factor));
            return good(body, options, Values(step), fields);
        };
        const double right = *limit_by_theory(scheme);
        scheme.solver = &broken;
        CHECK(std::abs(limit_by_matrix(scheme, asked).value() - right) > 5e-3);
    }
}

TEST_CASE("limits: runs of noise find the limit of the matrix on the same bar", "[property]") {
    for (const auto& [solver, options] : std::vector<std::pair<std::string, Given>>{
             {"mpm", {{"stress_update", "usl"}}}, {"mpm", {{"stress_update", "musl"}}}, {"fem", {}}}) {
        Given resolution{{"cells", 6.0}};
        if (solver == "mpm") resolution.emplace("ppc", 2.0);
        const Scheme scheme = bounded(solver, options, resolution);
        const Growths growths(scheme, asked, [] { return false; });
        const double limit = limit_by_matrix(scheme, asked).value();
        CHECK(growths.at(0.99 * limit, false).kind == Growth::Class::stable);
        CHECK(growths.at(1.02 * limit, false).kind != Growth::Class::stable);
    }
}

TEST_CASE("runs of noise: bounded below the limit, growing just above it, blown up far beyond", "[alarm]") {
    const Scheme scheme = periodic({{"stress_update", "usl"}});
    const Growths growths(scheme, asked, [] { return false; });
    const double limit = *limit_by_theory(scheme);
    CHECK(growths.at(0.99 * limit, true).kind == Growth::Class::stable);
    // 1e-9 grown by less than a million in 660 steps of a radius of about 1.02.
    const Growth above = growths.at(1.005 * limit, true);
    CHECK(above.kind == Growth::Class::growing);
    CHECK(above.growth > 1000);
    const Growth beyond = growths.at(2 * limit, true);
    CHECK(beyond.kind == Growth::Class::blown_up);
    CHECK_THAT(beyond.why, ContainsSubstring("turned inside out"));
}

TEST_CASE("limits: finite elements have those of their largest frequency", "[property]") {
    const Scheme scheme = bounded("fem", {{"mass", "lumped"}}, {{"cells", 7.0}});
    CHECK(limit_by_matrix(scheme, asked).value() == Approx(*limit_by_theory(scheme)).margin(2e-4));
}

TEST_CASE("limits: beyond that of USL the saw-tooth grows, beyond that of MUSL a longer wave", "[unit]") {
    CHECK(growing_mode(periodic({{"stress_update", "usl"}}, 16), 0.76) == "the saw-tooth mode");
    CHECK_THAT(growing_mode(periodic({{"stress_update", "musl"}}, 16), 1.75), ContainsSubstring("a wave of about"));
}

TEST_CASE("waves: slower than the exact one by an error of second order, and kept by a symplectic scheme",
          "[convergence]") {
    double before = 0;
    for (const double cells : {8.0, 16.0, 32.0}) {
        const Wave wave = longest_wave(periodic({{"stress_update", "musl"}}, cells), 0.1);
        const double off = 1 - wave.speed;
        CHECK(off > 0);
        CHECK(wave.gain == Approx(1).epsilon(1e-8));
        if (before > 0) CHECK(std::log2(before / off) == Approx(2).margin(0.1));
        before = off;
    }
    CHECK(longest_wave(periodic({{"transfer", "pic"}, {"stress_update", "usl"}}, 16), 0.1).gain < 0.999);
}

TEST_CASE("stability is asked of bodies that have a matrix and of no others", "[alarm]") {
    CHECK_THROWS_AS(OneStep(scheme_of({}, "fem", {{"sampled_at", "centres"}}, {{"cells", 4.0}})), InputError);
    for (const auto* transfer : {"apic", "tpic", "mls"})
        CHECK_THROWS_AS(OneStep(bounded("mpm", {{"transfer", transfer}, {"basis", "quadratic"}}, {{"cells", 4.0}})),
                        InputError);
    CHECK_THROWS_AS(longest_wave(bounded("mpm", {}, {{"cells", 4.0}}), 0.1), InputError);
    Scheme scheme = periodic({});
    scheme.scene = solvers::ScalarEquation{};
    CHECK_THROWS_AS(OneStep(scheme), InputError);
}
