// A report against an accepted one: passes only if inside, and every fault by its own name.
#include "reports/gate/compare.hpp"

#include <cmath>

#include "reports/gate/tolerance.hpp"
#include "tests/catch.hpp"
#include "tests/reports/gate/gated.hpp"

using namespace ordo;
using namespace ordo::gated;
using reports::AcceptedFigure;
using reports::checks_against;
using reports::fault_of;
using reports::FigureKind;
using samples::Json;
using studies::Check;
using studies::Fault;
using studies::Verdict;
using Names = std::vector<std::string>;

namespace {

const double infinity = HUGE_VAL;
const double none = std::nan("");

AcceptedFigure figure(double value, double tolerance, FigureKind kind = FigureKind::error) {
    return {{kind, "mpm, cells = 4", "mpm", "displacement.rms", value}, tolerance};
}

/// The sample with other runs, against the sample and its twin.
std::vector<Check> compared(std::vector<studies::Run> runs) {
    return checks_against(with(std::move(runs)), accepted_with_twin());
}

}  // namespace

TEST_CASE("compare: the accepted report itself passes, and so does its twin", "[unit]") {
    const auto checks = checks_against(sample(), accepted_with_twin());
    CHECK(checks.size() >= 6);  // runs, errors, an order and both its ends, work counts
    CHECK(all_pass(checks));
    CHECK(all_pass(checks_against(twin(), accepted_with_twin())));
    CHECK_THAT(checks.back().source, ContainsSubstring("a test"));
}

TEST_CASE("compare: every kind of report passes against itself", "[unit]") {
    for (const auto& [kind, report] : samples::reports_of_every_kind()) {
        INFO(kind);
        CHECK(all_pass(checks_against(report, accepted(report))));
    }
}

TEST_CASE("alarm: the twin fails where no scatter was measured", "[alarm]") {
    CHECK_FALSE(all_pass(checks_against(twin(), accepted(sample()))));
}

TEST_CASE("compare: the interval is two-sided and ends at ten times the spread", "[unit]") {
    // The spread of the middle error is 1e-9 of it; the median spread of its group is its own.
    CHECK(all_pass(compared(with_error_times(1 + 1e-9))));
    CHECK(all_pass(compared(with_error_times(1 - 1e-9))));
    CHECK(faults(compared(with_error_times(1 + 1.1e-8))).front() == "error_changed");
    CHECK(faults(compared(with_error_times(1 - 1.1e-8))).front() == "error_changed");
}

TEST_CASE("alarm: each thing that can be wrong with a figure has its own name, and inside has none", "[alarm]") {
    CHECK(fault_of(figure(1, 0.1), 1) == Fault::none);
    CHECK(fault_of(figure(1, 0.1), 1.09) == Fault::none);
    CHECK(fault_of(figure(1, 0.1), 1.11) == Fault::error_changed);
    CHECK(fault_of(figure(1, 0.1), 0.89) == Fault::error_changed);
    CHECK(fault_of(figure(1, 0.1), none) == Fault::error_is_nan);
    CHECK(fault_of(figure(1, 0.1), infinity) == Fault::error_is_infinite);
    CHECK(fault_of(figure(1, 0.1), -1) == Fault::error_is_negative);
    CHECK(fault_of(figure(1, 0.1), -infinity) == Fault::error_is_negative);
    CHECK(fault_of(figure(1, 0.1), 0) == Fault::error_is_zero);
    CHECK(fault_of(figure(2, 0.1, FigureKind::order), 2.2) == Fault::order_changed);
    CHECK(fault_of(figure(2, 0.1, FigureKind::order), none) == Fault::order_changed);
    CHECK(fault_of(figure(100, 0, FigureKind::work), 101) == Fault::work_changed);
    CHECK(fault_of(figure(100, 0, FigureKind::work), 99) == Fault::work_changed);
    CHECK(fault_of(figure(100, 0, FigureKind::work), none) == Fault::work_changed);
}

TEST_CASE("alarm: nothing stands in for a number", "[alarm]") {
    CHECK(fault_of(figure(none, 0), none) == Fault::none);
    CHECK(fault_of(figure(none, 0), 1) == Fault::error_changed);
    CHECK(fault_of(figure(none, 1e300), 0) == Fault::error_is_zero);
    CHECK(fault_of(figure(1, none), 1) == Fault::error_changed);
    CHECK(fault_of(figure(infinity, 1), infinity) == Fault::error_is_infinite);
}

TEST_CASE("compare: an error near round-off may scatter by its own size, but not below zero", "[unit]") {
    CHECK(fault_of(figure(1e-16, 1e-15), 5e-16) == Fault::none);
    CHECK(fault_of(figure(1e-16, 1e-15), 0) == Fault::none);
    CHECK(fault_of(figure(1e-16, 1e-15), -1e-17) == Fault::error_is_negative);
    CHECK(fault_of(figure(1e-16, 1e-15), 2e-15) == Fault::error_changed);
}

TEST_CASE("alarm: an accepted error of zero allows none other", "[alarm]") {
    const auto baseline = accepted(with(with_error_times(0)));
    CHECK(all_pass(checks_against(with(with_error_times(0)), baseline)));
    CHECK(faults(checks_against(sample(), baseline)).front() == "error_changed");
}

TEST_CASE("alarm: a NaN, an infinity, a zero or a minus in one run fails by name through the whole gate", "[alarm]") {
    CHECK(faults(compared(with_error_times(none))).front() == "error_is_nan");
    CHECK(faults(compared(with_error_times(infinity))).front() == "error_is_infinite");
    CHECK(faults(compared(with_error_times(0))).front() == "error_is_zero");
    CHECK(faults(compared(with_error_times(-1))).front() == "error_is_negative");
}

TEST_CASE("alarm: a run that is missing, new, repeated or ends otherwise fails by name", "[alarm]") {
    auto runs = sample().result.runs;
    const auto last = runs.back();
    runs.pop_back();
    CHECK(faults(compared(runs)).front() == "point_missing");
    CHECK(faults(checks_against(sample(), accepted(with(runs)))).front() == "runs_changed");
    CHECK(faults(compared({})) == Names{"nothing_measured"});

    auto repeated = sample().result.runs;
    repeated.push_back(last);
    repeated.back().id = 3;
    CHECK(faults(compared(repeated)).front() == "point_repeated");

    auto other = repeated;
    other.back().axes[0].value = 32;
    CHECK(faults(compared(other)).front() == "runs_changed");

    auto broken = sample().result.runs;
    broken[0].status = studies::Status::diverged;
    CHECK(faults(compared(broken)).front() == "runs_changed");
}

TEST_CASE("alarm: other work fails alone, by one step and in both directions", "[alarm]") {
    for (const double change : {-1.0, 1.0}) {
        auto runs = sample().result.runs;
        REQUIRE_FALSE(runs[1].work.empty());
        runs[1].work[0].value += change;
        CHECK(faults(compared(runs)) == Names{"work_changed"});
    }
}

TEST_CASE("alarm: a counter that was never accepted fails, and so does one that is gone", "[alarm]") {
    auto runs = sample().result.runs;
    runs[1].work.push_back({"new_counter", 3});
    CHECK(faults(compared(runs)) == Names{"work_changed"});
    runs = sample().result.runs;
    runs[1].work.clear();
    CHECK(faults(compared(runs)) == Names{"work_changed"});
}

TEST_CASE("alarm: a different question is not compared, and each member in which it differs is named", "[alarm]") {
    Json changed = samples::study();
    changed["expect"][0]["within"] = 0.3;
    changed["scene"]["E"] = 50;
    const auto checks = checks_against(samples::report_of(changed), accepted(sample()));
    REQUIRE(checks.size() == 2);
    CHECK(faults(checks) == Names{"study_differs"});
    const bool scene_first = checks[0].subject == "study: /scene/E";
    const Check& scene = checks[scene_first ? 0 : 1];
    const Check& within = checks[scene_first ? 1 : 0];
    CHECK(scene.subject == "study: /scene/E");
    CHECK(scene.found == "50");
    CHECK(within.subject == "study: /expect/0/within");
    CHECK(within.claim == "0.2");
    CHECK(within.found == "0.3");
}

TEST_CASE("compare: the words about a study are no part of the question, nor is a default that is written", "[unit]") {
    Json changed = samples::study();
    changed["scene"]["rho"] = 1;
    changed["about"] = "said in another way";
    CHECK(all_pass(checks_against(samples::report_of(changed), accepted(sample()))));
}

TEST_CASE("compare: time is a ratio of ratios, inside the factor on both sides", "[unit]") {
    auto report = sample();
    report.provenance.kernel_seconds = 1e-3;
    const auto baseline = accepted(report);
    CHECK(reports::time_ratio(report) == Approx(750));  // three runs of 0.25 s, as the sample says
    const auto fault_at = [&](double factor) {
        auto now = report;
        for (auto& run : now.result.runs) run.seconds *= factor;
        return reports::time_check(now, baseline, 1.5).fault;
    };
    CHECK(fault_at(1) == Fault::none);
    CHECK(fault_at(1.49) == Fault::none);
    CHECK(fault_at(1.51) == Fault::time_changed);
    CHECK(fault_at(1 / 1.49) == Fault::none);
    CHECK(fault_at(1 / 1.51) == Fault::time_changed);
    CHECK(fault_at(none) == Fault::time_changed);
    auto repeated = report;  // three runs of 0.25 s with a spread of 12 % each: of their sum 12 % / sqrt 3
    for (auto& run : repeated.result.runs) run.repeats = studies::Repeats{9, 0.12};
    CHECK(reports::time_spread(repeated) == Approx(0.12 / std::sqrt(3.0)).epsilon(1e-14));
    CHECK(reports::time_check(repeated, baseline, 1.075).fault == Fault::none);
    CHECK(reports::time_check(repeated, baseline, 1.065).fault == Fault::time_changed);
    CHECK_THAT(reports::time_check(repeated, baseline, 1.5).found, ContainsSubstring("1 +- 6.9 % times"));
    CHECK(reports::time_spread(report) == 0);
    auto slow_machine = report;
    for (auto& run : slow_machine.result.runs) run.seconds *= 3;
    slow_machine.provenance.kernel_seconds *= 3;
    CHECK(reports::time_check(slow_machine, baseline, 1.1).verdict == Verdict::pass);
}

TEST_CASE("alarm: a time that was not measured does not pass", "[alarm]") {
    auto report = sample();
    const auto check = reports::time_check(report, accepted(report), 1e9);
    CHECK(check.fault == Fault::time_changed);
    CHECK_THAT(check.found, ContainsSubstring("no time"));
}

TEST_CASE("compare: a reviewer sees what left its interval, came, went, and got a wider tolerance", "[unit]") {
    const auto before = accepted_with_twin();
    CHECK(reports::changes(before, before).empty());

    const auto moved = reports::changes(before, accepted(with(with_error_times(1.01))));
    REQUIRE_FALSE(moved.empty());
    CHECK(moved.front().now->figure.value == Approx(1.01 * moved.front().before->figure.value));

    const auto wider = reports::changes(accepted(sample()), accepted_with_twin());
    CHECK(wider.size() >= 3);
    const auto tighter = reports::changes(accepted_with_twin(), accepted(sample()));
    CHECK(tighter.empty());

    auto fewer = before;
    fewer.figures.pop_back();
    REQUIRE(reports::changes(before, fewer).size() == 1);
    CHECK_FALSE(reports::changes(before, fewer).front().now.has_value());
    CHECK_FALSE(reports::changes(fewer, before).front().before.has_value());
}
