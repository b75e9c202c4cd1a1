#include "oracles/elastic_constants.hpp"

#include "core/error.hpp"
#include "tests/catch.hpp"

using namespace ordo;
using namespace ordo::oracles;

TEST_CASE("elastic_constants: all six by name, from any two or from the defaults", "[unit]") {
    const Oracle oracle = oracles::elastic_constants_oracle();
    const auto of = [&](const Given& given, const std::string& name) {
        const Exact exact = oracle.bind(resolve(oracle.parameters, given, "", "elastic_constants"));
        CHECK((exact.width() == 0 && exact.jumps(0).empty()));
        for (const auto& constant : exact.constants(std::nullopt)) {
            if (constant.name == name) return std::get<double>(constant.value);
        }
        return -1.0;
    };
    // The defaults, steel's nu: G = E / 2.6, K = E / 1.2, lambda = 3/13 / 0.4 E, M = lambda + 2 G.
    CHECK(of({}, "E") == 1);
    CHECK(of({}, "nu") == 0.3);
    CHECK(of({}, "G") == Approx(1 / 2.6).epsilon(1e-15));
    CHECK(of({}, "K") == Approx(1 / 1.2).epsilon(1e-15));
    CHECK(of({}, "lambda") == Approx(7.5 / 13).epsilon(1e-15));
    CHECK(of({}, "M") == Approx(17.5 / 13).epsilon(1e-15));
    CHECK(of({{"lambda", 2.0}, {"G", 2.0}}, "nu") == 0.25);
    CHECK(of({{"lambda", 2.0}, {"G", 2.0}}, "E") == 5);
    CHECK_THROWS_WITH(
        of({{"E", 9.0}, {"K", 1.0}}, "G"),
        "oracle elastic_constants: no stable solid (K > 0, G > 0) has E = 9 and K = 1; must be 0 < E < 9 K");
    CHECK_THROWS_AS(of({{"E", 9.0}}, "G"), InputError);
}
