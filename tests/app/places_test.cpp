// Where an exact solution is asked for, from outside: lists, lines, files, cells; and what does not depend on x.
#include <cmath>
#include <sstream>

#include "app/constants.hpp"
#include "studies/reader/json_input.hpp"
#include "tests/app/process.hpp"
#include "tests/catch.hpp"

using namespace ordo;
using outside::Folder;
using outside::Outcome;
using outside::Words;

namespace {

/// `ordo oracle free_flight` in two dimensions at t = 1, where displacement is (1, -0.5) everywhere.
Outcome plane(const Folder& folder, const Words& more) {
    Words words{"oracle", "free_flight", "--set", "dim=2", "--t", "1"};
    words.insert(words.end(), more.begin(), more.end());
    return folder.ordo(words);
}

std::string first_columns(const std::string& row) { return row.substr(0, row.find(',', row.find(',') + 1)); }

std::vector<std::string> places_of(const Outcome& outcome) {
    std::istringstream stream(outcome.out);
    std::vector<std::string> rows;
    for (std::string row; std::getline(stream, row);) rows.push_back(first_columns(row));
    return rows;
}

const std::vector<std::string> two_points{"x,y", "0.0000000000000000e+00,5.0000000000000000e-01",
                                          "1.0000000000000000e+00,2.5000000000000000e-01"};

}  // namespace

TEST_CASE("cli: points of a plane by list, by line and by file are the same points", "[cli]") {
    const Folder folder;
    folder.write("p.csv", "x, y\n0, 0.5\r\n\n1,\t0.25\n");
    folder.write("bare.csv", "0,0.5\n1,0.25");
    for (const Words& words : std::vector<Words>{
             {"--x", "0:0.5,1:0.25"}, {"--grid", "0,0.5:1,0.25:2"}, {"--points", "p.csv"}, {"--points", "bare.csv"}}) {
        const auto outcome = plane(folder, words);
        INFO(words[0] << ' ' << outcome.err);
        CHECK(outcome.code == 0);
        CHECK(places_of(outcome) == two_points);
    }
}

TEST_CASE("cli: points that cannot be are refused with their line", "[cli]") {
    const Folder folder;
    folder.write("three.csv", "x,y\n0,1\n0,1,2\n");
    folder.write("word.csv", "0,1\n0,one\n");
    folder.write("empty.csv", "x,y\n\n");
    const std::vector<std::pair<Words, std::string>> wrong{
        {{"--points", "three.csv"}, "three.csv:3: '0,1,2' has 3 coordinates"},
        {{"--points", "word.csv"}, "word.csv:2: 'one'"},
        {{"--points", "empty.csv"}, "holds no point"},
        {{"--points", "none.csv"}, "cannot read"},
        {{"--grid", "0:1:3"}, "has 1 coordinates, but must have 2"},
        {{"--cells", "0:1:3"}, "one dimension"},
        {{"--x", "0:0", "--points", "three.csv"}, "exactly one of"},
        {{"--x", "0:2"}, "outside [0, 1]"},
        {{"--x", "0:0", "--plot", "a.svg"}, "two different places"},
        {{"--grid", "0,0:1,1:3", "--plot", "a.gif"}, ".svg, .pdf or .png"},
        {{"--constants"}, "has none"},
        {{"--x", "0:0", "--constants"}, "stands alone"},
    };
    const auto before = folder.names();
    for (const auto& [words, part] : wrong) {
        const auto outcome = plane(folder, words);
        INFO(part << " | " << outcome.err);
        CHECK(outcome.code == 2);
        CHECK(outcome.err_lines() == 1);
        CHECK(outcome.out.empty());
        CHECK_THAT(outcome.err, ContainsSubstring(part));
    }
    CHECK(folder.names() == before);
    CHECK(folder.ordo({"oracle", "bar_vibration", "--t", "-1", "--x", "1"}).code == 2);
    CHECK_THAT(folder.ordo({"oracle", "bar_vibration", "--t", "-1", "--x", "1"}).err,
               ContainsSubstring("must be in [0"));
}

TEST_CASE("cli: a history at one place", "[cli]") {
    const Folder folder;
    const auto outcome = folder.ordo({"oracle", "free_flight", "--t", "0:2:3", "--x", "0.5"});
    CHECK(outcome.code == 0);
    std::istringstream rows(outcome.out);
    std::string row;
    std::getline(rows, row);
    CHECK(row.starts_with("t,x,displacement,velocity"));
    for (const char* begin : {"0.0", "1.0", "2.0"}) {
        std::getline(rows, row);
        CHECK(row.starts_with(begin));
    }
    CHECK_THAT(row, ContainsSubstring(",5.0000000000000000e-01,0.0000000000000000e+00,-1.0000000000000000e+00,"));
    CHECK(folder.ordo({"oracle", "free_flight", "--t", "0:2:3", "--x", "0.5,0.6"}).code == 2);
    CHECK(folder.ordo({"oracle", "free_flight", "--t", "-1:2:3", "--x", "0.5"}).code == 2);
    CHECK(folder.ordo({"oracle", "free_flight", "--t", "0:2:3", "--x", "0.5", "--plot", "h.svg"}).code == 0);
    CHECK_THAT(folder.read("h.svg"), ContainsSubstring("t [s]") && ContainsSubstring("x = 0.5 m"));
}

TEST_CASE("cli: a picture of the fields along a line, and its script", "[cli]") {
    const Folder folder;
    const auto outcome = plane(folder, {"--grid", "0,0:1,1:5", "--plot", "out/flight.svg"});
    CHECK(outcome.code == 0);
    CHECK(outcome.out == "out/flight.gp\nout/flight.svg\n");
    const std::string text = folder.read("out/flight.svg");
    for (const char* word : {"free_flight", "dim=2, t = 1 s", "displacement [m]", "xy", "distance along the line"})
        CHECK_THAT(text, ContainsSubstring(word));
}

TEST_CASE("constants: numbers with 17 digits, words, and lists of records; null for what has no value", "[unit]") {
    const oracles::Constants constants{
        {"p_star", 0.1},
        {"v_star", std::nan("")},
        {"kind", std::string("vacuum")},
        {"waves", std::vector<oracles::Constants>{{{"side", std::string("left")}, {"speed", -0.5}}, {{"head", 1.0}}}}};
    const auto text = app::constants_as_json(constants);
    CHECK_THAT(text, ContainsSubstring("1.0000000000000001e-01"));
    const auto json = studies::parse_json(text, "constants");
    CHECK(json["p_star"].get<double>() == 0.1);
    CHECK(json["v_star"].is_null());
    CHECK(json["kind"] == "vacuum");
    REQUIRE(json["waves"].size() == 2);
    CHECK(json["waves"][0]["side"] == "left");
    CHECK(json["waves"][0]["speed"].get<double>() == -0.5);
    CHECK(json["waves"][1]["head"].get<double>() == 1);
    CHECK(studies::parse_json(app::constants_as_json({}), "constants").empty());
}

TEST_CASE("cli: an exact solution refuses what would be a lie", "[cli]") {
    const Folder folder;
    const std::vector<std::pair<Words, std::string>> wrong{
        {{"noh", "--t", "0.3", "--cells", "0.5:0.5000000000000002:3"}, "more cells than there are numbers"},
        {{"free_flight", "--t", "1e200", "--x", "0"}, "beyond 1.8e308"},
        {{"noh", "--set", "gamma=1.4", "--set", "gamma=1.5", "--t", "1", "--x", "0"}, "set twice"},
        {{"riemann_gas", "--t", "1", "--grid", "-1e308:1e308:3"}, "spans more than"},
        {{"elastic_constants", "--t", "0", "--x", "0"}, "no fields"},
        {{"sedov", "--constants", "--format", "csv"}, "stands alone"},
        {{"noh", "--t", "1", "--grid", "0:1:3", "--format", "json", "--plot", "a.svg"}, "picture's name"},
        {{"noh", "--t", "1", "--points", "."}, "cannot read"},
        {{"bar_vibration", "--set", "K=2", "--t", "1", "--x", "0"}, "only K = 2 is given"},
    };
    for (const auto& [more, part] : wrong) {
        Words words{"oracle"};
        words.insert(words.end(), more.begin(), more.end());
        const auto outcome = folder.ordo(words);
        INFO(part << " | " << outcome.err);
        CHECK(outcome.code == 2);
        CHECK(outcome.err_lines() == 1);
        CHECK(outcome.out.empty());
        CHECK_THAT(outcome.err, ContainsSubstring(part));
    }
    CHECK(folder.names().empty());
    CHECK(folder.ordo({"oracle", "noh", "--set", "v0=.5", "--t", "1.", "--x", ".2"}).code == 0);
}
