#include "studies/order/joint_fit.hpp"

#include <cmath>
#include <random>
#include <set>

#include "tests/catch.hpp"

using namespace ordo::studies;

namespace {

/// A grid of n x n points, h halved and dt quartered from level to level, with these errors.
template <class F>
std::vector<JointPoint> grid(int n, F error) {
    std::vector<JointPoint> points;
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            const double h = std::pow(2, -i), dt = std::pow(4, -j);
            points.push_back({h, dt, error(h, dt)});
        }
    }
    return points;
}

const auto second_and_first = [](double h, double dt) { return h * h + 0.5 * dt; };

/// Log-normal noise of a standard deviation, by a fixed seed.
class Noise {
public:
    explicit Noise(double deviation, unsigned seed = 20240607) : deviation_(deviation), generator_(seed) {}
    double operator()() { return std::exp(deviation_ * normal_(generator_)); }

private:
    double deviation_;
    std::mt19937_64 generator_;
    std::normal_distribution<> normal_;
};

double half_width(const Estimate& estimate) { return (estimate.high - estimate.low) / 2; }

bool holds(const Estimate& estimate, double truth) { return estimate.low <= truth && truth <= estimate.high; }

}  // namespace

TEST_CASE("joint fit: a sum of two powers is found, with its parts at each point", "[unit]") {
    const auto points = grid(4, second_and_first);
    const JointFit fit = fit_joint(points);
    CHECK(fit.verdict == Convergence::converges);
    // The search ends where squares fall by less than 1.5e-8 of themselves.
    CHECK(fit.p.value == Approx(2).epsilon(1e-6));
    CHECK(fit.q.value == Approx(1).epsilon(1e-6));
    CHECK(fit.A.value == Approx(1).epsilon(1e-6));
    CHECK(fit.B.value == Approx(0.5).epsilon(1e-6));
    CHECK(std::isnan(fit.f.value));
    REQUIRE(fit.shares.size() == points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto& [h, dt, error] = points[i];
        CHECK(fit.shares[i].space == Approx(h * h / error).margin(1e-6));
        CHECK(fit.shares[i].time == Approx(0.5 * dt / error).margin(1e-6));
        CHECK(fit.shares[i].dominant() == (h * h > 0.5 * dt ? ErrorPart::space : ErrorPart::time));
    }
}

TEST_CASE("joint fit: a floor that shows is found, one that does not is not invented", "[unit]") {
    Noise noise(0.01);
    const auto with_floor = [&](double h, double dt) { return (second_and_first(h, dt) + 0.05) * noise(); };
    const JointFit fit = fit_joint(grid(5, with_floor));
    CHECK(fit.verdict == Convergence::converges);
    CHECK(holds(fit.f, 0.05));
    CHECK(half_width(fit.f) < 0.005);
    CHECK(holds(fit.p, 2));
    CHECK(holds(fit.q, 1));
    const auto without = [&](double h, double dt) { return second_and_first(h, dt) * noise(); };
    CHECK(std::isnan(fit_joint(grid(5, without)).f.value));
}

TEST_CASE("joint fit: intervals hold the true orders in 93 to 97 of 100 cases", "[convergence]") {
    int held = 0, known = 0;
    for (const int n : {3, 4, 6}) {
        for (const double deviation : {1e-3, 0.03, 0.1}) {
            Noise noise(deviation);
            for (int trial = 0; trial < 90; ++trial) {
                const JointFit fit =
                    fit_joint(grid(n, [&](double h, double dt) { return second_and_first(h, dt) * noise(); }));
                if (fit.verdict == Convergence::pre_asymptotic) continue;  // 1 % of each: it gives no interval
                known += !std::isnan(fit.p.value) + !std::isnan(fit.q.value);
                held += holds(fit.p, 2) + holds(fit.q, 1);
            }
        }
    }
    REQUIRE(known > 1500);  // of 1620; the standard error of the share is 0.55 %
    CHECK(held > 0.93 * known);
    CHECK(held < 0.97 * known);
}

TEST_CASE("joint fit: an error that never dominates has no order", "[alarm]") {
    Noise noise(0.01);
    const double share = GENERATE(0.0, 1e-6, 1e-3);
    const JointFit in_space = fit_joint(grid(4, [&](double h, double dt) { return (h * h + share * dt) * noise(); }));
    CHECK(in_space.verdict == Convergence::inconclusive);
    CHECK(std::isnan(in_space.q.value));
    CHECK(std::isnan(in_space.B.value));
    CHECK(in_space.p.value == Approx(2).margin(0.05));
    CHECK_THAT(in_space.reason, ContainsSubstring("time error") && ContainsSubstring("unknown"));
    REQUIRE(in_space.next);
    CHECK(in_space.next->dt == 4);        // the coarsest was 1
    CHECK(in_space.next->h == 1.0 / 16);  // the finest was 1/8
    const JointFit in_time = fit_joint(grid(4, [&](double h, double dt) { return (share * h + dt) * noise(); }));
    CHECK(std::isnan(in_time.p.value));
    CHECK_THAT(in_time.reason, ContainsSubstring("space error"));
}

TEST_CASE("joint fit: what does not converge is called by its name", "[alarm]") {
    int at_floor = 0;
    for (unsigned seed = 1; seed <= 20; ++seed) {
        const auto floor = fit_joint(grid(4, [n = Noise(0.01, seed)](double, double) mutable { return 1e-3 * n(); }));
        at_floor += floor.verdict == Convergence::at_floor && std::isnan(floor.p.value);
        CHECK(floor.verdict != Convergence::converges);
    }
    CHECK(at_floor >= 18);  // an F-test at 1 % sees an order of 0.004 or so in the others
    Noise noise(0.001);
    const auto still = fit_joint(grid(4, [&](double h, double) { return std::pow(h, 0.05) * noise(); }));
    CHECK(still.verdict == Convergence::stalled);
    CHECK(fit_joint(grid(4, [](double, double) { return 1e-3; })).verdict == Convergence::at_floor);
    const auto grows = fit_joint(grid(4, [&](double h, double dt) { return (1e-2 / h + dt) * noise(); }));
    CHECK(grows.verdict == Convergence::diverges);
    const auto bent = fit_joint(grid(5, [&](double h, double dt) { return (h + 9 * h * h * h + dt) * noise(); }));
    CHECK(bent.verdict == Convergence::pre_asymptotic);
    CHECK(std::isinf(bent.p.high));
    const auto wild = fit_joint(grid(4, [n = Noise(1.5)](double h, double dt) mutable { return (h + dt) * n(); }));
    CHECK(wild.verdict == Convergence::inconclusive);
}

TEST_CASE("joint fit: points that are none are refused by name", "[alarm]") {
    const auto [place, error, words] = GENERATE(table<std::size_t, double, std::string>(
        {{3, NAN, "nan"}, {3, INFINITY, "inf"}, {3, 0.0, "zero"}, {3, -1.0, "negative"}}));
    auto points = grid(3, second_and_first);
    points[place].error = error;
    const JointFit fit = fit_joint(points);
    CHECK(fit.verdict == Convergence::invalid);
    CHECK_THAT(fit.reason, ContainsSubstring(words) && ContainsSubstring("h = 0.5, dt = 1"));
    auto repeated = grid(3, second_and_first);
    repeated[1] = repeated[0];
    CHECK_THAT(fit_joint(repeated).reason, ContainsSubstring("repeated"));
    auto outside = grid(3, second_and_first);
    outside[0].dt = 0;
    CHECK(fit_joint(outside).verdict == Convergence::invalid);
}

TEST_CASE("joint fit: too few points prove nothing", "[alarm]") {
    auto points = grid(3, second_and_first);
    points.resize(6);
    CHECK_THAT(fit_joint(points).reason, ContainsSubstring("6 points"));
    CHECK_THAT(fit_joint(grid(2, second_and_first)).reason, ContainsSubstring("points"));
    std::vector<JointPoint> two_steps;
    for (const auto& point : grid(5, second_and_first)) {
        if (point.dt >= 0.25) two_steps.push_back(point);
    }
    const JointFit fit = fit_joint(two_steps);
    CHECK(fit.verdict == Convergence::inconclusive);
    CHECK_THAT(fit.reason, ContainsSubstring("2 values of dt"));
    CHECK_FALSE(fit.next.has_value());
    CHECK(fit_joint({}).verdict == Convergence::inconclusive);
}

TEST_CASE("joint fit: the next run shrinks the intervals to what was foretold", "[property]") {
    Noise noise(0.03);
    auto points = grid(4, [&](double h, double dt) { return second_and_first(h, dt) * noise(); });
    const JointFit before = fit_joint(points);
    REQUIRE(before.next);
    std::set<double> widths, steps;
    for (const auto& point : points) {
        widths.insert(point.h);
        steps.insert(point.dt);
    }
    CHECK((widths.count(before.next->h) == 0 || steps.count(before.next->dt) == 0));
    points.push_back({before.next->h, before.next->dt, 0});
    auto& added = points.back();
    added.error =
        before.A.value * std::pow(added.h, before.p.value) + before.B.value * std::pow(added.dt, before.q.value);
    const JointFit after = fit_joint(points);
    // A point on the fit adds no residual, but one degree of freedom: 12 become 13.
    const double freedom = std::sqrt(12.0 / 13);
    CHECK(half_width(after.p) == Approx(before.next->p_half_width * freedom).epsilon(0.01));
    CHECK(half_width(after.q) == Approx(before.next->q_half_width * freedom).epsilon(0.01));
    CHECK(half_width(after.p) * half_width(after.q) < half_width(before.p) * half_width(before.q));
}

TEST_CASE("joint fit: units of length and time change coefficients only", "[property]") {
    Noise noise(0.03);
    auto points = grid(4, [&](double h, double dt) { return second_and_first(h, dt) * noise(); });
    const JointFit metres = fit_joint(points);
    for (auto& [h, dt, error] : points) {
        h *= 1e3;
        dt *= 1e6;
        error *= 1e-9;
    }
    const JointFit scaled = fit_joint(points);
    CHECK(scaled.p.value == Approx(metres.p.value).epsilon(1e-6));
    CHECK(scaled.q.high == Approx(metres.q.high).epsilon(1e-5));
    CHECK(scaled.A.value == Approx(metres.A.value * 1e-9 * std::pow(1e-3, metres.p.value)).epsilon(1e-4));
    CHECK(scaled.verdict == metres.verdict);
}
