// Figures over revisions.
#include "reports/gate/history.hpp"

#include <fmt/format.h>

#include <cmath>
#include <random>

#include "tests/catch.hpp"
#include "tests/reports/gate/gated.hpp"

using namespace ordo;
using reports::Entry;
using reports::FigureKind;
using reports::history_of;
using samples::Json;

namespace {

/// A report at the hour `time`, with one error and one count.
Entry entry(int time, const std::string& revision, double error, double steps = 100) {
    return {"bar",
            R"({"scene":{"E":100}})",
            revision,
            fmt::format("2026-01-01T{:04}:00:00Z", time),
            {{FigureKind::error, "mpm, cells = 4", "mpm", "displacement.rms", error},
             {FigureKind::work, "mpm, cells = 4", "mpm", "steps", steps}}};
}

}  // namespace

TEST_CASE("history: a step has its revisions and both levels, whatever the order of the files", "[unit]") {
    const std::vector<Entry> entries{entry(4, "d", 1.5e-3), entry(1, "a", 1e-3), entry(3, "c", 1.5e-3),
                                     entry(2, "b", 1e-3)};
    const auto history = history_of(entries);
    CHECK(history.reports == 4);
    CHECK(history.studies == 1);
    CHECK(history.revisions == 4);
    CHECK(history.figures == 2);
    REQUIRE(history.steps.size() == 1);
    CHECK(history.steps[0].figure == "mpm, cells = 4: displacement.rms");
    CHECK(history.steps[0].before == "b");
    CHECK(history.steps[0].now == "c");
    CHECK(history.steps[0].old_level == 1e-3);
    CHECK(history.steps[0].new_level == 1.5e-3);
    REQUIRE(history.notes.size() == 1);
    CHECK_THAT(history.notes[0], ContainsSubstring("4 revisions are too few"));
}

TEST_CASE("history: an improvement is a step too, and so is one count less", "[unit]") {
    const auto history = history_of({entry(1, "a", 1e-3), entry(2, "b", 0.5e-3, 99)});
    REQUIRE(history.steps.size() == 2);
    CHECK_THAT(history_text(history), ContainsSubstring("-50 %") && ContainsSubstring("-1 %"));
}

TEST_CASE("alarm: equal revisions raise none in 1000 histories, whatever their reports hold", "[alarm]") {
    std::mt19937 seed(1);
    std::cauchy_distribution<double> wild;
    for (int trial = 0; trial < 1000; ++trial) {
        std::vector<Entry> entries;
        for (int time = 0; time < 10; ++time) entries.push_back(entry(time, "same", wild(seed), wild(seed)));
        REQUIRE(history_of(entries).steps.empty());
    }
    CHECK_THAT(history_of({entry(1, "a", 1), entry(2, "a", 2)}).notes.at(0), ContainsSubstring("no step can be told"));
}

TEST_CASE("alarm: a revision that is run again later stays where it was", "[alarm]") {
    const auto history =
        history_of({entry(1, "a", 1e-3), entry(2, "b", 2e-3), entry(3, "a", 1e-3), entry(4, "b", 2e-3)});
    CHECK(history.revisions == 2);
    CHECK(history.steps.size() == 1);
}

TEST_CASE("history: the scatter among builds of one revision is noise", "[unit]") {
    std::vector<Entry> entries;
    for (int time = 0; time < 8; ++time) {
        const std::string revision(1, static_cast<char>('a' + time / 2));
        entries.push_back(entry(time, revision, 1e-3 + (time % 2 == 0 ? 1e-12 : 0) + 1e-13 * time));
    }
    CHECK(history_of(entries).steps.empty());
    for (std::size_t i = 4; i < 8; ++i) entries[i].figures[0].value += 1e-6;
    CHECK(history_of(entries).steps.size() == 1);
}

TEST_CASE("history: a study that asks something else begins anew, and a note names the member", "[unit]") {
    auto other = entry(2, "b", 9e-3);
    other.question = R"({"scene":{"E":50}})";
    const auto history = history_of({entry(1, "a", 1e-3), other});
    CHECK(history.steps.empty());
    CHECK(history.studies == 1);
    CHECK_THAT(history_text(history), ContainsSubstring("asks another question at b: /scene/E was 100, is 50"));
}

TEST_CASE("history: a figure that comes or goes is a step, and a run that is gone too", "[unit]") {
    auto without = entry(2, "b", 1e-3);
    without.figures.pop_back();
    const auto history = history_of({entry(1, "a", 1e-3), without});
    REQUIRE(history.steps.size() == 1);
    CHECK(history.steps[0].figure == "mpm, cells = 4: steps");
    CHECK_THAT(history_text(history), ContainsSubstring("none"));
}

TEST_CASE("history: reports without a revision are not told apart", "[unit]") {
    const auto history = history_of({entry(1, "unknown", 1), entry(2, "unknown", 2)});
    CHECK(history.steps.empty());
    CHECK_THAT(history.notes.at(0), ContainsSubstring("'unknown'"));
}

TEST_CASE("history: errors, orders and work of a report are looked at", "[unit]") {
    const auto found = reports::entry_of(gated::sample());
    const auto& runs = gated::sample().result.runs;
    const auto count = [&](FigureKind kind) {
        return static_cast<std::size_t>(std::ranges::count(found.figures, kind, &reports::Figure::kind));
    };
    CHECK(count(FigureKind::error) == 3);
    CHECK(count(FigureKind::order) % 3 == 0);
    CHECK(count(FigureKind::order) >= 3);
    CHECK(count(FigureKind::work) == 3 * runs[0].work.size());
    CHECK(value_of(found.figures, "mpm, cells = 4, dt = 0.005: displacement.rms") == runs[0].errors[0].value);
    CHECK(std::isnan(value_of(found.figures, "none")));
}

TEST_CASE("history: JSON holds the steps and what was looked at; no level is null", "[unit]") {
    const auto history = history_of({entry(1, "a", 1e-3), entry(2, "b", std::nan(""))});
    const auto json = Json::parse(history_json(history));
    CHECK(json["schema"] == "ordo-history-1");
    CHECK(json["reports"] == 2);
    CHECK(json["figures"] == 2);
    REQUIRE(json["steps"].size() == 1);
    CHECK(json["steps"][0]["old"] == 1e-3);
    CHECK(json["steps"][0]["new"].is_null());
    CHECK(json["steps"][0]["before"] == "a");
}
