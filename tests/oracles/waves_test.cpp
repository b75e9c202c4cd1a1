// Where the exact solutions say that their waves are, held against their own fields: nothing else jumps or bends.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "oracles/oracle.hpp"
#include "tests/catch.hpp"

using namespace ordo;
using namespace ordo::oracles;
using Kind = Wave::Kind;

namespace {

Exact bound(const std::string& name, const Given& given) {
    const Oracle& oracle = oracle_named(name, "test");
    return oracle.bind(resolve(oracle.parameters, given, "test", name));
}

std::vector<double> row_at(const Exact& exact, double x, double t) {
    std::vector<double> row(exact.width());
    exact.sample(std::span(&x, 1), t, row);
    return row;
}

/// Largest difference of two rows; fields without a value on both sides do not differ.
double difference(const std::vector<double>& a, const std::vector<double>& b) {
    double largest = 0;
    for (std::size_t k = 0; k < a.size(); ++k) {
        if (std::isnan(a[k]) != std::isnan(b[k])) return INFINITY;
        if (!std::isnan(a[k])) largest = std::max(largest, std::abs(a[k] - b[k]));
    }
    return largest;
}

double jump_of(const Exact& exact, const std::string& field, double x, double t) {
    const auto k = *exact.offset(field);
    return row_at(exact, x + 1e-9, t)[k] - row_at(exact, x - 1e-9, t)[k];
}

struct Problem {
    std::string oracle;
    Given given;
    double t;
    std::vector<Kind> kinds;
};

/// Riemann problems, uniform outside of their fans.
const std::vector<Problem> riemann_problems{
    {"riemann_gas", {}, 1.5, {Kind::fan, Kind::contact, Kind::shock}},
    {"riemann_gas",
     {{"v_L", -2.0}, {"v_R", 2.0}, {"rho_R", 1.0}, {"p_R", 1.0}, {"x0", 0.5}},
     1,
     {Kind::fan, Kind::fan}},
    {"riemann_gas", {{"v_L", 2.0}, {"v_R", -2.0}}, 1, {Kind::shock, Kind::contact, Kind::shock}},
    {"riemann_gas", {{"rho_R", 0.0}, {"p_R", 0.0}}, 1, {Kind::fan}},
    {"riemann_gas", {{"v_L", -20.0}, {"v_R", 20.0}}, 1, {Kind::fan, Kind::fan}},
    {"riemann_linear_elastic",
     {{"v_L", 0.1}, {"T_L", 1.0}, {"T_R", 2.0}},
     1.5,
     {Kind::shock, Kind::contact, Kind::shock}},
    {"riemann_nonlinear_elastic",
     {{"v_L", -1.5}, {"v_R", 1.5}, {"T_L", 1.0}, {"T_R", 2.0}},
     2,
     {Kind::fan, Kind::contact, Kind::fan}},
    {"riemann_nonlinear_elastic",
     {{"lambda_L", 0.7}, {"lambda_R", 1.4}, {"v_L", 0.0}, {"v_R", -0.0}, {"T_L", 0.2}, {"T_R", 0.1}, {"x0", -1.0}},
     1.5,
     {Kind::fan, Kind::contact, Kind::shock}},
    {"sedov_linear_elastic", {}, 0.1, {Kind::shock, Kind::shock, Kind::shock, Kind::shock}},
    {"sedov_linear_elastic", {}, 2, {Kind::shock, Kind::shock, Kind::shock, Kind::shock}}};

}  // namespace

TEST_CASE("waves: in order, of the right kinds, and every jump is one of them", "[gate]") {
    for (const auto& [oracle, given, t, kinds] : riemann_problems) {
        INFO(oracle << " at t = " << t);
        const Exact exact = bound(oracle, given);
        const auto waves = exact.waves(t);
        REQUIRE(waves.size() == kinds.size());
        std::vector<double> places;
        for (std::size_t i = 0; i < waves.size(); ++i) {
            CHECK(waves[i].kind == kinds[i]);
            CHECK((waves[i].kind == Kind::fan ? waves[i].left < waves[i].right : waves[i].left == waves[i].right));
            if (i > 0) CHECK(waves[i - 1].right <= waves[i].left);
            if (waves[i].kind != Kind::fan) places.push_back(waves[i].left);
        }
        for (const double jump : exact.jumps(t)) CHECK(std::ranges::find(places, jump) != places.end());
    }
}

TEST_CASE("waves: between them nothing happens, and through a fan the fields move without a jump", "[gate]") {
    for (const auto& [oracle, given, t, kinds] : riemann_problems) {
        INFO(oracle << " at t = " << t);
        Exact exact = bound(oracle, given);
        std::erase_if(exact.fields, [](const FieldInfo& field) { return field.name == "displacement"; });
        const auto waves = exact.waves(t);
        const std::size_t width = exact.width();
        const auto row = [&](double x) {
            auto all = std::vector<double>(bound(oracle, given).width());
            exact.sample(std::span(&x, 1), t, all);
            all.resize(width);  // displacement is the last one
            return all;
        };
        for (std::size_t i = 0; i <= waves.size(); ++i) {
            const double from = i == 0 ? waves.front().left - 1 : waves[i - 1].right;
            const double to = i == waves.size() ? waves.back().right + 1 : waves[i].left;
            if (to - from < 1e-6) continue;
            CHECK(difference(row(from + 1e-7), row(to - 1e-7)) < 1e-12);
        }
        for (const auto& wave : waves) {
            const auto before = row(wave.left - 1e-9), after = row(wave.right + 1e-9);
            CHECK(difference(before, after) > 1e-3);
            if (wave.kind != Kind::fan || difference(before, after) == INFINITY) continue;
            CHECK(difference(row(wave.left + 1e-9), before) < 1e-7);
            CHECK(difference(row(wave.right - 1e-9), after) < 1e-7);
        }
    }
}

TEST_CASE("waves: matter runs through a shock and not through a contact", "[gate]") {
    for (const auto& [oracle, given, t, kinds] : riemann_problems) {
        INFO(oracle << " at t = " << t);
        const Exact exact = bound(oracle, given);
        const std::string force = exact.offset("pressure") ? "pressure" : "stress";
        for (const auto& wave : exact.waves(t)) {
            if (wave.kind == Kind::fan) continue;
            INFO("wave at " << wave.left);
            const bool pushes = std::abs(jump_of(exact, force, wave.left, t)) > 1e-9;
            CHECK(pushes == (wave.kind == Kind::shock));
            CHECK((std::abs(jump_of(exact, "velocity", wave.left, t)) > 1e-9) == (wave.kind == Kind::shock));
        }
    }
}

TEST_CASE("waves: the shocks of blasts, and a core's edge", "[gate]") {
    const double t = 0.7;
    for (const std::string oracle : {"sedov", "sedov_nonlinear_elastic"}) {
        const Exact exact = bound(oracle, {});
        for (const auto& wave : exact.waves(t)) {
            CHECK(wave.kind == Kind::shock);
            CHECK(std::abs(jump_of(exact, "density", wave.left, t)) > 1);
        }
        CHECK(exact.waves(t).size() == exact.jumps(t).size());
    }
    // omega above (3 j - 2 + gamma (2 - j)) / (gamma + 1) = 2.333 leaves an empty core.
    const Exact hollow = bound("sedov", {{"omega", 2.6}});
    const auto waves = hollow.waves(t);
    REQUIRE(waves.size() == 2);
    CHECK(waves[0].kind == Kind::contact);
    CHECK(row_at(hollow, waves[0].left * (1 - 1e-9), t)[*hollow.offset("density")] == 0);
    CHECK(row_at(hollow, waves[0].left * (1 + 1e-9), t)[*hollow.offset("density")] > 0);
    CHECK(waves[1].kind == Kind::shock);
}
