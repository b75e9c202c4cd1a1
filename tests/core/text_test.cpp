#include "core/text.hpp"

#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "tests/catch.hpp"

using namespace ordo;

namespace {

double read(const std::string& text) { return std::strtod(text.c_str(), nullptr); }

/// Doubles of every magnitude: the usual suspects and random bit patterns.
std::vector<double> many_doubles() {
    using limits = std::numeric_limits<double>;
    std::vector<double> values{0.0,           0.1,           1.0 / 3.0,           -2.5e-3, 1e22, 123456789.0,
                               limits::max(), limits::min(), limits::denorm_min()};
    std::mt19937_64 bits(20150301);
    std::uniform_real_distribution<double> exponent(-300, 300);
    for (int k = 0; k < 1000; ++k) values.push_back(std::pow(10.0, exponent(bits)) * (k % 2 == 0 ? 1 : -1));
    return values;
}

}  // namespace

TEST_CASE("text: both number forms read back as the same double", "[unit]") {
    for (const double value : many_doubles()) {
        REQUIRE(read(shortest(value)) == value);
        REQUIRE(read(seventeen_digits(value)) == value);
    }
    CHECK(std::signbit(read(shortest(-0.0))));
}

TEST_CASE("text: shortest has no digit too many, seventeen_digits has all of them", "[unit]") {
    CHECK(shortest(0.1) == "0.1");
    CHECK(shortest(100) == "100");
    CHECK(shortest(1e-3) == "0.001");
    CHECK(shortest(-2.5) == "-2.5");
    // 0.1 is 0.1000000000000000055511 in binary: the 17th digit is the first that shows it.
    CHECK(seventeen_digits(0.1) == "1.0000000000000001e-01");
    CHECK(seventeen_digits(1) == "1.0000000000000000e+00");
}

TEST_CASE("text: what is not finite is called by name", "[unit]") {
    const double inf = std::numeric_limits<double>::infinity();
    for (const auto form : {&shortest, &seventeen_digits}) {
        CHECK(form(std::nan("")) == "nan");
        CHECK(form(inf) == "inf");
        CHECK(form(-inf) == "-inf");
    }
}

TEST_CASE("text: joined puts the separator between words only", "[unit]") {
    const std::vector<std::string> words{"a", "b", "c"};
    CHECK(joined(words) == "a, b, c");
    CHECK(joined(words, "; ") == "a; b; c");
    CHECK(joined(std::vector<std::string>{"a"}) == "a");
    CHECK(joined(std::vector<std::string>{}).empty());
}

TEST_CASE("text: the nearest name undoes one slip of each kind", "[unit]") {
    const std::vector<std::string> names{"cells", "courant", "displacement", "mode", "rho"};
    CHECK(nearest_name("cels", names) == "cells");                 // letter left out
    CHECK(nearest_name("ceells", names) == "cells");               // letter too many
    CHECK(nearest_name("cekls", names) == "cells");                // wrong letter
    CHECK(nearest_name("dispalcement", names) == "displacement");  // two swapped
    CHECK(nearest_name("cells", names) == "cells");
    CHECK(nearest_name("Rho", names) == "rho");
}

TEST_CASE("text: a word that is like none of them has no nearest name", "[unit]") {
    const std::vector<std::string> names{"cells", "rho"};
    CHECK(nearest_name("temperature", names).empty());
    CHECK(nearest_name("", names).empty());
    CHECK(nearest_name("cells", std::vector<std::string>{}).empty());
    // Four letters, two of them wrong: half the word, still near. Three wrong: no more.
    CHECK(nearest_name("abcd", std::vector<std::string>{"abxy"}) == "abxy");
    CHECK(nearest_name("abcd", std::vector<std::string>{"axyz"}).empty());
}

TEST_CASE("text: of two names equally near the first one is taken", "[unit]") {
    CHECK(nearest_name("ux", std::vector<std::string>{"uy", "uz"}) == "uy");
}

TEST_CASE("text: the tail of a message names the nearest, or all valid names", "[unit]") {
    const std::vector<std::string> names{"E", "L", "rho"};
    CHECK(did_you_mean("rhoo", names) == " (nearest: 'rho')");
    CHECK(did_you_mean("temperature", names) == " (valid: E, L, rho)");
    CHECK(did_you_mean("x", std::vector<std::string>{}) == " (none is valid here)");
}
