// A contact alone, and linear elastic waves, which are contacts of another name: what can be exact is.
#include "tests/solvers/rrm/lines.hpp"

using namespace ordo;
using namespace ordo::solvers;
using namespace ordo::solvers::rrm;
using namespace ordo::solvers::rrm::test;

namespace {

/// rho 1 | 0.2 in a stream of uniform pressure until t = 1 on [-2.5, 2.5].
const Problem contact = gas_problem({.rho = 1, .v = 0.3, .p = 1}, {.rho = 0.2, .v = 0.3, .p = 1}, 2.5, 1);

}  // namespace

TEST_CASE("rrm: an isolated contact is exact where contacts are kept", "[property]") {
    for (const std::string keep : {"contacts", "waves"}) {
        for (const double delta : {1e-2, 1e-4}) {
            CAPTURE(keep, delta);
            const auto run = run_to(contact.t, contact.scene, {{"keep", keep}}, delta);
            if (keep == "contacts") CHECK(figure(run->work(), "chop_outs") == 0);
            else CHECK(figure(run->work(), "chop_outs") <= 1);
            for (const double error : errors(run->snapshot(), contact)) CHECK(error < 1e-14);
        }
    }
}

TEST_CASE("rrm: a contact that is not kept spreads, in even velocity and pressure", "[convergence]") {
    // Errors of a second implementation, a substitute of ours; theory gives their slope 1/3.
    const double expected[] = {9.6e-2, 4.5e-2, 2.1e-2};
    const Given options{
        {"keep", std::string("nothing")}, {"density_change", 1.0}, {"velocity_change", 1.0}, {"pressure_change", 1.0}};
    for (int i = 0; i < 3; ++i) {
        const auto shot = at(contact.t, contact.scene, options, std::pow(10, -3 - i));
        const Row found = errors(shot, contact);
        CAPTURE(i, found[0], found[1], found[2]);
        CHECK(std::abs(found[0] / expected[i] - 1) < 0.2);
        const double even = i < 2 ? 1e-12 : 5e-12;  // after 1e5 chop-outs, each with its roundings
        for (std::size_t cell = 0; cell < shot.points(); ++cell) {
            CHECK(std::abs(shot.field("velocity").values[cell] - 0.3) < even);
            CHECK(std::abs(shot.field("pressure").values[cell] - 1) < even);
        }
    }
}

TEST_CASE("rrm: linear elastic problems are exact with own speeds, and with waves", "[property]") {
    for (std::size_t i = 0; i < 4; ++i) {
        const Problem problem = linear(i);
        for (const double delta : {0.3, 1e-2, 1e-3}) {
            for (const Given& way : {Given{{"keep", std::string("contacts")}, {"speeds", std::string("own")}},
                                     Given{{"keep", std::string("waves")}},
                                     Given{{"keep", std::string("waves")}, {"speeds", std::string("own")}}}) {
                const Row found = errors(at(problem.t, problem.scene, problem.watching(way), delta), problem);
                CAPTURE(i, delta, text_of(way.at("keep")), found[0], found[1], found[2], found[3]);
                // Ten thousand events, each with its roundings.
                for (const double error : found) CHECK(error < (delta < 1e-2 ? 1e-12 : 1e-13));
            }
        }
    }
}

TEST_CASE("rrm: own speeds are exact for a line of other stiffness, density and heat too", "[property]") {
    const ElasticMedium<HookeEnergy> line{.E = 3, .rho0 = 0.7, .c_v = 2};
    const Problem problem = linear_problem({0.8, 0.3, 0.4}, {1.25, -0.1, 0.9}, 2.5, 0.4, line);
    const Given options = problem.watching({{"keep", std::string("contacts")}, {"speeds", std::string("own")}});
    // Waves of speed 2 over a length of 5 in some ten thousand chop-outs, each with its roundings.
    for (const double error : errors(at(problem.t, problem.scene, options, 1e-3), problem)) CHECK(error < 1e-12);
}

TEST_CASE("rrm: Davis speeds and contacts that are not kept are inexact there", "[alarm]") {
    const Problem problem = linear(3);
    const auto worst = [&](const Given& way) {
        const Row found = errors(at(problem.t, problem.scene, problem.watching(way), 1e-3), problem);
        return *std::ranges::max_element(found);
    };
    CHECK(worst({{"keep", std::string("contacts")}}) > 1e-6);
    CHECK(worst({{"keep", std::string("nothing")}, {"speeds", std::string("own")}}) > 1e-3);
}
