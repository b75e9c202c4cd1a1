// ordo fit, from outside.
#include <cmath>

#include "tests/app/samples.hpp"

using namespace ordo;
using outside::Folder;
using outside::Words;

namespace {

/// A table of h, dt and h^2 + dt / 2 over 4 x 4 points.
std::string grid_table() {
    std::string text = "h,dt,l2\n";
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 4; ++j) {
            const double h = std::pow(2, -i), dt = std::pow(4, -j);
            text += std::to_string(h) + "," + std::to_string(dt) + "," + std::to_string(h * h + dt / 2) + "\n";
        }
    }
    return text;
}

samples::Json answer(const Folder& folder, Words words) {
    words.insert(words.end(), {"--format", "json"});
    return samples::Json::parse(folder.ordo(words).out);
}

}  // namespace

TEST_CASE("cli: the order in a user's own errors", "[cli]") {
    const Folder folder;
    folder.write("e.csv", "# from another code\nh,error\n1,1\n0.5,0.25\n0.25,0.0625\n0.125,0.015625\n");
    const auto fit = folder.ordo({"fit", "e.csv"});
    CHECK(fit.code == 0);
    CHECK(fit.err.empty());
    CHECK_THAT(fit.out, ContainsSubstring("order 2 [2, 2]") && ContainsSubstring("converges: "));
    const auto json = answer(folder, {"fit", "e.csv"});
    CHECK(json["verdict"] == "converges");
    CHECK(json["measured"] == "error");
    CHECK(json["order"]["value"].get<double>() == Approx(2));
    CHECK(json["order"]["neighbours"].size() == 3);
    folder.write("bare", "1 1\n0.5 0.25\n0.25 0.0625\n");
    CHECK(folder.ordo({"fit", "bare"}).code == 0);
    folder.write("grows", "1 1\n0.5 2\n0.25 4\n");
    const auto grows = folder.ordo({"fit", "grows"});
    CHECK(grows.code == 1);
    CHECK_THAT(grows.out, ContainsSubstring("diverges: "));
    folder.write("nan", "1 1\n0.5 nan\n0.25 0.1\n");
    const auto no_number = folder.ordo({"fit", "nan"});
    CHECK(no_number.code == 1);
    CHECK_THAT(no_number.out, ContainsSubstring("nan") && ContainsSubstring("0.5"));
}

TEST_CASE("cli: numbers of cells are taken as what they are", "[cli]") {
    const Folder folder;
    folder.write("n.csv", "cells,error\n10,1\n20,0.25\n40,0.0625\n80,0.015625\n");
    const auto counts = folder.ordo({"fit", "n.csv"});
    CHECK(counts.code == 1);
    CHECK_THAT(counts.out, ContainsSubstring("diverges: ") && ContainsSubstring("--abscissa 1/cells"));
    const auto widths = folder.ordo({"fit", "n.csv", "--abscissa", "1/cells"});
    CHECK(widths.code == 0);
    CHECK_THAT(widths.out, ContainsSubstring("order 2 [2, 2]"));
    CHECK(folder.ordo({"fit", "n.csv", "--abscissa", "1/nodes"}).code == 2);
}

TEST_CASE("cli: values without an exact solution", "[cli]") {
    const Folder folder;
    folder.write("v.csv", "h,f,g\n1,0.970500,1\n2,0.968540,1\n4,0.961780,1\n");
    CHECK(folder.ordo({"fit", "v.csv", "--value", "f"}).code == 1);  // three grids prove no order by themselves
    CHECK(folder.ordo({"fit", "v.csv", "--value", "h"}).code == 2);  // a column against itself
    const auto fit = folder.ordo({"fit", "v.csv", "--value", "f", "--formal", "2"});
    CHECK(fit.code == 0);
    CHECK_THAT(fit.out, ContainsSubstring("no exact solution: Richardson") && ContainsSubstring("order 1.78617") &&
                            ContainsSubstring("limit 0.9713"));
    const auto json = answer(folder, {"fit", "v.csv", "--value", "f"});
    CHECK(json["extrapolations"].size() == 4);
    CHECK(json["extrapolations"][1]["method"] == "GCI");
    CHECK(json["extrapolations"][2]["limit"].is_null());  // Eca-Hoekstra wants four grids
    CHECK(folder.ordo({"fit", "v.csv", "--value", "g"}).code == 1);
    folder.write("four", "1 1.01\n2 1.04\n4 1.16\n8 1.64\n");  // 1 + h^2/100
    CHECK(folder.ordo({"fit", "four", "--value", "f", "--formal", "2"}).code == 0);
    CHECK(folder.ordo({"fit", "four", "--value", "f", "--formal", "4"}).code == 1);
    folder.write("two", "1 1.5\n2 3\n");
    CHECK_THAT(folder.ordo({"fit", "two", "--value", "f"}).out, ContainsSubstring("no formal order"));
    CHECK_THAT(folder.ordo({"fit", "two", "--value", "f", "--formal", "1"}).out,
               ContainsSubstring("factor of safety 3"));
}

TEST_CASE("cli: a joint fit of mesh width and step", "[cli]") {
    const Folder folder;
    folder.write("g.csv", grid_table());
    const auto fit = folder.ordo({"fit", "g.csv", "--abscissa", "h,dt", "--error", "l2"});
    CHECK(fit.code == 0);
    CHECK_THAT(fit.out, ContainsSubstring("order in h:") && ContainsSubstring("next run: h ="));
    const auto json = answer(folder, {"fit", "g.csv", "--abscissa", "h,dt", "--error", "l2"});
    CHECK(json["joint"]["p"]["value"].get<double>() == Approx(2).margin(1e-3));  // the table has six decimals
    CHECK(json["joint"]["q"]["value"].get<double>() == Approx(1).margin(1e-3));
    CHECK(json["joint"]["shares"].size() == 16);
    CHECK(json["joint"]["f"]["value"].is_null());
}

TEST_CASE("cli: a fit of what is no table, or of columns that are not there, is refused", "[cli]") {
    const Folder folder;
    folder.write("e.csv", "h,dt,error\n1,1,1\n0.5,1,0.25\n");
    folder.write("bare", "1 2 3\n4 5 6\n");
    folder.write("words", "h,error\n1,x\n");
    folder.write("empty", "");
    const std::vector<std::pair<Words, std::string>> faults{
        {{"fit"}, "takes one table"},
        {{"fit", "none.csv"}, "there is no such file"},
        {{"fit", "empty"}, "no row"},
        {{"fit", "words"}, "line 2: 'x' is not a number"},
        {{"fit", "bare"}, "has 3 columns without names, but must have 2"},
        {{"fit", "e.csv", "--error", "eror"}, "nearest: 'error'"},
        {{"fit", "e.csv", "--abscissa", "d"}, "there is no column 'd'"},
        {{"fit", "e.csv", "--abscissa", "h,dt,x"}, "more than two"},
        {{"fit", "e.csv", "--abscissa", "h,h"}, "stands twice"},
        {{"fit", "e.csv", "--abscissa", "h,"}, "there is no column ''"},
        {{"fit", "e.csv", "--value", "error", "--error", "error"}, "not both"},
        {{"fit", "e.csv", "--value", "error", "--abscissa", "h,dt"}, "one abscissa"},
        {{"fit", "e.csv", "--formal", "2"}, "belongs to --value"},
        {{"fit", "e.csv", "--value", "error", "--formal", "0"}, "must be > 0"},
        {{"fit", "e.csv", "--format", "csv"}, "no format 'csv'"}};
    for (const auto& [words, part] : faults) {
        INFO(part);
        const auto fit = folder.ordo(words);
        CHECK(fit.code == 2);
        CHECK(fit.err_lines() == 1);
        CHECK(fit.out.empty());
        CHECK_THAT(fit.err, ContainsSubstring(part));
    }
}
