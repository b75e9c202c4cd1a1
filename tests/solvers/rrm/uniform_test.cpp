// Where nothing happens, nothing may be done: uniform lines in many pieces.
#include "tests/solvers/rrm/lines.hpp"

using namespace ordo;
using namespace ordo::solvers;
using namespace ordo::solvers::rrm;
using namespace ordo::solvers::rrm::test;

namespace {

const std::vector<std::string> keeps{"nothing", "contacts", "waves"};

/// Twenty unequal pieces of the same contents on [-1, 1].
LineScene many_pieces(const Medium& medium, const Contents& q, LineEnd::Kind ends) {
    LineScene scene{medium, {-1}, {}, {LineEnd{ends}, LineEnd{ends}}};
    for (int i = 1; i <= 20; ++i) scene.edges.push_back(-1 + 0.1 * i + 0.04 * std::sin(i) * (i < 20));
    scene.pieces.assign(20, q);
    return scene;
}

/// Largest change of a density, momentum or energy, relative to the largest of its kind.
double change(const Snapshot& shot, const Contents& q) {
    double worst = 0;
    for (std::size_t i = 0; i < shot.points(); ++i) {
        worst = std::max({worst, std::abs(shot.field("density").values[i] / q.mass - 1),
                          std::abs(shot.field("momentum").values[i] - q.momentum) / (q.mass + std::abs(q.momentum)),
                          std::abs(shot.field("total_energy").values[i] / q.energy - 1)});
    }
    return worst;
}

}  // namespace

TEST_CASE("rrm: uniform lines in many pieces are never chopped out", "[property]") {
    for (const double v : {0.0, 0.3, -7.0}) {
        for (const auto& keep : keeps) {
            for (const auto kind : {LineEnd::Kind::reservoir, LineEnd::Kind::periodic}) {
                CAPTURE(v, keep, int(kind));
                const auto untouched = [&](const Medium& medium, const Contents& q) {
                    const auto run = run_to(2, many_pieces(medium, q, kind), {{"keep", keep}}, 1e-3);
                    // A ring that has become one cell has one front left, which is put back each time it meets itself:
                    // with the sound speeds here at most three times.
                    CHECK(figure(run->work(), "chop_outs") <= (kind == LineEnd::Kind::periodic ? 3 : 0));
                    CHECK(figure(run->work(), "unions") >= 10);
                    // Unions sum what was swept, and flattening divides by the width: some hundred roundings.
                    CHECK(change(run->snapshot(), q) < 1e-13);
                };
                const IdealGas gas{1.3};
                const ElasticMedium<RubberEnergy> rubber{.E = 2, .rho0 = 1.5, .c_v = 0.7, .k = 1};
                untouched(gas, gas.contents(0.7, v, 1.2));
                untouched(rubber, rubber.contents(1.2, v, 0.4));
            }
        }
    }
}

TEST_CASE("rrm: equal cells of widths 2, 1 and 3 exchange no momentum [Walker2012, fig. 19]", "[unit]") {
    // Were the fronts not united, the right one would by t = 2.5 have got the push of the cell of width 2, which sound
    // of speed 1 has crossed, against that of the cell of width 3, which it has not: p min(t, 2) - p min(t, 3).
    const double t = 2.5;
    CHECK(std::min(t, 2.0) - std::min(t, 3.0) == -0.5);
    const IdealGas gas;
    const Contents q = gas.contents(1, 0, 1);
    for (const auto& keep : keeps) {
        for (const auto kind : {LineEnd::Kind::reservoir, LineEnd::Kind::wall}) {
            const LineScene scene{gas, {0, 2, 3, 6}, {q, q, q}, {LineEnd{kind}, LineEnd{kind}}};
            const auto shot = at(t, scene, {{"keep", keep}}, 1e-3);
            double momentum = 0;
            for (std::size_t i = 0; i < shot.points(); ++i)
                momentum += shot.weights[i] * shot.field("momentum").values[i];
            CHECK(std::abs(momentum) < 1e-14);
        }
    }
}

TEST_CASE("rrm: a difference too small to matter is united away", "[unit]") {
    const IdealGas gas;
    const LineScene scene{gas,
                          {-1, -0.1, 0.1, 1},
                          {gas.contents(1, 0, 1), gas.contents(1 + 1e-9, 0, 1), gas.contents(1, 0, 1)},
                          {LineEnd{LineEnd::Kind::periodic}, LineEnd{LineEnd::Kind::periodic}}};
    const auto work = run_to(1, scene, {{"keep", std::string("nothing")}}, 1e-3)->work();
    CHECK(figure(work, "chop_outs") <= 1);  // of the one cell that is left of the ring
    CHECK(figure(work, "unions") >= 1);
    CHECK(figure(work, "cells_alive") <= 3);
}
