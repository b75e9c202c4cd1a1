// ordo basis, from outside.
#include <cmath>
#include <cstdlib>
#include <map>
#include <sstream>

#include "tests/app/process.hpp"
#include "tests/catch.hpp"
#include "tests/reports/samples.hpp"

using namespace ordo;
using outside::Folder;
using outside::Outcome;
using outside::Words;
using samples::Json;

namespace {

Outcome basis(const Words& more, const Folder& folder = {}) {
    Words words{"basis"};
    words.insert(words.end(), more.begin(), more.end());
    return folder.ordo(words);
}

/// The rows of a table as JSON, which names every column.
Json rows_of(Words more) {
    more.insert(more.end(), {"--format", "json"});
    const auto outcome = basis(more);
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    return Json::parse(outcome.out);
}

/// The one row of which `holds`.
template <class Holds>
Json row_where(const Json& rows, Holds&& holds) {
    Json found;
    for (const auto& row : rows) {
        if (holds(row)) found = row;
    }
    REQUIRE_FALSE(found.is_null());
    return found;
}

bool near(const Json& value, double expected) { return std::abs(value.get<double>() - expected) < 1e-9; }

}  // namespace

TEST_CASE("cli: the grid basis as a table", "[cli]") {
    const auto csv = basis({"--basis", "linear"});
    CHECK(csv.code == 0);
    CHECK(csv.err.empty());
    CHECK_THAT(csv.out, ContainsSubstring("basis,x,S_0,S_1,S_2,S_3,S_4,S_5,S_6\nlinear,0.0000000000000000e+00,1.0"));
    const auto rows = rows_of({});
    std::map<std::string, int> count;
    for (const auto& row : rows) ++count[row["basis"].get<std::string>()];
    CHECK(count.size() == 3);
    for (const char* name : {"linear", "ugimp", "cpdi"}) CHECK(count[name] > 240);
    // Boxes of half a cell: the tent's mean over a box around its node is 1 - 1/8, its mean at the corners 1 - 1/4.
    const auto at_node = [&](const std::string& name) {
        return row_where(rows, [&](const Json& row) { return row["basis"] == name && near(row["x"], 3); })["S_3"];
    };
    CHECK(near(at_node("linear"), 1));
    CHECK(near(at_node("ugimp"), 0.875));
    CHECK(near(at_node("cpdi"), 0.75));
}

TEST_CASE("cli: bases of fewer nodes leave cells empty, and all are nine", "[cli]") {
    const auto rows = rows_of({"--basis", "all"});
    std::map<std::string, Json> last;
    for (const auto& row : rows) last[row["basis"].get<std::string>()] = row;
    CHECK(last.size() == 9);
    CHECK(last["linear"]["S_9"].is_null());
    CHECK(near(last["quartic"]["S_9"], 1));  // its last function interpolates at the grid's end
}

TEST_CASE("cli: the particle basis of either option adds up to one", "[cli]") {
    for (const char* option : {"1", "2"}) {
        const auto rows = rows_of({"--show", "particle", "--option", option, "--ppc", "2", "--translate", "0.3"});
        int inside = 0;
        for (const auto& row : rows) {
            CHECK(row["option"] == std::atoi(option));
            if (row["Phi_1"].is_null()) continue;
            double sum = 0;
            for (int p = 1; p <= 8; ++p) sum += row["Phi_" + std::to_string(p)].get<double>();
            CHECK(std::abs(sum - 1) < 1e-9);
            ++inside;
        }
        CHECK(inside > 3 * 100);
    }
}

TEST_CASE("cli: the reproduction of a constant and a linear field, and its largest errors", "[cli]") {
    const Words state{"--basis", "cpdi", "--ppc", "2", "--translate", "0.3"};
    Words words = state;
    words.insert(words.end(), {"--show", "reproduction"});
    double worst = 0;
    int at_particles = 0;
    for (const auto& row : rows_of(words)) {
        at_particles += row["at_particle"] == 1 ? 1 : 0;
        const double error = std::abs(row["linear"].get<double>() - row["x"].get<double>());
        if (row["option"] == 2) CHECK(error < 1e-12);
        else if (row["at_particle"] == 0) worst = std::max(worst, error);
        CHECK(std::abs(row["constant"].get<double>() - 1) < 1e-12);
    }
    CHECK(at_particles == 2 * 8);
    words = state;
    words.insert(words.end(), {"--show", "errors"});
    const auto errors = rows_of(words);
    REQUIRE(errors.size() == 2);
    CHECK(errors[0]["particles"] == 8);
    CHECK(errors[0]["nodes"] == errors[0]["rank"]);
    CHECK(std::abs(errors[0]["linear_between"].get<double>() - worst) < 1e-12);
    CHECK(errors[1]["linear_between"].get<double>() < 1e-12);
}

TEST_CASE("cli: errors of many states, a row each", "[cli]") {
    const auto rows = rows_of({"--show", "errors", "--basis", "linear", "--option", "2", "--ppc", "1:2:2",
                               "--translate", "0.1:0.4:4", "--stretch", "1:1.05:2"});
    REQUIRE(rows.size() == 16);
    for (const auto& row : rows) {
        const auto error = row["linear_between"].get<double>();
        if (row["ppc"] == 1) CHECK(error > 1e-3);  // fewer particles than nodes
        if (row["ppc"] == 2 && row["stretch"] == 1) CHECK(error < 1e-12);
    }
}

TEST_CASE("cli: the tents as cpdi interpolates them are empty off the body", "[cli]") {
    const auto rows = rows_of({"--show", "interpolated"});
    CHECK(rows.front()["basis"] == "cpdi");
    CHECK(rows.front()["S_0"].is_null());
    const auto middle = row_where(rows, [](const Json& row) { return near(row["x"], 3.25); });
    CHECK(near(middle["S_3"], 0.75));
}

TEST_CASE("cli: the basis as a picture and its script", "[cli]") {
    for (const Words& more : {Words{}, Words{"--show", "interpolated", "--show", "particle", "--option", "2"},
                              Words{"--basis", "all", "--show", "grid"}, Words{"--ppc", "0.5"}}) {
        const Folder folder;
        Words words{"--plot", "made/picture.svg"};
        words.insert(words.end(), more.begin(), more.end());
        const auto outcome = basis(words, folder);
        INFO(outcome.err);
        CHECK(outcome.code == 0);
        CHECK(outcome.out == "made/picture.gp\nmade/picture.svg\n");
        CHECK_THAT(folder.read("made/picture.svg"), ContainsSubstring("</svg>") && ContainsSubstring("translate = 0"));
    }
}

TEST_CASE("cli: what is no basis, no view, no state is refused, and nothing is written", "[cli]") {
    const std::vector<std::pair<Words, std::string>> wrong{
        {{"--basis", "cpdy"}, "nearest: 'cpdi'"},
        {{"--basis", "linear", "--basis", "linear"}, "given twice"},
        {{"--basis", "all", "--basis", "cpdi"}, "'all' stands alone"},
        {{"--show", "particles"}, "nearest: 'particle'"},
        {{"--show", "grid", "--show", "particle"}, "with --plot only"},
        {{"--show", "errors", "--plot", "a.svg"}, "nearest: 'reproduction'"},
        {{"--show", "interpolated", "--basis", "ugimp"}, "nearest: 'cpdi'"},
        {{"--option", "3"}, "no option '3'"},
        {{"--ppc", "5"}, "'ppc' is 5, but must be in [0.5, 4]"},
        {{"--ppc", "nan"}, "'nan'"},
        {{"--ppc", "two"}, "'two'"},
        {{"--ppc", "1:2:3"}, "--show errors alone"},
        {{"--show", "errors", "--cells", "6:8:3"}, "is a range"},
        {{"--show", "errors", "--ppc", "0.4:2:3"}, "'ppc' is 0.4"},
        {{"--show", "errors", "--ppc", "1:2:200", "--stretch", "1:1.2:200"}, "more than 10000"},
        {{"--cells", "6.5"}, "a whole number in [3, 64]"},
        {{"--margin", "3"}, "nearest: 2"},
        {{"--stretch", "0"}, "'stretch' is 0"},
        {{"--stretch", "2"}, "nearest: cells 8 with margin 2"},
        {{"--translate", "-1.5", "--plot", "a.svg"}, "must stay on the grid from 0 to 6"},
        {{"--format", "cvs"}, "csv"},
        {{"--plot", "a.gif"}, ".svg, .pdf or .png"},
        {{"--plot", "a.svg", "--format", "json"}, "not from --format"},
        {{"--plot", ""}, "--plot is empty"},
        {{"cpdi"}, "too many words"},
        {{"--bases", "cpdi"}, "nearest: '--basis'"},
    };
    for (const auto& [words, part] : wrong) {
        const Folder folder;
        const auto outcome = basis(words, folder);
        INFO(outcome.err);
        CHECK(outcome.code == 2);
        CHECK(outcome.err_lines() == 1);
        CHECK(outcome.out.empty());
        CHECK(folder.names().empty());
        CHECK_THAT(outcome.err, ContainsSubstring(part));
    }
}
