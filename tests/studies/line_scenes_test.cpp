// Each scene of a gas or an elastic line asks for what its truth answers: the same start, the same ends, and contents
// that change by what the ends let through.
#include <numeric>

#include "core/error.hpp"
#include "studies/engine/scene_entry.hpp"
#include "tests/catch.hpp"

using namespace ordo;
using namespace ordo::studies;
using solvers::Contents;
using solvers::LineEnd;

namespace {

struct Case {
    std::string name;
    Given given;
    double t = 0;  ///< before anything but what the ends say has reached them [s]
};

const Given states{{"lambda_L", 0.7}, {"v_L", 0.2}, {"T_L", 0.4},  {"lambda_R", 1.1}, {"v_R", -0.1},
                   {"T_R", 0.8},      {"E", 2.0},   {"rho0", 1.5}, {"c_v", 0.6},      {"x0", 0.3}};
const Given bar{{"lambda", 0.8}, {"v", 0.1}, {"T", 0.4}, {"E", 2.0}, {"rho0", 1.5}, {"c_v", 0.6}, {"x0", 0.3}};
const Given blast{{"E", 1e-4}, {"rho0", 1.3}, {"c_v", 0.6}, {"k", 0.8}, {"energy", 0.03}};

Given with(Given given, const Given& more) {
    for (const auto& [name, value] : more) given.insert_or_assign(name, value);
    return given;
}

std::vector<Case> cases() {
    std::vector<Case> list{
        {"gas_riemann", {}, 1.5},
        {"gas_riemann", {{"v_L", 0.7}, {"gamma", 1.6}, {"rho_R", 0.3}, {"p_R", 2.1}, {"x0", -0.5}}, 0.7},
        {"gas_pieces", {}, 2.5},
        {"gas_pieces", {{"v", 0.4}, {"rho", 0.3}, {"gamma", 1.6}, {"middle", 0.2}}, 2.5},
        {"inrush", {{"ends", "reservoir"}}, 1},
        {"inrush", {{"ends", "reservoir"}, {"gamma", 1.6}, {"v_M", 0.1}, {"x_L", -4.0}}, 1},
        {"gas_piston", {}, 2},
        {"gas_piston", {{"V", -0.6}, {"v", 0.2}, {"rho", 0.3}, {"p", 2.1}, {"x0", 0.4}}, 0.3},
        {"gas_piston", {{"V", 0.0}, {"v", -0.7}, {"gamma", 1.6}, {"length", 3.0}}, 1},
        {"slug_release", {}, 2},
        {"slug_release", {{"L0", 0.5}, {"lambda_c", 0.4}, {"E", 2.0}, {"rho0", 1.5}, {"T", 0.3}}, 0.7},
        {"linear_elastic_riemann", states, 0.7}};
    for (const std::string material : {"linear", "A", "B", "C"}) {
        const Given law{{"material", material}, {"k", 1.7}};
        if (material != "linear") list.push_back({"nonlinear_elastic_riemann", with(states, law), 0.7});
        list.push_back({"elastic_end", with(with(bar, law), {{"V", 0.4}}), 0.4});
        list.push_back({"elastic_end", with(with(bar, law), {{"V", -0.2}}), 0.4});
        list.push_back({"elastic_end", with(with(bar, law), {{"V", 0.0}, {"end", "free"}}), 0.4});
    }
    return list;
}

struct Bound {
    solvers::LineScene line;
    oracles::Exact truth;
};

Bound bound(const std::string& name, const Given& given) {
    const auto& entry = scene_named(name, "test");
    const Values values = resolve(entry.parameters, given, "test", name);
    return {std::get<solvers::LineScene>(entry.problem(values)), entry.truth(values)};
}

solvers::Flow flow_of(const solvers::LineScene& line, const Contents& piece) {
    return std::visit([&](const auto& medium) { return medium.flow(piece); }, line.medium);
}

double at(const Bound& scene, const std::string& field, double x, double t) {
    std::vector<double> row(scene.truth.width());
    scene.truth.sample({&x, 1}, t, row);
    return row[scene.truth.offset(field).value()];
}

Contents contents(const Bound& scene, double a, double b, double t) {
    std::vector<double> row(scene.truth.width());
    scene.truth.averages(std::array{a, b}, t, row);
    const auto mean = [&](const char* field) { return row[scene.truth.offset(field).value()]; };
    return (b - a) * Contents{mean("density"), mean("momentum"), mean("total_energy")};
}

Contents contents(const solvers::LineScene& line) {
    Contents sum;
    for (std::size_t i = 0; i < line.pieces.size(); ++i) sum += (line.edges[i + 1] - line.edges[i]) * line.pieces[i];
    return sum;
}

/// Largest difference, relative to the sizes of their sums.
double fault(const Contents& a, const Contents& b) {
    const double size = std::abs(a.mass) + std::abs(a.energy);
    return std::max({std::abs(a.mass - b.mass), std::abs(a.momentum - b.momentum), std::abs(a.energy - b.energy)}) /
           size;
}

constexpr double round_off = 1e-12;  // of the sizes, which are within a factor of ten of each other

/// Density, velocity, pressure and temperature of each piece by the solver's law, and at its middle by the truth.
double start_fault(const Bound& scene, double t = 0) {
    double worst = 0;
    const auto& line = scene.line;
    for (std::size_t i = 0; i < line.pieces.size(); ++i) {
        const auto piece = flow_of(line, line.pieces[i]);
        const double x = 0.5 * (line.edges[i] + line.edges[i + 1]);
        const double p = scene.truth.offset("pressure") ? at(scene, "pressure", x, t) : -at(scene, "stress", x, t);
        worst = std::max({worst, std::abs(piece.rho - at(scene, "density", x, t)) / piece.rho,
                          std::abs(piece.v - at(scene, "velocity", x, t)) / piece.a,
                          std::abs(piece.p - p) / (piece.rho * piece.a * piece.a)});
        if (scene.truth.offset("temperature"))
            worst = std::max(worst, std::abs(piece.T - at(scene, "temperature", x, t)));
    }
    return worst;
}

/// What an end lets in until t: of a reservoir the flux of its piece, of a wall its pressure on the gas that moves
/// with it, of a free end nothing.
Contents let_in(const Bound& scene, std::size_t side, double t, double place) {
    const auto& end = scene.line.ends[side];
    const auto& piece = side == 0 ? scene.line.pieces.front() : scene.line.pieces.back();
    const double sign = side == 0 ? 1 : -1;
    if (end.kind == LineEnd::Kind::reservoir) return sign * t * solvers::flux(piece, flow_of(scene.line, piece));
    if (end.kind == LineEnd::Kind::free) return {};
    const double p = scene.truth.offset("pressure") ? at(scene, "pressure", place, t) : -at(scene, "stress", place, t);
    return sign * t * Contents{0, p, p * end.velocity};
}

/// The truth's contents at t less the scene's and what has come in.
double balance_fault(const Bound& scene, double t) {
    const auto& line = scene.line;
    double from = line.edges.front();
    if (line.ends[0].kind == LineEnd::Kind::wall) from += line.ends[0].velocity * t;
    if (line.ends[0].kind == LineEnd::Kind::free) {
        for (const auto& [name, value] : scene.truth.constants(t)) {
            if (name == "x_end") from = std::get<double>(value);
        }
    }
    const Contents came = let_in(scene, 0, t, from) + let_in(scene, 1, t, line.edges.back());
    return fault(contents(scene, from, line.edges.back(), t), contents(line) + came);
}

}  // namespace

TEST_CASE("line scenes: the pieces are the truth's start", "[unit]") {
    for (const auto& [name, given, t] : cases()) {
        INFO(name);
        const auto scene = bound(name, given);
        CHECK(scene.line.edges.size() == scene.line.pieces.size() + 1);
        CHECK(std::is_sorted(scene.line.edges.begin(), scene.line.edges.end()));
        CHECK(start_fault(scene) <= round_off);
        CHECK(balance_fault(scene, 0) <= round_off);
    }
    for (const Given& given : {Given{}, Given{{"begin", 0.75}, {"v", -0.4}}, Given{{"begin", 0.0}, {"L", 3.0}}}) {
        const auto scene = bound("density_pulse", given);
        CHECK(start_fault(scene) <= round_off);
        CHECK(fault(contents(scene, 0, scene.truth.upper[0], 0.37), contents(scene.line)) <= round_off);
        for (const auto& end : scene.line.ends) CHECK(end.kind == LineEnd::Kind::periodic);
        CHECK((scene.line.edges.front() == 0 && scene.line.edges.back() == scene.truth.upper[0]));
    }
}

TEST_CASE("line scenes: the truth's contents change by what the ends let in", "[property]") {
    for (const auto& [name, given, t] : cases()) {
        const auto scene = bound(name, given);
        for (const double share : {0.1, 0.6, 1.0}) {
            INFO(name << " at t = " << share * t);
            CHECK(balance_fault(scene, share * t) <= round_off);
        }
    }
}

TEST_CASE("line scenes: prescribed ends hold what the reservoirs of the inrush hold", "[unit]") {
    const auto held = bound("inrush", {}), endless = bound("inrush", {{"ends", "reservoir"}});
    CHECK((held.line.pieces.size() == 1 && held.line.pieces[0] == endless.line.pieces[1]));
    CHECK(held.line.ends[0].outside == endless.line.pieces[0]);
    CHECK(held.line.ends[1].outside == endless.line.pieces[2]);
    for (const auto& end : held.line.ends) CHECK(end.kind == LineEnd::Kind::prescribed);
    // At a held end the truth is uniform in x > x_L: no part of the fan is inside.
    CHECK(at(held, "pressure", -5 + 1e-9, 2) == at(held, "pressure", -5 + 1e-3, 2));
    CHECK(at(held, "pressure", 5 - 1e-9, 2) == at(held, "pressure", 5 - 1e-3, 2));
    CHECK_FALSE(held.truth.times.contains(3.7));
}

TEST_CASE("line scenes: a strip holds the energy of a blast to both sides", "[unit]") {
    for (const Given& given : {Given{}, Given{{"energy", 0.2}, {"rho0", 1.3}, {"gamma", 1.6}, {"width", 0.02}}}) {
        const auto scene = bound("gas_blast", given);
        const double energy = given.empty() ? 0.1346857 : 0.4;
        const double ahead = scene.line.pieces.front().energy * (scene.line.edges.back() - scene.line.edges.front());
        CHECK(contents(scene.line).energy - ahead == Approx(energy).epsilon(1e-12));
        // Behind the shock, whose energy is wholly in the flow: mass, and symmetry.
        const double r = scene.truth.jumps(0.3).back();
        CHECK(scene.truth.jumps(0.3).front() == -r);
        CHECK(at(scene, "velocity", -0.4 * r, 0.3) == -at(scene, "velocity", 0.4 * r, 0.3));
        CHECK(at(scene, "density", -0.4 * r, 0.3) == at(scene, "density", 0.4 * r, 0.3));
        CHECK(at(scene, "velocity", 0.4 * r, 0.3) > 0);
        CHECK(scene.truth.waves(0.3).size() == 2);
        CHECK(at(scene, "density", 0.7, 1e-6) == Approx(scene.line.pieces.front().mass));
    }
    CHECK(bound("gas_blast", {}).truth.jumps(1).back() == Approx(0.5).epsilon(1e-6));  // KammTimmes2007's planar case
    for (const Given& given : {Given{}, blast, with(blast, {{"material", "C"}})}) {
        const auto scene = bound("elastic_blast", given);
        CHECK(contents(scene.line).energy == Approx(given.empty() ? 2 * 0.0228957348 : 0.06).epsilon(1e-12));
        CHECK(flow_of(scene.line, scene.line.pieces.front()).p == 0);
        CHECK(at(scene, "density", 0.7, 1e-6) == Approx(scene.line.pieces.front().mass));
    }
}

TEST_CASE("line scenes: what does not go together is refused with the nearest choice", "[unit]") {
    const auto refusal = [](const std::string& name, const Given& given) -> std::string {
        try {
            bound(name, given);
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    };
    CHECK_THAT(refusal("gas_riemann", {{"x0", 6.0}}),
               ContainsSubstring("x_right = 5") && ContainsSubstring("nearest: 7"));
    CHECK_THAT(refusal("gas_riemann", {{"rho_L", 0.0}}), ContainsSubstring("rho_L"));
    CHECK_THAT(refusal("gas_blast", {{"x_left", 0.0}}),
               ContainsSubstring("x_left") && ContainsSubstring("nearest: -0.001"));
    CHECK_THAT(refusal("inrush", {{"v_L", -2.0}}), ContainsSubstring("nearest: ends = reservoir"));
    CHECK(refusal("inrush", {{"v_L", -2.0}, {"ends", "reservoir"}}).empty());
    CHECK_THAT(refusal("elastic_end", {{"material", "linear"}, {"V", 2.0}}), ContainsSubstring("nearest: V = 0.5"));
    CHECK_THAT(refusal("density_pulse", {{"width", 2.0}}), ContainsSubstring("nearest: 0.5"));
    CHECK_THAT(refusal("slug_release", {{"x_right", 0.01}}), ContainsSubstring("x_right"));
}

TEST_CASE("alarm: a line scene that asks for something else is found", "[alarm]") {
    for (const auto& [name, given, t] : cases()) {
        INFO(name);
        const auto good = bound(name, given);
        auto scene = good;
        scene.line.pieces.back() = (1 + 1e-6) * good.line.pieces.back();
        CHECK(start_fault(scene) > 1e-8);
        CHECK(balance_fault(scene, t) > 1e-8);
        scene = good;
        if (scene.line.pieces.size() > 1 && name != "gas_pieces") {
            scene.line.edges[1] += 1e-6;
            CHECK(balance_fault(scene, t) > 1e-8);
        }
        if (scene.line.ends[0].kind == LineEnd::Kind::wall) {
            scene.line.ends[0].velocity += 1e-6;
            CHECK(balance_fault(scene, t) > 1e-8);
        }
        scene = good;
        const auto changed = [](auto law) -> solvers::Medium {
            if constexpr (requires { law.gamma; }) law.gamma += 1e-6;
            else law.E += 1e-6;
            return law;
        };
        scene.line.medium = std::visit(changed, scene.line.medium);
        CHECK(start_fault(scene) > 1e-8);
    }
}
