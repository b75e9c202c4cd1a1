// What a fixed grid keeps: contents, symmetry, uniform flow, and the same flow seen from a moving place.
#include <algorithm>

#include "tests/solvers/godunov/lines.hpp"

using namespace ordo;
using namespace ordo::solvers;
using namespace ordo::solvers::godunov;
using namespace ordo::solvers::godunov::test;

namespace {

using Kind = LineEnd::Kind;

const std::vector<Given> schemes{{{"order", "first"}},
                                 {{"order", "first"}, {"flux", "hll"}, {"speeds", "davis"}},
                                 {{"speeds", "einfeldt"}, {"limiter", "minmod"}},
                                 {{"limiter", "superbee"}},
                                 {{"flux", "hll"}, {"limiter", "van_leer"}},
                                 {{"speeds", "acoustic"}, {"limiter", "mc"}}};

/// Three pieces on [0, 3] whose waves reach both ends before t = 2.
LineScene busy_gas(const LineEnd& left, const LineEnd& right) {
    const IdealGas gas{1.3};
    return {gas,
            {0, 1, 1.7, 3},
            {gas.contents(1, 0.3, 1), gas.contents(0.4, -0.2, 2), gas.contents(2, 0.1, 0.5)},
            {left, right}};
}

LineScene busy_rubber(const LineEnd& left, const LineEnd& right) {
    const ElasticMedium<RubberEnergy> line{.E = 2, .rho0 = 1.5, .c_v = 0.7, .k = 1};
    return {line,
            {0, 1, 1.7, 3},
            {line.contents(0.8, 0.3, 0.4), line.contents(1.25, -0.1, 0.9), line.contents(1, 0, 0.2)},
            {left, right}};
}

/// Contents of the line by the snapshot's own means and widths.
double held(const Snapshot& shot, const std::string& name) {
    double sum = 0;
    for (std::size_t i = 0; i < shot.points(); ++i) sum += shot.weights[i] * shot.field(name).values[i];
    return sum;
}

Contents mirrored(const Contents& q) { return {q.mass, -q.momentum, q.energy}; }

LineScene mirrored(LineScene scene) {
    std::reverse(scene.edges.begin(), scene.edges.end());
    for (double& edge : scene.edges) edge = -edge;
    std::reverse(scene.pieces.begin(), scene.pieces.end());
    for (Contents& q : scene.pieces) q = mirrored(q);
    std::swap(scene.ends[0], scene.ends[1]);
    for (LineEnd& end : scene.ends) end.outside = mirrored(end.outside);
    return scene;
}

}  // namespace

TEST_CASE("godunov: drift figures are round-off, whatever the ends are", "[property]") {
    const auto options = GENERATE(from_range(schemes));
    const IdealGas gas{1.3};
    const LineEnd held_outside{.kind = Kind::prescribed, .outside = gas.contents(0.7, 0.4, 1.2)};
    const auto ends =
        GENERATE_COPY(std::array<LineEnd, 2>{LineEnd{}, LineEnd{.kind = Kind::wall}},
                      std::array<LineEnd, 2>{LineEnd{.kind = Kind::periodic}, LineEnd{.kind = Kind::periodic}},
                      std::array<LineEnd, 2>{LineEnd{.kind = Kind::wall}, held_outside});
    const auto run = started(busy_gas(ends[0], ends[1]), options, {{"cells", 250.0}});
    for (const std::string name : {"mass", "momentum", "energy"}) CHECK(figure(run->drift(), name) == 0);
    run->advance_to(0.7, never);
    run->advance_to(2, never);
    // Some 1000 steps, each with a rounded update of 250 cells.
    for (const std::string name : {"mass", "momentum", "energy"}) CHECK(figure(run->drift(), name) < 1e-13);
}

TEST_CASE("godunov: between walls, mass and energy stay; on a circle momentum too", "[property]") {
    const auto options = GENERATE(from_range(schemes));
    const auto kind = GENERATE(Kind::wall, Kind::periodic);
    const LineEnd end{.kind = kind};
    Given elastic = options;
    if (!elastic.contains("speeds")) elastic["speeds"] = "davis";
    const auto check = [&](const LineScene& scene, const Given& given, const std::vector<std::string>& fields) {
        const auto run = started(scene, given, {{"cells", 250.0}}, fields);
        const auto before = run->snapshot();
        run->advance_to(2, never);
        const auto after = run->snapshot();
        CHECK(std::abs(held(after, "density") / held(before, "density") - 1) < 1e-13);
        CHECK(std::abs(held(after, "total_energy") / held(before, "total_energy") - 1) < 1e-13);
        const double change = std::abs(held(after, "momentum") - held(before, "momentum"));
        if (kind == Kind::periodic) CHECK(change < 1e-13);
        else CHECK(change > 1e-3);
    };
    check(busy_gas(end, end), options, gas_fields);
    check(busy_rubber(end, end), elastic, elastic_fields);
}

TEST_CASE("godunov: what passes the ends is what the balance misses", "[property]") {
    // The momentum of a gas at rest between a wall and a reservoir at other pressure: (p_wall - p_outside) t, exactly
    // so while waves are away from both ends.
    const IdealGas gas;
    const LineScene scene{
        gas, {0, 1, 2}, {gas.contents(1, 0, 1), gas.contents(1, 0, 0.4)}, {LineEnd{.kind = Kind::wall}, LineEnd{}}};
    const auto shot = at(scene, 0.3, {}, {{"cells", 100.0}});
    CHECK(std::abs(held(shot, "momentum") - 0.6 * 0.3) < 1e-13);
}

TEST_CASE("godunov: the mirror image of a line has the mirror image of its flow", "[property]") {
    const auto options = GENERATE(from_range(schemes));
    const IdealGas gas{1.3};
    const auto scene =
        busy_gas({.kind = Kind::prescribed, .outside = gas.contents(0.7, 0.4, 1.2)}, {.kind = Kind::wall});
    const auto one = at(scene, 1, options, {{"cells", 90.0}});
    const auto other = at(mirrored(scene), 1, options, {{"cells", 90.0}});
    double worst = 0;
    for (const std::string name : {"density", "velocity", "pressure"}) {
        const double sign = name == "velocity" ? -1 : 1;
        const auto& a = one.field(name).values;
        const auto& b = other.field(name).values;
        for (std::size_t i = 0; i < a.size(); ++i) worst = std::max(worst, std::abs(a[i] - sign * b[a.size() - 1 - i]));
    }
    // Sums in the other order, grown over 100 steps of shocks.
    CHECK(worst < 1e-11);
}

TEST_CASE("godunov: uniform flow is left alone to the last bit", "[property]") {
    const auto options = GENERATE(from_range(schemes));
    const double v = GENERATE(0.0, 0.3, -2.7);
    const IdealGas gas;
    const Contents q = gas.contents(0.7, v, 1.3);
    const auto kind = GENERATE(Kind::reservoir, Kind::periodic);
    const LineScene scene{gas, {-1, 2}, {q}, {LineEnd{.kind = kind}, LineEnd{.kind = kind}}};
    const auto run = started(scene, options, {{"cells", 37.0}});
    run->advance_to(1, never);
    const auto shot = run->snapshot();
    CHECK(std::all_of(shot.field("density").values.begin(), shot.field("density").values.end(),
                      [&](double rho) { return rho == q.mass; }));
    CHECK(std::all_of(shot.field("momentum").values.begin(), shot.field("momentum").values.end(),
                      [&](double m) { return m == q.momentum; }));
    CHECK(std::all_of(shot.field("total_energy").values.begin(), shot.field("total_energy").values.end(),
                      [&](double e) { return e == q.energy; }));
}

TEST_CASE("godunov: a contact at rest stays sharp with HLLC, and spreads with HLL", "[property]") {
    const IdealGas gas;
    const LineScene scene{gas, {-1, 0, 1}, {gas.contents(1, 0, 1), gas.contents(0.2, 0, 1)}};
    const auto error = [&](const Given& options) {
        return l1(at(scene, 1, options, {{"cells", 100.0}}), "density", [](double x) { return x < 0 ? 1 : 0.2; });
    };
    CHECK(error({}) < 1e-13);
    CHECK(error({{"order", "first"}}) < 1e-13);
    CHECK(error({{"flux", "hll"}}) > 1e-2);
}

TEST_CASE("godunov: a moving contact keeps velocity and pressure uniform", "[property]") {
    // Of a gas at uniform v and p all contents are linear in density, so that each limiter treats them alike.
    const auto options = GENERATE(from_range(schemes));
    const IdealGas gas;
    const LineScene scene{gas, {-1, 0, 1}, {gas.contents(1, 0.3, 1), gas.contents(0.2, 0.3, 1)}};
    const auto shot = at(scene, 1, options, {{"cells", 100.0}});
    for (const double v : shot.field("velocity").values) CHECK(std::abs(v - 0.3) < 1e-12);
    for (const double p : shot.field("pressure").values) CHECK(std::abs(p - 1) < 1e-12);
}

TEST_CASE("godunov: seen from a moving place the flow is the same up to the scheme's error", "[property]") {
    // A fixed grid is not invariant, but both views converge to one flow: their distance is of the order of the error.
    const double boost = 1.5;
    const auto view = [&](double cells, double v) {
        const auto shot = at(sod.scene(0, v), 1, {}, {{"cells", cells}});
        const oracles::RiemannGas exact(sod.left, sod.right);
        return l1(shot, "density", [&](double x) { return exact.at(x - v, 1).density; });
    };
    for (const double v : {boost, -boost}) {
        CHECK(view(400, v) < 2.5 * view(400, 0));
        CHECK(view(800, v) < 0.65 * view(400, v));
    }
}
