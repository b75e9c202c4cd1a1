// Mass, momentum and energy: what the solver counts of itself, and what its snapshots say without its help.
#include "tests/solvers/rrm/lines.hpp"

using namespace ordo;
using namespace ordo::solvers;
using namespace ordo::solvers::rrm;
using namespace ordo::solvers::rrm::test;

namespace {

using Kind = LineEnd::Kind;

constexpr double closed = 1e-12;  ///< relative; some thousand sums of doubles lose less than 1e-13

/// Five unequal pieces on [0, 1], with jumps of every sign, weak enough for own speeds in a gas.
template <class M>
LineScene pieces_of(const M& medium, const LineEnd& left, const LineEnd& right) {
    const auto piece = [&](double first, double v, double third) { return medium.contents(first, v, third); };
    return {medium,
            {0, 0.13, 0.37, 0.5, 0.81, 1},
            {piece(1, 0.1, 1), piece(0.8, -0.1, 1.2), piece(1.1, 0.15, 0.7), piece(1, 0, 1), piece(0.9, 0.05, 0.9)},
            {left, right}};
}

std::vector<LineScene> lines_between(const LineEnd& left, const LineEnd& right) {
    return {pieces_of(IdealGas{}, left, right), pieces_of(ElasticMedium<HookeEnergy>{.E = 2, .rho0 = 1.5}, left, right),
            pieces_of(ElasticMedium<RubberEnergy>{.k = 1}, left, right),
            pieces_of(ElasticMedium<ReciprocalEnergy>{.k = 0.5}, left, right),
            pieces_of(ElasticMedium<LogarithmicEnergy>{.E = 3, .k = 2}, left, right)};
}

constexpr double few = 3e4;  ///< events: a run here needs less than a tenth of them
const std::vector<Given> ways{
    {{"keep", "nothing"}, {"most_events", few}},  {{"keep", "nothing"}, {"speeds", "own"}, {"most_events", few}},
    {{"keep", "contacts"}, {"most_events", few}}, {{"keep", "contacts"}, {"speeds", "own"}, {"most_events", few}},
    {{"keep", "waves"}, {"most_events", few}},    {{"keep", "waves"}, {"speeds", "own"}, {"most_events", few}}};

/// What a snapshot holds, and the same with all parts taken as positive.
struct Held {
    Contents sum, size;
};
Held held(const Snapshot& shot) {
    Held found;
    for (std::size_t i = 0; i < shot.points(); ++i) {
        const double w = shot.weights[i];
        const Contents q{shot.field("density").values[i], shot.field("momentum").values[i],
                         shot.field("total_energy").values[i]};
        found.sum += w * q;
        found.size += w * Contents{std::abs(q.mass), std::abs(q.momentum), std::abs(q.energy)};
    }
    return found;
}

Contents held(const LineScene& scene) {
    Contents sum;
    for (std::size_t i = 0; i < scene.pieces.size(); ++i)
        sum += (scene.edges[i + 1] - scene.edges[i]) * scene.pieces[i];
    return sum;
}

double largest_pressure(const LineScene& scene) {
    double p = 0;
    for (const auto& q : scene.pieces)
        p = std::max(p, std::visit([&](const auto& medium) { return std::abs(medium.flow(q).p); }, scene.medium));
    return p;
}

Contents flux_of(const LineScene& scene, const Contents& q) {
    return std::visit([&](const auto& medium) { return flux(q, medium.flow(q)); }, scene.medium);
}

/// Relative defects of what a snapshot holds against `expected`.
Contents defect(const LineScene& scene, const Snapshot& shot, const Contents& expected) {
    const Held found = held(shot);
    const double push = largest_pressure(scene) * shot.t;
    return {std::abs(found.sum.mass - expected.mass) / found.size.mass,
            std::abs(found.sum.momentum - expected.momentum) / (found.size.momentum + push),
            std::abs(found.sum.energy - expected.energy) / (found.size.energy + push)};
}

}  // namespace

TEST_CASE("rrm: what the solver counts of itself closes between all kinds of ends", "[property]") {
    const LineEnd standing{Kind::wall}, pushing{Kind::wall, 0.2}, pulling{Kind::wall, -0.2}, open{Kind::reservoir};
    for (const auto& left : {standing, pushing, pulling, open, LineEnd{Kind::prescribed}, LineEnd{Kind::free}}) {
        for (const auto& right : {standing, pushing, pulling, open, LineEnd{Kind::prescribed}, LineEnd{Kind::free}}) {
            for (LineScene scene : lines_between(left, right)) {
                const bool gas = std::holds_alternative<IdealGas>(scene.medium);
                if (gas && (left.kind == Kind::free || right.kind == Kind::free)) continue;
                scene.ends[0].outside = scene.pieces[1];
                scene.ends[1].outside = scene.pieces[2];
                for (const Given& way : ways) {
                    CAPTURE(int(left.kind), left.velocity, int(right.kind), right.velocity, scene.medium.index(),
                            text_of(way.at("keep")), way.contains("speeds"));
                    CHECK(worst_drift(*run_to(0.5, scene, way, 0.03)) <= closed);
                }
            }
        }
    }
}

TEST_CASE("rrm: a ring keeps its contents", "[property]") {
    const LineEnd ring{Kind::periodic};
    for (const LineScene& scene : lines_between(ring, ring)) {
        for (const Given& way : ways) {
            CAPTURE(scene.medium.index(), text_of(way.at("keep")), way.contains("speeds"));
            const auto run = run_to(1, scene, way, 0.01);
            const Contents off = defect(scene, run->snapshot(), held(scene));
            CHECK(off.mass <= closed);
            CHECK(off.momentum <= closed);
            CHECK(off.energy <= closed);
            CHECK(worst_drift(*run) <= closed);
        }
    }
}

TEST_CASE("rrm: a box keeps mass and energy, and what flies freely also its momentum", "[property]") {
    for (const Kind kind : {Kind::wall, Kind::free}) {
        const LineEnd end{kind};
        for (const LineScene& scene : lines_between(end, end)) {
            if (kind == Kind::free && std::holds_alternative<IdealGas>(scene.medium)) continue;
            for (const Given& way : ways) {
                CAPTURE(int(kind), scene.medium.index(), text_of(way.at("keep")), way.contains("speeds"));
                const Contents off = defect(scene, at(0.7, scene, way, 0.01), held(scene));
                CHECK(off.mass <= closed);
                CHECK(off.energy <= closed);
                if (kind == Kind::free) CHECK(off.momentum <= closed);
            }
        }
    }
}

TEST_CASE("rrm: what flows in at the ends of a wide line is what the end states bring", "[property]") {
    const LineEnd open;
    for (LineScene scene : lines_between(open, open)) {
        scene.edges.front() = -6;
        scene.edges.back() = 7;
        for (const Given& way : ways) {
            CAPTURE(scene.medium.index(), text_of(way.at("keep")), way.contains("speeds"));
            const double t = 0.7;
            const Contents passed = t * (flux_of(scene, scene.pieces.front()) - flux_of(scene, scene.pieces.back()));
            const Contents off = defect(scene, at(t, scene, way, 0.01), held(scene) + passed);
            CHECK(off.mass <= closed);
            CHECK(off.momentum <= closed);
            CHECK(off.energy <= closed);
        }
    }
}

TEST_CASE("rrm: a piston brings in its work", "[property]") {
    // The wall's push is the pressure behind one wave into a uniform gas: an exact solution, whatever the method keeps.
    const IdealGas gas;
    const LineScene scene{gas, {0, 2}, {gas.contents(1, 0, 1)}, {LineEnd{Kind::wall, 0.5}, LineEnd{}}};
    const oracles::RiemannGas mirrored({.rho = 1, .v = 1, .p = 1}, {.rho = 1, .v = 0, .p = 1});
    const double t = 0.5;
    const double p = mirrored.star().p;
    const Contents expected = held(scene) + t * Contents{0, p - 1, p * 0.5};
    const Contents off = defect(scene, at(t, scene, {{"keep", "waves"}}, 0.01), expected);
    CHECK(off.mass <= closed);
    CHECK(off.momentum <= closed);
    CHECK(off.energy <= closed);
}
