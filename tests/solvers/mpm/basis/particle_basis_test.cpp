// The finding of the CPDI authors [Brannon2013]: option 2 has linear fields from two particles a cell on, option 1 has
// constants at any density.
#include "solvers/mpm/basis/particle_basis.hpp"

#include "tests/catch.hpp"
#include "tests/solvers/mpm/basis/lineups.hpp"

using namespace ordo;
using namespace ordo::solvers::mpm;
using namespace ordo::lineups;

namespace {

const std::vector<double> densities{0.5, 0.75, 1, 1.5, 2, 3, 4};

/// Values up to 20, a hundred operations each at 2e-16; what a mapping amplifies comes on top.
constexpr double round_off = 5e-13;

double largest(const Weights& weights) { return weights.cwiseAbs().maxCoeff(); }

std::ptrdiff_t touched(const Picture& picture) { return std::ranges::count(picture.touched, true); }

/// How far from its node a particle that touches it may stand [cells]; the splines at the grid's ends are not met here.
double reach(const Picture& picture) {
    const double box = 0.5 * (picture.corners[1] - picture.corners[0]);
    switch (picture.lineup.basis) {
        case Basis::quadratic: return 1.5;
        case Basis::cubic: return 2;
        case Basis::quartic: return 2.5;
        case Basis::ugimp: return 1 + picture.particles.half[0][0];
        case Basis::cpgimp:
        case Basis::cpdi:
        case Basis::cpdi2: return 1 + box;
        default: return 1;
    }
}

/// Cells that the body must span now for option 2 to be exact at two particles a cell: as many particles as nodes.
int fewest_cells(Basis basis) { return basis == Basis::quadratic ? 3 : basis == Basis::cubic ? 4 : 2; }

/// Two particles a cell now, in a body of so many cells.
Picture two_a_cell(Basis basis, int body, double translate) {
    return picture_of({.basis = basis, .cells = body + 12, .margin = 6, .ppc = 2, .translate = translate});
}

}  // namespace

TEST_CASE("particle basis: option 2 has linear fields from two particles a cell on", "[property]") {
    for (const Basis basis : every_basis) {
        if (basis == Basis::quartic) continue;  // below
        int states = 0;
        for_every_state({1, 1.5, 2, 2.5, 3, 4}, [&](const Lineup& lineup) {
            if (lineup.ppc < 2 * lineup.stretch) return;  // now, not in the undeformed body
            const auto picture = picture_of(with(basis, lineup));
            const NodalMap map = nodal_map(picture, Mapping::pseudo_inverse);
            const Errors errors = errors_of(picture, map);
            INFO(text_of(picture.lineup));
            CHECK(map.rank == touched(picture));
            CHECK(errors.amplification < 100);  // or the next lines would say little
            for (const double error :
                 {errors.at_particles[0], errors.at_particles[1], errors.between[0], errors.between[1]})
                CHECK(error < round_off * errors.amplification);
            CHECK(errors.without_field == 0);
            ++states;
        });
        CHECK(states > 100);
    }
}

TEST_CASE("particle basis: two particles a cell suffice as soon as the body spans degree + 1 cells", "[property]") {
    for (const Basis basis : every_basis) {
        if (basis == Basis::quartic) continue;
        const int body = fewest_cells(basis);
        double shorter = 0;
        for (const double translate : {0.0, 0.1, 0.3, 0.6, 0.9}) {
            const auto picture = two_a_cell(basis, body, translate);
            const Errors errors = errors_of(picture, nodal_map(picture, Mapping::pseudo_inverse));
            INFO(text_of(picture.lineup));
            CHECK(errors.between[1] < round_off * errors.amplification);
            const auto short_one = two_a_cell(basis, body - 1, translate);
            if (touched(short_one) > short_one.count())
                shorter =
                    std::max(shorter, errors_of(short_one, nodal_map(short_one, Mapping::pseudo_inverse)).between[1]);
        }
        CHECK(shorter > 1e-3);
    }
}

TEST_CASE("particle basis: quartic splines are as exact, but for weights that round-off takes for none", "[property]") {
    // A particle that has just crossed a face feels the next spline by xi^4 / 24, which may count as none.
    for (const double translate : {0.0, 0.1, 0.37, 0.5, 0.9}) {
        const auto picture = two_a_cell(Basis::quartic, 5, translate);
        const Errors errors = errors_of(picture, nodal_map(picture, Mapping::pseudo_inverse));
        CHECK(errors.between[1] < round_off * errors.amplification);
        CHECK(errors.amplification < 1000);
    }
}

TEST_CASE("particle basis: option 2 gives the particles their values of both fields back at any density",
          "[property]") {
    // S S+ S = S, and both fields are S times their nodal values.
    for (const Basis basis : every_basis) {
        for_every_state({0.5, 0.75, 1, 2}, [&](const Lineup& lineup) {
            const auto picture = picture_of(with(basis, lineup));
            const NodalMap map = nodal_map(picture, Mapping::pseudo_inverse);
            const Errors errors = errors_of(picture, map);
            INFO(text_of(picture.lineup));
            CHECK(errors.at_particles[0] < round_off * largest(map.T));
            CHECK(errors.at_particles[1] < round_off * std::max(1.0, largest(map.T)));
        });
    }
}

TEST_CASE("particle basis: at one particle a cell and fewer, option 2 has no linear field between the particles",
          "[property]") {
    // Off the nodes, L cells with a particle each touch L + 1 nodes: one equation too few. Constants are kept where the
    // state is a mirror image of itself.
    for (const Basis basis : every_basis) {
        int states = 0;
        double constant = 0;
        for_every_state({0.5, 0.75, 1}, [&](const Lineup& lineup) {
            if (lineup.ppc > lineup.stretch || lineup.translate == 0 || lineup.translate == 1) return;
            const auto picture = picture_of(with(basis, lineup));
            if (touched(picture) <= picture.count()) return;  // all particles stand on nodes
            const NodalMap map = nodal_map(picture, Mapping::pseudo_inverse);
            const Errors errors = errors_of(picture, map);
            INFO(text_of(picture.lineup));
            CHECK(map.rank < touched(picture));
            if (errors.without_field > 0) return;  // what is left may be the particles alone
            CHECK(errors.between[1] > 1e-3);       // far above round-off
            constant = std::max(constant, errors.between[0]);
            ++states;
        });
        CHECK(states > 30);
        CHECK(constant > 1e-2);
    }
}

TEST_CASE("particle basis: particles that stand on nodes are those nodes", "[unit]") {
    const auto picture = picture_of({.cells = 8, .margin = 2, .ppc = 1, .translate = 0.5});
    for (const Mapping mapping : {Mapping::weighted, Mapping::pseudo_inverse}) {
        const NodalMap map = nodal_map(picture, mapping);
        Weights expected = Weights::Zero(9, 4);
        for (int p = 0; p < 4; ++p) expected(3 + p, p) = 1;
        CHECK(largest(map.T - expected) < 1e-14);
        CHECK(errors_of(picture, map).between[1] < 1e-13);
    }
}

TEST_CASE("particle basis: option 1 has constants at any density, by functions that are weights", "[property]") {
    for (const Basis basis : every_basis) {
        for_every_state(densities, [&](const Lineup& lineup) {
            const auto picture = picture_of(with(basis, lineup));
            const NodalMap map = nodal_map(picture, Mapping::weighted);
            const Errors errors = errors_of(picture, map);
            INFO(text_of(picture.lineup));
            CHECK(map.T.minCoeff() >= 0);
            // A weight counts from 1e-12 on: so much of a sum may be left out.
            CHECK(errors.at_particles[0] < 1e-11);
            CHECK(errors.between[0] < 1e-11);
            CHECK(errors.amplification == Approx(1).margin(1e-11));
            for (Eigen::Index i = 0; i < map.T.rows(); ++i) {
                const double share = picture.touched[static_cast<std::size_t>(i)] ? 1 : 0;
                CHECK(map.T.row(i).sum() == Approx(share).margin(1e-13));
            }
        });
    }
}

TEST_CASE("particle basis: option 1 misses a linear field by no more than its functions reach", "[property]") {
    // At a particle the error is a mean of f_i - x_i, and f_i a mean of places that touch node i.
    for (const Basis basis : every_basis) {
        for_every_state(densities, [&](const Lineup& lineup) {
            const auto picture = picture_of(with(basis, lineup));
            const Errors errors = errors_of(picture, nodal_map(picture, Mapping::weighted));
            INFO(text_of(picture.lineup));
            CHECK(errors.at_particles[1] <= reach(picture));
            CHECK(errors.between[1] <= reach(picture));
        });
    }
}

TEST_CASE("particle basis: option 1 by hand", "[unit]") {
    // Particles at 2.5, 3.5, 4.5, 5.5: the outer nodes take the value beside them, the inner ones their own. The first
    // particle gets (2.5 + 3) / 2 back.
    const auto picture = picture_of({.cells = 8, .margin = 2, .ppc = 1});
    const Errors errors = errors_of(picture, nodal_map(picture, Mapping::weighted));
    CHECK(errors.at_particles[0] < 1e-14);
    CHECK(errors.at_particles[1] == Approx(0.25).margin(1e-14));
    CHECK(errors.between[1] == Approx(0.25).margin(1e-14));
    CHECK(errors.without_field == 0);
}

TEST_CASE("particle basis: option 2 is the pseudo-inverse, whatever the rank", "[property]") {
    for (const Basis basis : every_basis) {
        for_every_state({0.5, 1, 3}, [&](const Lineup& lineup) {
            const auto picture = picture_of(with(basis, lineup));
            Weights S = picture.S;
            for (Eigen::Index i = 0; i < S.cols(); ++i) {
                if (!picture.touched[static_cast<std::size_t>(i)]) S.col(i).setZero();
            }
            const Weights T = nodal_map(picture, Mapping::pseudo_inverse).T;
            const double size = std::max(1.0, largest(T));
            INFO(text_of(picture.lineup));
            // The four conditions of Moore and Penrose; squares of T amplify round-off twice.
            CHECK(largest(S * T * S - S) < 1e-13 * size);
            CHECK(largest(T * S * T - T) < 1e-13 * size * size);
            CHECK(largest(S * T - (S * T).transpose()) < 1e-13 * size);
            CHECK(largest(T * S - (T * S).transpose()) < 1e-13 * size);
        });
    }
}

TEST_CASE("particle basis: a node that no particle touches takes no part, and no field is felt around it", "[unit]") {
    // Two particles on nodes 4 and 6 of tents: 5 is touched by none.
    const auto picture = picture_of({.cells = 10, .margin = 3, .ppc = 0.5});
    for (const Mapping mapping : {Mapping::weighted, Mapping::pseudo_inverse}) {
        const NodalMap map = nodal_map(picture, mapping);
        CHECK(touched(picture) == 2);
        CHECK(map.rank == 2);
        CHECK_FALSE(map.T.hasNaN());
        CHECK(largest(map.T.row(5)) == 0);
        const Weights Phi = particle_basis(picture, map, std::vector{4.0, 4.5, 5.0, 6.0});
        CHECK(Phi(0, 0) == Approx(1).margin(1e-14));
        CHECK(std::isnan(Phi(1, 0)));
        CHECK(std::isnan(Phi(2, 1)));
        CHECK(Phi(3, 1) == Approx(1).margin(1e-14));
        const Errors errors = errors_of(picture, map);
        CHECK(errors.without_field > 0.9);
        CHECK(errors.between[1] < 1e-13);  // at the two particles
    }
}
