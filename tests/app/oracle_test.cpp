// ordo oracle, from outside.
#include <cstdlib>
#include <sstream>

#include "oracles/bars/bar_vibration.hpp"
#include "tests/app/process.hpp"
#include "tests/catch.hpp"
#include "tests/reports/samples.hpp"

using namespace ordo;
using outside::Folder;
using outside::Outcome;
using outside::Words;
using samples::Json;

namespace {

Outcome oracle(const Words& more) {
    Words words{"oracle", "bar_vibration"};
    words.insert(words.end(), more.begin(), more.end());
    return Folder().ordo(words);
}

std::vector<std::string> lines_of(const std::string& text) {
    std::istringstream stream(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

/// The first two numbers of a row: x and displacement.
std::pair<double, double> row(const std::string& line) {
    char* end = nullptr;
    const double x = std::strtod(line.c_str(), &end);
    return {x, std::strtod(end + 1, nullptr)};
}

}  // namespace

TEST_CASE("cli: an exact solution with 17 digits, bit for bit", "[cli]") {
    const auto outcome = oracle({"--t", "0.5", "--x", "0.1,5,25"});
    CHECK(outcome.code == 0);
    CHECK(outcome.err.empty());
    const auto lines = lines_of(outcome.out);
    REQUIRE(lines.size() == 4);
    CHECK(lines[0] == "x,displacement,velocity,stress,strain");
    const oracles::BarVibration bar{
        .L = 25, .E = 100, .rho = 1, .v0 = 0.1, .mode = 1, .ends = oracles::BarVibration::Ends::fixed_free};
    for (const auto& [k, x] : {std::pair{1, 0.1}, {2, 5.0}, {3, 25.0}}) {
        CHECK(row(lines[static_cast<std::size_t>(k)]).first == x);
        CHECK(row(lines[static_cast<std::size_t>(k)]).second == bar.displacement(x, 0.5));
    }
    CHECK_THAT(lines[1], ContainsSubstring("1.0000000000000001e-01,"));  // the 17th digit of 0.1
}

TEST_CASE("cli: the same numbers as JSON", "[cli]") {
    const auto csv = lines_of(oracle({"--t", "0.5", "--x", "5"}).out);
    const auto json = Json::parse(oracle({"--t", "0.5", "--x", "5", "--format", "json"}).out);
    REQUIRE(json.size() == 1);
    CHECK(json[0]["displacement"].get<double>() == row(csv.at(1)).second);
}

TEST_CASE("cli: a grid has both of its ends, to the last bit", "[cli]") {
    const auto rising = lines_of(oracle({"--set", "L=0.9", "--t", "1", "--grid", "0.3:0.9:4"}).out);
    REQUIRE(rising.size() == 5);
    CHECK(row(rising[1]).first == 0.3);
    CHECK(row(rising[4]).first == 0.9);  // 0.3 + (0.9 - 0.3) is more, and outside the bar
    const auto falling = lines_of(oracle({"--t", "1", "--grid", "25:0:3"}).out);
    REQUIRE(falling.size() == 4);
    CHECK(row(falling[1]).first == 25);
    CHECK(row(falling[2]).first == 12.5);
    CHECK(row(falling[3]).first == 0);
}

TEST_CASE("cli: parameters are those that are set", "[cli]") {
    const auto lines = lines_of(oracle({"--set", "mode=3", "--set", "ends=fixed_fixed", "--t", "1", "--x", "5"}).out);
    const oracles::BarVibration bar{
        .L = 25, .E = 100, .rho = 1, .v0 = 0.1, .mode = 3, .ends = oracles::BarVibration::Ends::fixed_fixed};
    CHECK(row(lines.at(1)).second == bar.displacement(5, 1));
}

TEST_CASE("cli: what cannot be evaluated is refused", "[cli]") {
    const std::vector<std::pair<Words, std::string>> wrong{
        {{"--x", "5"}, "--t"},
        {{"--t", "1"}, "--grid"},
        {{"--t", "1", "--x", "5", "--grid", "0:1:2"}, "exactly one of --x, --grid, --points and --cells"},
        {{"--t", "1", "--x", "25.1"}, "outside [0, 25]"},
        {{"--t", "1", "--x", "5,-1"}, "outside [0, 25]"},
        {{"--t", "1", "--grid", "0:26:3"}, "outside [0, 25]"},
        {{"--t", "1", "--x", "5,"}, "''"},
        {{"--t", "1", "--x", "nan"}, "'nan'"},
        {{"--t", "1", "--x", "1e999"}, "'1e999'"},
        {{"--t", "inf", "--x", "5"}, "'inf'"},
        {{"--t", "soon", "--x", "5"}, "'soon'"},
        {{"--t", "1", "--grid", "0:1"}, "FROM:TO:N"},
        {{"--t", "1", "--grid", "0:1:1"}, "[2, 1e7]"},
        {{"--t", "1", "--grid", "0:1:2.5"}, "[2, 1e7]"},
        {{"--t", "1", "--grid", "0:1:1e300"}, "[2, 1e7]"},
        {{"--t", "1", "--x", "5", "--set", "Emodul=5"}, "'Emodul'"},
        {{"--t", "1", "--x", "5", "--set", "E=0"}, "> 0"},
        {{"--t", "1", "--x", "5", "--set", "ends=fixed_fre"}, "nearest: 'fixed_free'"},
        {{"--t", "1", "--x", "5", "--format", "cvs"}, "csv"},
    };
    for (const auto& [words, part] : wrong) {
        const auto outcome = oracle(words);
        INFO(outcome.err);
        CHECK(outcome.code == 2);
        CHECK(outcome.err_lines() == 1);
        CHECK(outcome.out.empty());
        CHECK_THAT(outcome.err, ContainsSubstring(part));
    }
    const auto outcome = Folder().ordo({"oracle", "bar_vibraton", "--t", "1", "--x", "1"});
    CHECK(outcome.code == 2);
    CHECK_THAT(outcome.err, ContainsSubstring("nearest: 'bar_vibration'"));
}
