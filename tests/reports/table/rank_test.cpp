// Who is fastest, as text, Markdown, LaTeX and CSV.
#include "reports/table/rank.hpp"

#include "core/error.hpp"
#include "tests/catch.hpp"
#include "tests/reports/cost/race.hpp"

using namespace ordo;
using namespace ordo::reports;
using samples::race;

TEST_CASE("ranking: the fastest at each error, its time between two runs and the run that got there", "[unit]") {
    const std::string text = ranking({race()}, {2, 0.5, 1e-3, 1e-9}, TableFormat::markdown);
    // Error 2: a at 5e-3 s; 0.5: b at 1.4e-2 s; 1e-3 and 1e-9: nobody, looked at for 0.128 s.
    CHECK_THAT(text,
               ContainsSubstring("| race | mpm a | 5.0e-03 | cells 8 | mpm b | 1.4e-02 | cells 16 | none | not in "
                                 "0.13 s | - | none | not in 0.13 s | - |\n"));
    CHECK_THAT(text, ContainsSubstring("| mpm b | 2 | 7.1e-03 | cells 8 | 1 | 1.4e-02 | cells 16 |"));
    CHECK_THAT(text, ContainsSubstring("| mpm a | 1 | 5.0e-03 | cells 8 | 2 | 2.0e-02 | cells 16 |"));
    CHECK_THAT(text,
               ContainsSubstring("crossover at 1.0e-02 s, error 1.0e\\+00: up to there mpm a, from there mpm b") ||
                   ContainsSubstring("crossover at 1.0e-02 s, error 1.0e+00: up to there mpm a, from there mpm b"));
    CHECK_THAT(text, ContainsSubstring("each run was timed once"));
    CHECK(text.find("verdict") == std::string::npos);
}

TEST_CASE("ranking: a coarsest run that is better than asked for is a bound", "[unit]") {
    CHECK_THAT(ranking({race()}, {100}, TableFormat::text), ContainsSubstring("<= 2.0e-03"));
}

TEST_CASE("ranking: an error of zero is reached", "[unit]") {
    auto report = race();
    report.result.runs[6].errors[0].value = 0;
    CHECK_THAT(ranking({report}, {1e-9}, TableFormat::markdown),
               ContainsSubstring("| race | mpm b | 3.2e-02 | cells 16 |"));
}

TEST_CASE("ranking: several reports, a line each; CSV is tidy", "[unit]") {
    auto other = race();
    other.result.study.name = "other, again";
    const std::string csv = ranking({race(), other}, {0.5}, TableFormat::csv);
    CHECK_THAT(csv, ContainsSubstring("study,quantity,method,error,place,reached,seconds,axis,resolution,limit\n"
                                      "race,displacement.rms,mpm a,0.5,2,reached,0.0"));
    CHECK_THAT(csv, ContainsSubstring("\"other, again\",displacement.rms,mpm b,0.5,1,reached,0.0141421"));
    const std::string text = ranking({race(), other}, {0.5}, TableFormat::text);
    CHECK_THAT(text, ContainsSubstring("other, again"));
    CHECK_THAT(ranking({race()}, {0.5}, TableFormat::latex), ContainsSubstring("\\begin{tabular}"));
}

TEST_CASE("ranking: repeated times are said with their spread, and a report without times is refused", "[unit]") {
    auto report = race();
    for (auto& run : report.result.runs) run.repeats = studies::Repeats{7, 0.01};
    report.result.runs[2].repeats->spread = 0.031;
    CHECK_THAT(
        ranking({report}, {0.5}, TableFormat::text),
        ContainsSubstring("medians of repeated runs") && ContainsSubstring("1 % (median of the runs), 3.1 % at most"));
    for (auto& run : report.result.runs) run.seconds = 0;
    CHECK_THROWS_AS(ranking({report}, {0.5}, TableFormat::text), InputError);
}
