// Rarefactions where waves are kept: rows of small jumps, shown as ramps, of the second order.
#include "tests/solvers/rrm/lines.hpp"

using namespace ordo;
using namespace ordo::solvers;
using namespace ordo::solvers::rrm;
using namespace ordo::solvers::rrm::test;

namespace {

struct Cost {
    double cells;
    Row error;  ///< in the middle half of the fan
};

/// The first fan of a problem lies between its first two places.
Cost cost(const Problem& problem, double delta, const Given& options = {}) {
    const auto run = run_to(problem.t, problem.scene, problem.watching(options), delta);
    const double from = problem.places[0];
    const double width = problem.places[1] - from;
    Cost found{figure(run->work(), "cells_alive"), {}};
    for (std::size_t k = 0; k < problem.watched(); ++k) {
        const auto exact = [&](double x) { return problem.exact(x)[k]; };
        found.error[k] = l1(run->snapshot(), k, exact, problem.places, from + 0.25 * width, from + 0.75 * width);
    }
    return found;
}

}  // namespace

TEST_CASE("rrm: inside fans kept waves are of second order in the number of cells", "[convergence]") {
    for (const Problem& problem : {sod, toro[1], rubber(2)}) {
        const Cost coarse = cost(problem, 1e-3);
        const Cost fine = cost(problem, 1e-5);
        for (const std::size_t k : {0u, 1u, 2u}) {
            const double order = std::log(coarse.error[k] / fine.error[k]) / std::log(fine.cells / coarse.cells);
            CAPTURE(problem.t, k, coarse.cells, fine.cells, coarse.error[k], fine.error[k], order);
            CHECK(std::abs(order - 2) < 0.1);
        }
    }
}

TEST_CASE("rrm: flattened fans are of a lower order", "[alarm]") {
    const Given flattening{{"keep", std::string("contacts")}};
    const Cost coarse = cost(sod, 1e-3, flattening);
    const Cost fine = cost(sod, 1e-5, flattening);
    CHECK(std::log(coarse.error[0] / fine.error[0]) / std::log(fine.cells / coarse.cells) < 1.5);
}

TEST_CASE("rrm: shocks and contacts between kept waves are exact", "[property]") {
    // Toro's fourth problem and two of rubber's have no fan.
    for (const Problem& problem : {toro[3], rubber(1), rubber(3)}) {
        const Row found = errors(at(problem.t, problem.scene, problem.watching({}), 1e-2), problem);
        for (std::size_t k = 0; k < problem.watched(); ++k) {
            CAPTURE(problem.t, k, found[k]);
            CHECK(found[k] < 1e-13 * problem.length() * (1 + std::abs(problem.exact(0)[k])));
        }
    }
}
