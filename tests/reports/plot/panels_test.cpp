// The script of a figure of functions in panels.
#include "reports/plot/panels.hpp"

#include <cmath>

#include "tests/catch.hpp"

using namespace ordo::reports;

namespace {

FunctionFigure figure() {
    FunctionFigure figure;
    figure.title = "it's";
    figure.abscissa = "x [cells]";
    figure.to = 2;
    figure.particles = {0.5};
    figure.corners = {0.25, 0.75};
    figure.panels = {{"one", {{{0, 0.5, 1, 1.5, 2}, {{0, 0.5, 1, 1.5, 1}}}}}};
    return figure;
}

std::string script(const FunctionFigure& figure) { return script_of(figure, PlotFormat::svg, "a.svg"); }

}  // namespace

TEST_CASE("panels: the script holds its data, without the points inside straight stretches", "[unit]") {
    CHECK_THAT(script(figure()), ContainsSubstring("$curves0_0 << EOD\n0 0\n1.5 1.5\n2 1\nEOD\n"));
}

TEST_CASE("panels: where there is no value a line breaks, and others go on", "[unit]") {
    auto one = figure();
    one.panels[0].curves[0].values = {{0, 0.5, std::nan(""), 1.5, 2}, {0, 0, 0, 0, 0}};
    CHECK_THAT(script(one), ContainsSubstring("0 0 0\n0.5 0.5 0\n1 NaN 0\n1.5 1.5 0\n2 2 0\n"));
}

TEST_CASE("panels: single points are all drawn", "[unit]") {
    auto one = figure();
    one.panels[0].curves[0].style = Curves::Style::points;
    CHECK_THAT(script(one), ContainsSubstring("0 0\n0.5 0.5\n1 1\n1.5 1.5\n2 1\n"));
}

TEST_CASE("panels: texts are quoted, boxes and particles stand on the floor", "[unit]") {
    CHECK_THAT(script(figure()), ContainsSubstring("'it''s'") &&
                                     ContainsSubstring("from first 0.25,graph 0 to first 0.75") &&
                                     ContainsSubstring("at first 0.5,graph"));
}
