#include "reports/plot/plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <regex>

#include "core/error.hpp"
#include "core/text.hpp"
#include "reports/plot/ticks.hpp"
#include "reports/plot/triangle.hpp"
#include "tests/app/process.hpp"
#include "tests/catch.hpp"
#include "tests/reports/plot/blocks.hpp"
#include "tests/reports/sample.hpp"

using namespace ordo;
using namespace ordo::reports;
using outside::Folder;
using samples::block_of;
using samples::numbers_of;
using samples::sample;

namespace {

std::string script_of(const Report& report) { return figures(report, PlotFormat::svg).at(0).script; }

double slope(const std::vector<double>& a, const std::vector<double>& b) {
    return std::log(b[1] / a[1]) / std::log(b[0] / a[0]);
}

/// PATH as given, until the end of the test.
class PathIs {
public:
    explicit PathIs(const std::string& path) : before_(std::getenv("PATH")) { setenv("PATH", path.c_str(), 1); }
    ~PathIs() { setenv("PATH", before_.c_str(), 1); }
    PathIs(const PathIs&) = delete;
    PathIs& operator=(const PathIs&) = delete;

private:
    std::string before_;
};

/// Whether the point is inside the triangle, by the signs of three areas.
bool inside(const Triangle& triangle, Point p) {
    const auto area = [&](Point a, Point b) { return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x); };
    const auto& [a, b, c] = triangle.corners;
    const std::array areas{area(a, b), area(b, c), area(c, a)};
    return std::ranges::all_of(areas, [](double s) { return s >= 0; }) ||
           std::ranges::all_of(areas, [](double s) { return s <= 0; });
}

}  // namespace

TEST_CASE("plot: a gnuplot string is single-quoted and on one line", "[unit]") {
    CHECK(quoted("a") == "'a'");
    CHECK(quoted("it's `id` \"$x\" \\") == "'it''s `id` \"$x\" \\'");
    CHECK(quoted("a\nEOD\r\x1B\x7F") == "'a EOD   '");
}

TEST_CASE("plot: a figure's name is a plain file name", "[unit]") {
    auto report = sample();
    report.result.study.name = "../a b/\xC3\xA9;$(x)";
    const auto all = figures(report, PlotFormat::png);
    REQUIRE(all.size() == 1);
    CHECK(std::regex_match(all[0].name, std::regex("[A-Za-z0-9_-][A-Za-z0-9._-]*")));
    CHECK(all[0].name.ends_with("-displacement.rms-h"));
}

TEST_CASE("plot: the points are the finite, positive errors, with whether a fit used them", "[unit]") {
    const std::string script = script_of(sample());
    const auto points = numbers_of(block_of(script, "points0"));
    REQUIRE(points.size() == 5);
    CHECK(points[0] == std::vector<double>{1.0 / 3, 0.09, 1});
    CHECK(points[3] == std::vector<double>{1.0 / 81, 5e-4, 0});  // hollow
    CHECK(points[4].empty());                                    // diverged
    CHECK(numbers_of(block_of(script, "points1"))[1].empty());   // NaN: the line of points has a gap there
}

TEST_CASE("plot: the fitted line covers the runs that the fit used and no more", "[unit]") {
    const std::string script = script_of(sample());
    const auto line = numbers_of(block_of(script, "fit0_0"));
    REQUIRE(line.size() == 2);
    CHECK(line[0][0] == 1.0 / 3);
    CHECK(line[1][0] == 1.0 / 27);
    CHECK(line[0][1] == Approx(0.81 / 9));  // 0.81 h^2
    CHECK(line[1][1] == Approx(0.81 / 27 / 27));
    CHECK(block_of(script, "fit1_0").empty());  // refused
}

TEST_CASE("plot: the triangle has the expected slope and its label", "[unit]") {
    auto report = sample();
    const double order = GENERATE(2.0, 1.0, 3.5, -1.0);
    report.result.study.expect[0].value = order;
    const std::string script = script_of(report);
    const auto corners = numbers_of(block_of(script, "triangle0"));
    REQUIRE(corners.size() == 4);
    CHECK(slope(corners[0], corners[1]) == Approx(order).epsilon(1e-9));  // rounding of logarithms
    CHECK(corners[3] == corners[0]);
    CHECK_THAT(script, ContainsSubstring("set label '" + shortest(order) + "' at "));
}

TEST_CASE("plot: there is no triangle where no order of this quantity is expected", "[unit]") {
    auto report = sample();
    auto& expectation = report.result.study.expect[0];
    SECTION("nothing expected") { report.result.study.expect.clear(); }
    SECTION("another quantity") { expectation.quantities = {"velocity.rms"}; }
    SECTION("another solver") { expectation.solvers = {"rrm"}; }
    SECTION("a bound") { expectation.kind = studies::Expectation::Kind::error_at_most; }
    SECTION("no slope") { expectation.value = 0; }
    CHECK(script_of(report).find("triangle") == std::string::npos);
}

TEST_CASE("plot: a triangle is clear of every segment and inside the box where there is room", "[property]") {
    // A steep curve that turns, as an error does that grows again on fine meshes, and a flat one above it.
    const std::vector<Segment> segments{{{0.8, -3}, {-0.1, -4.8}},
                                        {{-0.1, -4.8}, {-0.7, -5.6}},
                                        {{-0.7, -5.6}, {-1.3, -4.8}},
                                        {{0.8, -2.9}, {-1.3, -3.1}}};
    const Box box{{-1.3, 0.8}, {-5.6, -2.9}};
    const double order = GENERATE(0.5, 1.0, 2.0, 4.0, 10.0, -1.0, -3.0);
    const double centre = GENERATE(-1.0, -0.5, 0.0, 0.5);
    const auto triangle = placed_triangle(order, centre, segments, box);
    const auto& [left, right, angle] = triangle.corners;
    CHECK((right.y - left.y) / (right.x - left.x) == Approx(order));
    CHECK(((angle.x == left.x && angle.y == right.y) || (angle.x == right.x && angle.y == left.y)));
    CHECK(left.x >= box.x.low);
    CHECK(right.x <= box.x.high + 1e-12);
    for (const auto& corner : triangle.corners) {
        CHECK(corner.y >= box.y.low);
        CHECK(corner.y <= box.y.high);
    }
    for (const auto& [a, b] : segments) {
        for (int i = 0; i <= 200; ++i) {
            const double s = i / 200.0;
            CHECK_FALSE(inside(triangle, {a.x + s * (b.x - a.x), a.y + s * (b.y - a.y)}));
        }
    }
}

TEST_CASE("plot: ticks stand where their labels say, at least two of them and ten at most", "[property]") {
    const double low = GENERATE(1.3e-9, 0.048, 0.97, 1.01, 7.0);
    const double decades = GENERATE(0.5, 0.7, 2.1, 8.5, 30.0);
    const Interval range{low, low * std::pow(10, decades)};
    const std::string ticks = log_ticks(range);
    const std::regex form("'([^']*)' ([0-9e-]+)( 1)?");
    const std::string times = "\xC3\x97";
    const std::regex times_power(times + "10\\^\\{(.*)\\}");
    int labelled = 0;
    for (std::sregex_iterator tick(ticks.begin(), ticks.end(), form); tick != std::sregex_iterator(); ++tick) {
        std::string label = (*tick)[1];
        const double value = std::stod((*tick)[2]);
        CHECK(value >= range.low);
        CHECK(value <= range.high);
        CHECK(label.empty() == (*tick)[3].matched);  // level 1 is a minor tick
        if (label.empty()) continue;
        ++labelled;
        // "2x10^{-3}" is 2e-3 and "10^{-3}" is 1e-3
        label = std::regex_replace(label, times_power, "e$1");
        label = std::regex_replace(label, std::regex("^10\\^\\{(.*)\\}"), "1e$1");
        CHECK(std::stod(label) == Approx(value));
    }
    CHECK(labelled >= (decades < 0.6 ? 2 : 3));
    CHECK(labelled <= 10);
}

TEST_CASE("plot: the legend tells the order, the interval and what is missing", "[unit]") {
    auto report = sample();
    CHECK_THAT(script_of(report), ContainsSubstring("title 'mpm: 2.000 [1.98, 2.02]; 1 run diverged'"));
    CHECK_THAT(script_of(report),
               ContainsSubstring("title 'fem: 1 error zero or not finite; no order (the error is nan)'"));
    report.result.runs[3].status = studies::Status::timed_out;
    CHECK_THAT(script_of(report),
               ContainsSubstring("title 'mpm: 2.000 [1.98, 2.02]; 1 run diverged; 1 run timed out'"));
    report.result.runs[3].status = studies::Status::diverged;
    CHECK_THAT(script_of(report), ContainsSubstring("title 'mpm: 2.000 [1.98, 2.02]; 2 runs diverged'"));
    // However long the names and reasons are, what is missing is told.
    report.result.series[1].label = report.result.fits[1].series = std::string(200, 'f');
    report.result.fits[1].outcome.reason = std::string(200, 'r');
    CHECK_THAT(script_of(report), ContainsSubstring("f...: 1 error zero or not finite; no order (rrr"));
}

TEST_CASE("plot: axes name what they show, with units", "[unit]") {
    const std::string space = script_of(sample());
    CHECK_THAT(space, ContainsSubstring("set xlabel 'mesh width h [m]' noenhanced\n"));
    CHECK_THAT(space, ContainsSubstring("set ylabel 'RMS error of displacement [m]' noenhanced\n"));
    CHECK_THAT(space, ContainsSubstring("set title 'sample/bar' noenhanced"));
    const std::string time = script_of(samples::time_sample());
    CHECK_THAT(time, ContainsSubstring("set xlabel 'time step dt [s]' noenhanced\n"));
    CHECK_THAT(time, ContainsSubstring("set ylabel 'L2 error of velocity [m/s * m^(dim/2)]' noenhanced\n"));
}

TEST_CASE("plot: two drawings are the same bytes, hold the legend and leave nothing else", "[cli]") {
    const Folder folder;
    const std::string name = "sample_bar-displacement.rms-h";
    const auto files = draw(sample(), folder.path().string(), PlotFormat::svg);
    CHECK(files == std::vector{(folder.path() / (name + ".gp")).string(), (folder.path() / (name + ".svg")).string()});
    const std::string first = folder.read(name + ".svg");
    CHECK_THAT(first, ContainsSubstring("mpm: 2.000 [1.98, 2.02]; 1 run diverged"));
    CHECK_THAT(first, ContainsSubstring("sample/bar"));
    draw(sample(), folder.path().string(), PlotFormat::svg);
    CHECK(folder.read(name + ".svg") == first);
    CHECK(folder.names() == std::vector<std::string>{name + ".gp", name + ".svg"});
}

TEST_CASE("plot: every format is drawn, a report without a single point too", "[cli]") {
    const Folder folder;
    auto report = sample();
    for (auto& run : report.result.runs) run.status = studies::Status::diverged;
    for (auto& fit : report.result.fits) fit.outcome = {.fit = {}, .reason = "fewer than two points", .left_out = {}};
    const std::string name = "sample_bar-displacement.rms-h";
    draw(report, folder.path().string(), PlotFormat::pdf);
    CHECK(folder.read(name + ".pdf").starts_with("%PDF"));
    draw(report, folder.path().string(), PlotFormat::png);
    CHECK(folder.read(name + ".png").starts_with("\x89PNG"));
    draw(report, folder.path().string(), PlotFormat::svg);
    CHECK_THAT(folder.read(name + ".svg"), ContainsSubstring("no run has a finite, positive error"));
}

TEST_CASE("plot: a hostile name is drawn and not obeyed", "[cli]") {
    const Folder folder;
    const std::string touch = "touch " + (folder.path() / "seen").string();
    const std::string hostile = "`" + touch + "1` 'quote\" $(" + touch + "2) \n system('" + touch +
                                "3')\nEOD\nsystem('" + touch + "4') {/*9 x} @y %z \\' . system('" + touch + "5') . '";
    auto report = sample();
    report.result.study.name = hostile;
    report.result.study.measure.quantities[0].field = hostile;
    const std::string key = report.result.study.measure.quantities[0].key();
    for (auto& run : report.result.runs) run.errors[0].name = key;
    for (auto& fit : report.result.fits) fit.quantity = key;
    for (auto& series : report.result.series) series.label += hostile;
    for (auto& fit : report.result.fits) fit.series += hostile;
    report.result.fits[1].outcome.reason = hostile;
    const std::string script = script_of(report);  // its own name is too long for a file; locale C has no degree sign
    folder.write("hostile.gp", script);
    const auto outcome = outside::run({"gnuplot", "-e", "output = 'hostile.svg'", "hostile.gp"},
                                      {.folder = folder.path(), .environment = {{"LC_ALL", "C.UTF-8"}}});
    CHECK(outcome.code == 0);
    CHECK(outcome.err == "");
    CHECK(folder.names() == std::vector<std::string>{"hostile.gp", "hostile.svg"});
    CHECK_THAT(folder.read("hostile.svg"), ContainsSubstring("{/*9 x} @y %z"));
    CHECK(block_of(script, "points0").find_first_not_of("0123456789.e- \n") == std::string::npos);
}

TEST_CASE("plot: a hostile folder is drawn into, a relative one too", "[cli]") {
    const Folder folder;
    const std::string hostile = "-e it's `touch seen` $(touch seen)";
    const auto before = std::filesystem::current_path();
    std::filesystem::current_path(folder.path());
    CHECK_NOTHROW(draw(sample(), hostile, PlotFormat::svg));
    std::filesystem::current_path(before);
    const std::string name = hostile + "/sample_bar-displacement.rms-h";
    CHECK(folder.names() == std::vector<std::string>{hostile, name + ".gp", name + ".svg"});
}

TEST_CASE("plot: without gnuplot the scripts are written and the package is named", "[cli]") {
    const Folder folder;
    const Folder empty;
    const PathIs nowhere(empty.path().string());
    CHECK_THROWS_WITH(draw(sample(), folder.path().string(), PlotFormat::svg),
                      ContainsSubstring("gnuplot-nox") && ContainsSubstring("the .gp files are written"));
    CHECK_THROWS_AS(draw(sample(), folder.path().string(), PlotFormat::svg), EnvironmentError);
    CHECK(folder.names() == std::vector<std::string>{"sample_bar-displacement.rms-h.gp"});
}

TEST_CASE("plot: a gnuplot that fails leaves no half picture and the old one as it was", "[cli]") {
    const Folder folder;
    const Folder programs;
    const std::string picture = "sample_bar-displacement.rms-h.svg";
    folder.write(picture, "old");
    // It writes where it is told to, says why it stops, and fails.
    programs.write("gnuplot",
                   "#!/bin/sh\neval \"$(echo \"$3\" | sed \"s/ //g\")\"\n"
                   "echo half > \"$output\"\necho noise >&2\necho out of ink >&2\nexit 1\n");
    std::filesystem::permissions(programs.path() / "gnuplot", std::filesystem::perms::owner_all);
    const PathIs fake(programs.path().string() + ":" + std::getenv("PATH"));
    CHECK_THROWS_WITH(draw(sample(), folder.path().string(), PlotFormat::svg), ContainsSubstring(": out of ink;"));
    CHECK(folder.read(picture) == "old");
    CHECK(folder.names() == std::vector<std::string>{"sample_bar-displacement.rms-h.gp", picture});
}
