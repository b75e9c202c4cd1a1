#include "oracles/riemann/elastic_line.hpp"

#include <cmath>

#include "core/error.hpp"
#include "oracles/riemann/riemann_linear_elastic.hpp"
#include "tests/catch.hpp"
#include "tests/oracles/fuzz.hpp"

using namespace ordo;
using namespace ordo::oracles;
using namespace ordo::oracles::gate;
using elastic::State;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
enum : std::size_t { velocity, density, stress, strain, temperature, energy, momentum, total_energy };

struct Data {
    double E, rho0;
    std::vector<double> edges;
    std::vector<State> cells;
};

/// A line of up to 12 cells with stretches in [0.5, 2]; slow enough to be crushed by nothing.
Data any_line(Random& random, bool even) {
    Data data{random.log_uniform(1e-2, 1e2), random.log_uniform(1e-2, 1e2), {random.uniform(-1, 1)}, {}};
    const double c = std::sqrt(data.E / data.rho0);
    const int inner = random.whole(1, 10);
    for (int i = 0; i < inner; ++i)
        data.edges.push_back(data.edges.back() + (even ? 0.25 : random.log_uniform(1e-3, 1)));
    for (std::size_t i = 0; i <= data.edges.size(); ++i)
        data.cells.push_back({random.uniform(0.5, 2), random.uniform(-0.2, 0.2) * c, random.uniform(0, 1) * data.E});
    return data;
}

ElasticLine line_of(const Data& data, double place = 0.4) {
    return {data.E, data.rho0, 1, data.edges, data.cells, place};
}

}  // namespace

TEST_CASE("elastic line: the same as solving Riemann problem after Riemann problem", "[gate]") {
    // Cells of width h exchange waves that meet in their middles after h / (2 c): then each edge is the middle of a
    // uniform cell, the star state of its Riemann problem, and the middles are the new edges.
    Random random(37);
    for (int i = 0; i < 200; ++i) {
        const Data data = any_line(random, true);
        const ElasticLine line = line_of(data);
        const double h = 0.25;
        std::vector<State> cells(8, data.cells.front());  // enough quiet ones for 6 steps on both sides
        cells.insert(cells.end(), data.cells.begin() + 1, data.cells.end() - 1);
        cells.insert(cells.end(), 8, data.cells.back());
        double first = data.edges.front() - 8 * h;  // where cells begin
        for (int step = 1; step <= 6; ++step) {
            std::vector<State> stars;
            for (std::size_t k = 0; k + 1 < cells.size(); ++k) {
                const RiemannLinearElastic star(data.E, data.rho0, 1, cells[k], cells[k + 1]);
                stars.push_back({star.lambda_star(), star.v_star(), 0});
            }
            cells = stars;
            first += h / 2;
            const double t = step * h / (2 * line.wave_speed());
            for (std::size_t k = 0; k < cells.size(); ++k) {
                for (const double share : {0.1, 0.5, 0.9}) {
                    const State state = line.state(first + (static_cast<double>(k) + share) * h, t);
                    REQUIRE(std::abs(state.lambda - cells[k].lambda) <= 32 * eps);
                    REQUIRE(std::abs(state.v - cells[k].v) <= 32 * eps * line.wave_speed());
                }
            }
        }
    }
}

TEST_CASE("elastic line: positions are the integral of stretch, and of velocity", "[gate]") {
    Random random(41);
    for (int i = 0; i < 200; ++i) {
        const Data data = any_line(random, false);
        const ElasticLine line = line_of(data);
        CHECK(line.position(data.edges.front(), 0) == 0.4);
        const double c = line.wave_speed();
        const double t = random.uniform(0, 3) / c;
        const ElasticProfile profile = line.profile(t);
        for (std::size_t k = 1; k + 1 < profile.pieces.size(); ++k) {
            const auto& piece = profile.pieces[k];
            const auto& next = profile.pieces[k + 1];
            if (next.X - piece.X < 1e-9) continue;
            // Within a piece x rises by lambda dX, and state, place and inverse agree.
            const double X = 0.5 * (piece.X + next.X);
            CHECK(std::abs(line.position(next.X, t) - line.position(piece.X, t) -
                           piece.state.lambda * (next.X - piece.X)) <= 64 * eps * (10 + c * t));
            const State state = line.state(X, t);
            CHECK((state.lambda == piece.state.lambda && state.v == piece.state.v && state.T == piece.state.T));
            const double x = line.position(X, t);
            CHECK(std::abs(profile.reference(x) - X) <= 256 * eps * (10 + c * t));
            // Until the next wave comes, the particle moves with v.
            const double dt = 0.49 * (next.X - piece.X) / c;
            CHECK(std::abs(line.position(X, t + dt) - x - state.v * dt) <= 64 * eps * (10 + c * t));
        }
    }
}

TEST_CASE("elastic line: mass, momentum and energy are kept, and pass every jump", "[gate]") {
    Random random(43);
    for (int i = 0; i < 200; ++i) {
        const Data data = any_line(random, false);
        const ElasticLine line = line_of(data);
        const double c = line.wave_speed();
        const double t = random.uniform(0, 3) / c;
        const double box = 60;
        const ElasticProfile start = line.profile(0);
        const ElasticProfile now = line.profile(t);
        const auto before = line.averages(start, -box, box);
        const auto after = line.averages(now, -box, box);
        const auto L = line.fields(data.cells.front());
        const auto R = line.fields(data.cells.back());
        const auto gained = [&](std::size_t field) { return (after[field] - before[field]) * 2 * box / t; };
        const auto flux = [](const elastic::Row& row, std::size_t field) {
            if (field == density) return row[momentum];
            if (field == momentum) return row[momentum] * row[velocity] - row[stress];
            return (row[total_energy] - row[stress]) * row[velocity];
        };
        const double e = 8 * data.E;
        const double scale[]{e / (c * c), e / c, e};
        const std::size_t kept[]{density, momentum, total_energy};
        for (int k = 0; k < 3; ++k) {
            const double through = flux(L, kept[k]) - flux(R, kept[k]);
            CHECK(std::abs(gained(kept[k]) - through) <= 64 * eps * scale[k] * 2 * box / t);
        }
        // A jump moves at (flux difference) / (content difference), and the pieces say where it is a moment later.
        const double dt = 1e-3 / c;
        for (const double place : line.jumps(t)) {
            const auto a = line.fields(now.at(place - 1e-9).state);
            const auto b = line.fields(now.at(place + 1e-9).state);
            if (std::abs(b[momentum] - a[momentum]) < 1e-3 * e / c) continue;
            const double speed = (flux(b, momentum) - flux(a, momentum)) / (b[momentum] - a[momentum]);
            CHECK(std::abs(flux(b, total_energy) - flux(a, total_energy) -
                           speed * (b[total_energy] - a[total_energy])) <= 1e-9 * e * c);
            CHECK(std::abs(flux(b, density) - flux(a, density) - speed * (b[density] - a[density])) <= 1e-9 * e / c);
            bool moved = false;
            for (const double later : line.jumps(t + dt)) moved = moved || std::abs(later - place - speed * dt) < 1e-9;
            // Two jumps may have met in between; that is rare.
            if (line.jumps(t).size() == line.jumps(t + dt).size() && data.edges.size() == 2) CHECK(moved);
        }
    }
}

TEST_CASE("elastic line: what is no line, and what crushes it, is refused", "[unit]") {
    const State rest{1, 0, 0};
    CHECK_THROWS_WITH(ElasticLine(1, 1, 1, {}, {rest}, 0), ContainsSubstring("n edges"));
    CHECK_THROWS_WITH(ElasticLine(1, 1, 1, {0, 0}, {rest, rest, rest}, 0), ContainsSubstring("must rise"));
    CHECK_THROWS_WITH(ElasticLine(1, 1, 1, {0}, {rest, {0, 0, 0}}, 0), ContainsSubstring("must be > 0"));
    CHECK_THROWS_WITH(ElasticLine(1, 1, 1, {0}, {{1, 1, 0}, {1, -1, 0}}, 0), ContainsSubstring("collide too fast"));
    // Two fast outer parts close in on a quiet one of length 3: their waves meet after 3 / (2 c).
    const ElasticLine closing(4, 1, 1, {0, 3}, {{1, 3, 0}, {1, 0, 0}, {1, -3, 0}}, 0);
    CHECK(closing.crushed_at() == 0.75);
    CHECK_NOTHROW(closing.profile(0.7499));
    CHECK_THROWS_WITH(closing.profile(0.75), ContainsSubstring("from 0.75 s on"));
    CHECK(std::isinf(ElasticLine(4, 1, 1, {0, 3}, {rest, {0.3, 0, 0}, rest}, 0).crushed_at()));
}
