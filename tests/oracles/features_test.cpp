// What exact solutions say is not smooth in their fields, held against the fields themselves: sampled on a line,
// without a formula of theirs.
#include "oracles/features.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/catch.hpp"

using namespace ordo;
using namespace ordo::oracles;

namespace {

/// A solution on the part [from, to] of its line.
struct Problem {
    std::string oracle;
    Given given;
    double t, from, to;
};

const std::vector<Problem> problems{
    {"bar_vibration", {}, 0.5, 0, 25},
    {"bar_traction", {}, 0.7, 0, 1},
    {"bar_traction", {{"tau", -2.0}, {"omega", 5.0}, {"E", 300.0}}, 2.1, 0, 1},
    {"bar_traction", {{"profile", "step"}}, 0.4, 0, 1},
    {"bar_traction", {{"profile", "step"}, {"L", 3.0}}, 7.3, 0, 3},
    {"oedometer", {{"p0", -50.0}}, 0.09, 0, 25},
    {"oedometer", {}, 0.03, 0, 25},
    {"oedometer", {{"ramp", 0.02}}, 0.05, 0, 25},
    {"oedometer", {{"terms", 5.0}}, 0.05, 0, 25},
    {"oedometer_static", {}, 1, 0, 50},
    {"bar_mms", {}, 0.01, 0, 1},
    {"periodic_bar_mms", {}, 0.01, 0, 1},
    {"riemann_gas", {}, 1.5, -4, 4},
    {"riemann_gas", {{"v_L", 2.0}, {"v_R", -2.0}}, 1, -3, 3},
    {"riemann_gas", {{"v_L", 0.3}, {"v_R", 0.3}, {"p_R", 1.0}, {"rho_R", 0.2}}, 1, -1, 2},
    {"riemann_gas", {{"p_R", 1.0}, {"rho_R", 0.2}}, 1, -1, 2},
    {"riemann_gas", {{"rho_R", 0.0}, {"p_R", 0.0}}, 1, -2, 7},
    {"riemann_linear_elastic", {{"v_L", 0.1}, {"T_L", 1.0}, {"T_R", 2.0}}, 1.5, -3, 3},
    {"riemann_nonlinear_elastic", {{"v_L", -1.5}, {"v_R", 1.5}, {"T_L", 1.0}, {"T_R", 2.0}}, 2, -8, 8},
    {"riemann_nonlinear_elastic", {{"lambda_L", 0.7}, {"lambda_R", 1.4}, {"T_L", 0.2}, {"T_R", 0.1}}, 1.5, -6, 6},
    {"shock_collision", {}, 1, -8, 8},
    {"gas_piston", {}, 1, 1, 4},
    {"gas_piston", {{"V", -0.5}}, 1, -0.4, 4},
    {"elastic_end", {}, 1, 0.5, 4},
    {"elastic_end", {{"material", "linear"}}, 1, 0.5, 4},
    {"density_pulse", {}, 0.1, 0, 1},
    {"sedov", {}, 0.7, 0.3, 2},
    {"sedov_nonlinear_elastic", {}, 0.7, 0.2, 3},
    {"sedov_linear_elastic", {}, 0.1, -2, 2},
    {"sedov_linear_elastic", {}, 2, -4, 4},
    {"noh", {{"geometry", "spherical"}}, 0.6, 0.01, 1}};

Exact bound(const Problem& problem) {
    const Oracle& oracle = oracle_named(problem.oracle, "test");
    return oracle.bind(resolve(oracle.parameters, problem.given, "test", problem.oracle));
}

/// One field along the line.
struct Along {
    Exact exact;
    std::size_t offset;
    double t;

    double operator()(double x) const {
        std::vector<double> row(exact.width());
        exact.sample(std::span(&x, 1), t, row);
        return row[offset];
    }
};

/// Distance from the nearest of these features; infinite where there is none.
double distance(double x, const std::vector<Feature>& features) {
    double nearest = INFINITY;
    for (const auto& feature : features) nearest = std::min(nearest, std::abs(x - feature.x));
    return nearest;
}

/// Range of the values at these places; 0 where it is round-off.
double range_of(const Along& field, const std::vector<double>& places) {
    double low = INFINITY, high = -INFINITY;
    for (const double x : places) {
        const double value = field(x);
        if (std::isnan(value)) continue;
        low = std::min(low, value);
        high = std::max(high, value);
    }
    return high - low > 1e-9 * std::max(std::abs(low), std::abs(high)) ? high - low : 0;
}

std::vector<double> grid(const Problem& problem, int n) {
    std::vector<double> places;
    // Off the middle by a little, so that no place of symmetry is met.
    for (int i = 0; i < n; ++i) places.push_back(problem.from + (problem.to - problem.from) * (i + 0.5137) / n);
    return places;
}

/// Where the field still changes by more than `least` over 1e-9 of the line: halves of an interval are followed into
/// the larger change.
double jump_within(const Along& field, double a, double b, double width, double least) {
    while (b - a > width) {
        const double middle = 0.5 * (a + b);
        const double left = std::abs(field(middle) - field(a)), right = std::abs(field(b) - field(middle));
        (left > right ? b : a) = middle;
    }
    return std::abs(field(b) - field(a)) > least ? a : NAN;
}

/// A jump or kink of a field that is not told of: what and where; "" without one.
std::string untold(const Problem& problem, const Along& field, const std::vector<Feature>& features) {
    const auto places = grid(problem, 4000);
    const double line = problem.to - problem.from, h = places[1] - places[0];
    const double range = range_of(field, places);
    if (range == 0) return "";
    const auto singular = [&](double x) {
        return std::ranges::any_of(features, [&](const Feature& feature) {
            return feature.kind == Feature::Kind::singular && std::abs(x - feature.x) < 0.05 * line;
        });
    };
    double steepest = 0;
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
        if (distance(places[i], features) < 2 * h || singular(places[i])) continue;
        steepest = std::max(steepest, std::abs(field(places[i + 1]) - field(places[i])) / h);
    }
    for (std::size_t i = 1; i + 1 < places.size(); ++i) {
        const double x = places[i];
        if (distance(x, features) < 2 * h || singular(x)) continue;
        const double before = field(places[i - 1]), here = field(x), after = field(places[i + 1]);
        const double least = 1e-3 * range;
        if (std::abs(after - here) > least && !std::isnan(jump_within(field, x, places[i + 1], 1e-9 * line, least)))
            return "a jump at x = " + std::to_string(x);
        // A smooth field's slope changes by f'' h, here some hundredths of its steepest at most; a kink's at once.
        const double bend = std::abs(after - 2 * here + before) / h;
        if (bend > 0.1 * steepest && bend * h > 1e-9 * range) return "a kink at x = " + std::to_string(x);
    }
    return "";
}

/// One-sided limits of derivative 0 or 1, by steps that leave the other waves alone.
double limit(const Along& field, double x, double step, int derivative) {
    if (derivative == 0) return field(x + step);
    return (field(x + 2 * step) - field(x + step)) / step;
}

/// Whether a feature is what it says: the field jumps by 1e-6 of its range, or is continuous to 1e-6 with another
/// slope.
std::string contradiction(const Problem& problem, const Along& field, const Feature& feature) {
    const double line = problem.to - problem.from, x = feature.x;
    const double range = range_of(field, grid(problem, 400));
    const double step = 1e-8 * line;
    const double jump = limit(field, x, step, 0) - limit(field, x, -step, 0);
    const std::string place = text_of(feature.kind) + " at x = " + std::to_string(x);
    if (feature.derivative == 0) return std::abs(jump) > 1e-6 * range ? "" : "no jump: " + place;
    if (!(std::abs(jump) < 1e-4 * range)) return "not continuous: " + place;
    const double wide = 1e-5 * line;
    const double slopes = limit(field, x, wide, 1) - limit(field, x, -wide, 1);
    const bool bends = std::abs(slopes) * line > 1e-3 * range;
    if (bends == (feature.derivative == 1)) return "";
    return (bends ? "a kink at the " : "no kink: ") + place;
}

template <class F>
void for_each_field(F f) {
    for (const auto& problem : problems) {
        const Exact exact = bound(problem);
        for (const auto& info : exact.fields) {
            INFO(problem.oracle << " at t = " << problem.t << ": " << info.name);
            auto features = exact.features(info.name, problem.t);
            std::erase_if(features, [&](const Feature& feature) {
                return !(feature.x > problem.from && feature.x < problem.to);
            });
            f(problem, Along{exact, *exact.offset(info.name), problem.t}, features);
        }
    }
}

}  // namespace

TEST_CASE("features: every exact solution tells them", "[unit]") {
    for (const auto& oracle : all_oracles()) {
        INFO(oracle.name);
        const Exact exact = oracle.bind(resolve(oracle.parameters, {}, "test", oracle.name));
        CHECK(static_cast<bool>(exact.features));
    }
}

TEST_CASE("features: fields jump where they are said to, and have a kink where one is told", "[gate]") {
    int jumps = 0, kinks = 0;
    for_each_field([&](const Problem& problem, const Along& field, const std::vector<Feature>& features) {
        for (const auto& feature : features) {
            if (feature.kind == Feature::Kind::singular) continue;
            CHECK(contradiction(problem, field, feature) == "");
            jumps += feature.derivative == 0;
            kinks += feature.derivative == 1;
        }
    });
    CHECK(jumps > 100);
    CHECK(kinks > 50);
}

TEST_CASE("features: nowhere else does a field jump or bend", "[gate]") {
    for_each_field([&](const Problem& problem, const Along& field, const std::vector<Feature>& features) {
        CHECK(untold(problem, field, features) == "");
    });
}

TEST_CASE("alarm: a declaration that lacks a feature, or has it wrong, is found", "[alarm]") {
    const Problem sod{"riemann_gas", {}, 1.5, -4, 4};
    const Exact exact = bound(sod);
    const Along density{exact, *exact.offset("density"), sod.t}, pressure{exact, *exact.offset("pressure"), sod.t};
    const auto told = exact.features("density", sod.t);
    REQUIRE(told.size() == 4);
    REQUIRE(untold(sod, density, told) == "");
    for (std::size_t k = 0; k < told.size(); ++k) {
        auto fewer = told;
        fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(k));
        CHECK(untold(sod, density, fewer) != "");
        auto wrong = told[k];
        wrong.derivative = 1 - wrong.derivative;
        CHECK(contradiction(sod, density, wrong) != "");
        auto moved = told[k];
        moved.x += 0.01;
        CHECK(contradiction(sod, density, moved) != "");
    }
    CHECK(contradiction(sod, pressure, told[2]) == "no jump: contact at x = " + std::to_string(told[2].x));
}

TEST_CASE("features: what moves with matter is a contact, and a wave of a linear law is linear", "[unit]") {
    const auto kinds_of = [](const Problem& problem, const std::string& field) {
        std::vector<std::string> kinds;
        for (const auto& feature : bound(problem).features(field, problem.t)) kinds.push_back(text_of(feature.kind));
        return kinds;
    };
    using Words = std::vector<std::string>;
    CHECK(kinds_of({"riemann_gas", {}, 1, 0, 0}, "density") == Words{"fan_corner", "fan_corner", "contact", "shock"});
    CHECK(kinds_of({"riemann_gas", {}, 1, 0, 0}, "pressure") == Words{"fan_corner", "fan_corner", "shock"});
    CHECK(kinds_of({"riemann_gas", {{"rho_R", 0.0}, {"p_R", 0.0}}, 1, 0, 0}, "density") ==
          Words{"fan_corner", "singular"});
    const Problem bars{"riemann_linear_elastic", {{"v_L", 0.1}, {"T_L", 1.0}, {"T_R", 2.0}}, 1, 0, 0};
    CHECK(kinds_of(bars, "stress") == Words{"linear", "linear"});
    CHECK(kinds_of(bars, "temperature") == Words{"contact"});
    CHECK(kinds_of({"density_pulse", {}, 0.1, 0, 0}, "density") == Words{"contact", "contact"});
    CHECK(kinds_of({"density_pulse", {}, 0.1, 0, 0}, "velocity").empty());
    CHECK(kinds_of({"elastic_end", {{"material", "linear"}, {"V", -0.1}}, 1, 0, 0}, "stress") == Words{"linear"});
}

TEST_CASE("features: places of all fields together, rising", "[unit]") {
    const Exact exact = bound(problems[12]);
    const auto waves = exact.waves(1.5);
    CHECK(places_of_features(exact, 1.5) == std::vector{waves[0].left, waves[0].right, waves[1].left, waves[2].left});
    CHECK(places_of_features(bound(problems[0]), 0.5).empty());
}
