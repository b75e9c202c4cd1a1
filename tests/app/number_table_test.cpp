#include "app/number_table.hpp"

#include <cmath>

#include "core/error.hpp"
#include "tests/catch.hpp"

using namespace ordo;
using app::number_table;

using Rows = std::vector<std::vector<double>>;

TEST_CASE("number table: commas or blanks, a head or none, comments", "[unit]") {
    const Rows rows{{1, 0.5}, {0.5, 1e-3}};
    for (const std::string text : {"1,0.5\n0.5,1e-3\n", "1 0.5\n0.5\t1e-3", "# a\n\n  1  0.5 \n#b\n0.5 1e-3\n",
                                   "1, 0.5\r\n0.5, 1e-3\r\n", "\"1\",\"0.5\"\n0.5,1e-3\n"}) {
        INFO(text);
        const auto table = number_table(text, "t");
        CHECK(table.names.empty());
        CHECK(table.rows == rows);
    }
    for (const std::string text : {"h,error\n1,0.5\n0.5,1e-3\n", "h error\n1 0.5\n0.5 1e-3\n",
                                   "\xEF\xBB\xBF\"h\",\"error\"\r\n1,0.5\r\n0.5,1e-3\r\n"}) {
        INFO(text);
        const auto table = number_table(text, "t");
        CHECK(table.names == std::vector<std::string>{"h", "error"});
        CHECK(table.rows == rows);
        CHECK(table.column("error", 0, "t") == std::vector<double>{0.5, 1e-3});
    }
    CHECK(std::isnan(number_table("1 nan\n", "t").rows[0][1]));
    CHECK(std::isinf(number_table("1 inf\n", "t").rows[0][1]));
}

TEST_CASE("number table: what is none is refused with its line", "[alarm]") {
    const auto [text, words] = GENERATE(table<std::string, std::string>({{"", "no row"},
                                                                         {"# 1 2\n", "no row"},
                                                                         {"h,error\n", "no row"},
                                                                         {"1,2\n3\n", "line 2: has 1 cells"},
                                                                         {"1,2\n3,4,5\n", "line 2: has 3 cells"},
                                                                         {"1,2\n3,\n", "line 2: '' is not a number"},
                                                                         {"1,2\n\n3,x\n", "line 3: 'x'"},
                                                                         {"1 2\n3 1e999\n", "'1e999'"},
                                                                         {"1 2\n3 0x1p3\n", "'0x1p3'"},
                                                                         {"h,h\n1,2\n", "'h' stands twice"},
                                                                         {"h,\n1,2\n", "no name"}}));
    INFO(text);
    CHECK_THROWS_WITH(number_table(text, "t"), ContainsSubstring("t: ") && ContainsSubstring(words));
    CHECK_THROWS_WITH(number_table("h,error\n1,2\n", "t").column("eror", 0, "t"),
                      ContainsSubstring("nearest: 'error'"));
}
