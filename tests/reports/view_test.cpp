// What tables and figures show of orders against counted work, and of widths of several kinds.
#include "reports/view.hpp"

#include "reports/plot/plot.hpp"
#include "reports/table/model.hpp"
#include "reports/table/table.hpp"
#include "tests/catch.hpp"
#include "tests/reports/plot/blocks.hpp"
#include "tests/reports/sample.hpp"

using namespace ordo;
using namespace ordo::reports;
using namespace ordo::studies;
using samples::block_of;
using samples::counting_sample;
using samples::mixed_sample;
using samples::numbers_of;

namespace {

std::vector<std::string> heads_of(const TableModel& model) {
    std::vector<std::string> heads;
    for (const auto& table : model.tables) heads.push_back(table.place_head);
    return heads;
}

std::vector<std::string> names_of(const std::vector<Drawing>& all) {
    std::vector<std::string> names;
    for (const auto& figure : all) names.push_back(figure.name);
    return names;
}

}  // namespace

TEST_CASE("view: words of errors of waves", "[unit]") {
    const auto words = [](Norm norm) {
        const Quantity quantity{.field = "velocity", .norm = norm};
        return error_words(quantity) + unit_words(quantity);
    };
    CHECK(words(Norm::l1) == "L1 error of velocity [m/s * m^dim]");
    CHECK(words(Norm::l1_fans) == "L1 (inside of fans) error of velocity [m/s * m^dim]");
    CHECK(words(Norm::shock) == "error of the place of the shocks in velocity [m]");
    CHECK(words(Norm::contact) == "error of the place of the contacts in velocity [m]");
    CHECK(words(Norm::fan_edge) == "error of the place of the edges of the fans in velocity [m]");
}

TEST_CASE("view: a series fitted against two abscissae shows each fit once", "[unit]") {
    const auto report = counting_sample();
    const auto views = views_of(report.result);
    REQUIRE(views.size() == 2);
    for (const auto& view : views) {
        const auto fits = fits_along(report.result, view, *view.series.at(0));
        REQUIRE(fits.size() == 1);
        CHECK(fits[0]->abscissa == view.abscissa);
    }
}

TEST_CASE("view: the table of counted work has the counts for places, and orders against one over them", "[unit]") {
    const auto model = table_model(counting_sample());
    CHECK(heads_of(model) == std::vector<std::string>{"cells", "chop_outs"});
    const Table& table = model.tables[1];
    CHECK_THAT(table.title, ContainsSubstring("order against 1/chop_outs"));
    REQUIRE(table.groups.size() == 1);  // fem counts none
    REQUIRE(table.rows.size() == 4);    // and one run diverged
    CHECK(table.rows[0].place == "30");
    CHECK(table.rows[3].place == "810");
    CHECK(table.rows[1].cells.back().text == "2.00");  // ln 9 / ln 3
    CHECK(table.notes ==
          std::vector<std::string>{
              "mpm, chop_outs = none at cells = 243: diverged, a speed above 1e3 m/s",
              "mpm: order 1.000 [0.90, 1.10], converges: power law; points chop_outs = 30, 90, 270, 810; left out "
              "chop_outs "
              "= none at cells = 243 (diverged: )",
              "fem: no order, invalid: fewer than two points; left out chop_outs = none at cells = 3 (it counts "
              "no 'chop_outs')"});
    for (const auto format : {TableFormat::text, TableFormat::markdown, TableFormat::latex, TableFormat::csv})
        CHECK_FALSE(reports::table(counting_sample(), format).empty());
}

TEST_CASE("view: the figure of counted work has its own name, axis and fitted line", "[unit]") {
    auto report = counting_sample();
    report.result.study.expect[0].against = "1/chop_outs";
    const auto all = figures(report, PlotFormat::svg);
    CHECK(names_of(all) ==
          std::vector<std::string>{"sample_bar-displacement.rms-h", "sample_bar-displacement.rms-1_chop_outs"});
    CHECK_THAT(all[1].script, ContainsSubstring("set xlabel '1 / chop outs, as the solver counts [-]'"));
    const auto points = numbers_of(block_of(all[1].script, "points0"));
    CHECK(points.at(0) == std::vector<double>{1.0 / 30, 0.09, 1});
    CHECK(points.at(4).empty());
    CHECK(numbers_of(block_of(all[1].script, "fit0_0")).at(0).at(0) == 1.0 / 30);
    CHECK(numbers_of(block_of(all[1].script, "triangle0")).size() == 4);
    CHECK(block_of(all[0].script, "triangle0").empty());  // the order expected is not against h
    CHECK(numbers_of(block_of(all[0].script, "points0")).at(0) == std::vector<double>{1.0 / 3, 0.09, 1});
}

TEST_CASE("view: a figure of cost has each line once", "[unit]") {
    const auto all = figures(counting_sample(), PlotFormat::svg, Cost::work);
    REQUIRE(all.size() == 1);
    CHECK_FALSE(block_of(all[0].script, "points1").empty());
    CHECK(block_of(all[0].script, "points2").empty());
    CHECK_THAT(all[0].script, ContainsSubstring("set xlabel 'counted work [chop outs]'"));
    CHECK(numbers_of(block_of(all[0].script, "points0")).at(0) == std::vector<double>{30, 0.09, 1});
}

TEST_CASE("view: widths of several kinds have a table and a figure each, and share the figures of cost", "[unit]") {
    const auto report = mixed_sample();
    CHECK(heads_of(table_model(report)) == std::vector<std::string>{"cells", "iterations"});
    const auto all = figures(report, PlotFormat::svg);
    CHECK(names_of(all) ==
          std::vector<std::string>{"sample_bar-displacement.rms-h-cells", "sample_bar-displacement.rms-h-iterations"});
    CHECK_THAT(all[0].script, ContainsSubstring("set xlabel 'mesh width h [m]'"));
    CHECK_THAT(all[1].script, ContainsSubstring("set xlabel 'last correction"));
    auto timed = report;
    for (auto& run : timed.result.runs) run.seconds = 1;
    const auto costs = figures(timed, PlotFormat::svg, Cost::time);
    REQUIRE(costs.size() == 1);
    CHECK_FALSE(block_of(costs[0].script, "points1").empty());
}
