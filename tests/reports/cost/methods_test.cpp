// Methods side by side, from reports whose costs and errors are power laws.
#include "reports/cost/methods.hpp"

#include <cmath>

#include "tests/catch.hpp"
#include "tests/reports/cost/race.hpp"

using namespace ordo;
using namespace ordo::reports;
using samples::race;

namespace {

std::vector<Method> methods(const Report& report, Cost cost = Cost::time) {
    return methods_of(report.result, report.result.study.measure.quantities.front(), cost);
}

}  // namespace

TEST_CASE("methods: the exponent of a power law is found, with an interval around it", "[unit]") {
    const auto all = methods(race());
    REQUIRE(all.size() == 2);
    const auto slow = cost_exponent(all[0]);  // error 1e-2 / t
    REQUIRE(slow.fit);
    CHECK(slow.fit->order == Approx(1).epsilon(1e-9));
    const auto fast = cost_exponent(all[1]);  // error 1e-4 / t^2
    REQUIRE(fast.fit);
    CHECK(fast.fit->order == Approx(2).epsilon(1e-9));
    CHECK(fast.fit->low <= 2);
    CHECK(fast.fit->high >= 2);
}

TEST_CASE("methods: who is there first, and which run has got there", "[unit]") {
    const auto report = race();
    const auto all = methods(report);
    // 1e-2 / t = 0.5 at 0.02 s; 1e-4 / t^2 = 0.5 at 0.0141 s; they cross at t = 0.01 s, error 1.
    CHECK(ranked_at(all, 0.5) == std::vector<std::size_t>{1, 0});
    CHECK(ranked_at(all, 2) == std::vector<std::size_t>{0, 1});
    CHECK(ranked_at(all, 1e-12).empty());
    CHECK(reach_of(all[0], 0.5).cost.cost == Approx(0.02).epsilon(1e-12));
    CHECK(reach_of(all[0], 0.5).run == 2);  // costs 0.002, 0.008, 0.032: errors 5, 1.25, 0.3125
    CHECK(reach_of(all[0], 1e-12).run == -1);
    const auto changes = lead_changes(all);
    REQUIRE(changes.size() == 1);
    CHECK(changes[0].at.cost == Approx(0.01).epsilon(1e-12));
    CHECK(changes[0].at.error == Approx(1).epsilon(1e-12));
    CHECK(changes[0].before == 0);
    CHECK(changes[0].after == 1);
}

TEST_CASE("methods: a third one that is better hides a crossover", "[unit]") {
    auto all = methods(race());
    all.push_back(all[0]);
    for (auto& point : all[2].points) point.error /= 100;
    all[2].descent = descent_of(all[2].points);
    for (const auto& change : lead_changes(all)) CHECK((change.before == 2 || change.after == 2));
    CHECK(lead_changes({all[0], all[1]}).size() == 1);
}

TEST_CASE("methods: the front names the runs of all that none beats", "[unit]") {
    const auto front = front_of(methods(race()));
    // Costs 0.002 * 4^k; errors 5, 1.25, ... of the first, 25, 1.5625, 0.0977, ... of the second.
    REQUIRE(front.size() == 4);
    CHECK(front[0].method == 0);
    CHECK(front[1].method == 0);
    CHECK(front[2].method == 1);
    CHECK(front[3].method == 1);
    CHECK(front[3].run == 7);
}

TEST_CASE("methods: a run that stopped has no point, and a time limit is what was looked at", "[unit]") {
    auto report = race();
    report.result.runs[3].status = studies::Status::timed_out;
    report.result.study.timeout_s = 7;
    const auto all = methods(report);
    CHECK(all[0].limit == 7);
    CHECK(std::isnan(all[0].points[3].cost));
    CHECK(all[1].limit == Approx(0.128));
    report.result.runs[7].status = studies::Status::diverged;
    CHECK(std::isnan(methods(report)[1].points[3].error));
}

TEST_CASE("methods: counted work instead of time", "[unit]") {
    const auto all = methods(race(), Cost::work);
    CHECK(all[0].points[1].cost == 400);
    CHECK(reach_of(all[0], 1.25).cost.cost == Approx(400));
}
