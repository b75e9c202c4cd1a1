// Columns of numbers as CSV and JSON.
#include "app/columns.hpp"

#include <cmath>

#include "core/error.hpp"
#include "studies/reader/json_input.hpp"
#include "tests/catch.hpp"

using namespace ordo;
using app::Column;
using app::columns_as;
using app::component_names;

namespace {

using Names = std::vector<std::string>;

const std::vector<Column> columns{{"x", {0, 0.1}}, {"stress_xy", {-1.0 / 3, 5e-324}}};

}  // namespace

TEST_CASE("columns: CSV has a head of names and a line a row", "[unit]") {
    CHECK(columns_as("csv", columns, "here") ==
          "x,stress_xy\n"
          "0.0000000000000000e+00,-3.3333333333333331e-01\n"
          "1.0000000000000001e-01,4.9406564584124654e-324\n");
}

TEST_CASE("columns: JSON is a list of rows that reads back to the last bit", "[unit]") {
    const auto rows = studies::parse_json(columns_as("json", columns, "here"), "columns");
    REQUIRE(rows.size() == 2);
    for (std::size_t row = 0; row < 2; ++row) {
        for (const auto& column : columns) CHECK(rows[row][column.name].get<double>() == column.values[row]);
    }
}

TEST_CASE("columns: what has no value is empty in CSV, what is not finite is null in JSON", "[unit]") {
    const std::vector<Column> odd{{"a", {std::nan(""), HUGE_VAL, -HUGE_VAL}}};
    CHECK(columns_as("csv", odd, "here") == "a\n\ninf\n-inf\n");
    for (const auto& row : studies::parse_json(columns_as("json", odd, "here"), "columns")) CHECK(row["a"].is_null());
}

TEST_CASE("columns: a column of names stands beside numbers", "[unit]") {
    const std::vector<Column> named{{"basis", {}, {"linear", "cpdi"}}, {"x", {0, 0.5}}};
    CHECK(columns_as("csv", named, "here") ==
          "basis,x\n"
          "linear,0.0000000000000000e+00\n"
          "cpdi,5.0000000000000000e-01\n");
    const auto rows = studies::parse_json(columns_as("json", named, "here"), "columns");
    REQUIRE(rows.size() == 2);
    CHECK(rows[1]["basis"].get<std::string>() == "cpdi");
    CHECK(rows[1]["x"].get<double>() == 0.5);
}

TEST_CASE("columns: no rows, and no columns", "[unit]") {
    CHECK(columns_as("csv", {{"a", {}}}, "here") == "a\n");
    CHECK(studies::parse_json(columns_as("json", {{"a", {}}}, "here"), "columns").empty());
    CHECK(columns_as("csv", {}, "here") == "\n");
    CHECK(studies::parse_json(columns_as("json", {}, "here"), "columns").empty());
}

TEST_CASE("columns: another format is refused with the nearest", "[unit]") {
    try {
        columns_as("jsn", columns, "ordo solve");
        FAIL("was taken");
    } catch (const InputError& error) {
        CHECK_THAT(error.what(), ContainsSubstring("ordo solve") && ContainsSubstring("nearest: 'json'"));
    }
}

TEST_CASE("columns: components are named by their axes, tensors row by row", "[unit]") {
    CHECK(component_names("stress", 1, 1) == Names{"stress"});
    CHECK(component_names("v", 2, 2) == Names{"v_x", "v_y"});
    CHECK(component_names("v", 3, 3) == Names{"v_x", "v_y", "v_z"});
    CHECK(component_names("s", 4, 2) == Names{"s_xx", "s_xy", "s_yx", "s_yy"});
    const auto tensor = component_names("s", 9, 3);
    CHECK(tensor.size() == 9);
    CHECK(tensor[1] == "s_xy");
    CHECK(tensor[3] == "s_yx");
    CHECK(tensor[8] == "s_zz");
    CHECK(component_names("pressure", 1, 3) == Names{"pressure"});
}
