#include <set>
#include <string>

#include "core/error.hpp"
#include "oracles/oracle.hpp"
#include "tests/catch.hpp"

using namespace ordo;
using namespace ordo::oracles;

TEST_CASE("oracle catalogue: a misspelt name is refused with the nearest one", "[unit]") {
    CHECK(oracle_named("bar_vibration", "").name == "bar_vibration");
    CHECK_THROWS_WITH(oracle_named("bar_vibratoin", "bar.json: /scene/oracle"),
                      "bar.json: /scene/oracle: there is no exact solution 'bar_vibratoin' (nearest: 'bar_vibration')");
    CHECK_THROWS_AS(oracle_named("", ""), InputError);
}

TEST_CASE("oracle catalogue: every exact solution says what it is, and binds at its defaults", "[unit]") {
    std::set<std::string> names;
    for (const auto& oracle : all_oracles()) {
        INFO(oracle.name);
        CHECK(names.insert(oracle.name).second);
        CHECK_FALSE(oracle.about.empty());
        CHECK_FALSE(oracle.source.empty());
        CHECK_FALSE(oracle.accuracy.empty());
        CHECK_FALSE(oracle.smoothness.empty());
        const Exact exact = oracle.bind(resolve(oracle.parameters, {}, "", oracle.name));
        const auto dim = static_cast<std::size_t>(exact.dim);
        CHECK((exact.lower.size() == dim && exact.upper.size() == dim));
        REQUIRE(exact.fields.size() == oracle.fields.size());
        for (std::size_t i = 0; i < exact.fields.size(); ++i) {
            CHECK(exact.fields[i].name == oracle.fields[i].name);
            CHECK(exact.fields[i].unit == oracle.fields[i].unit);
            CHECK(exact.fields[i].rank == oracle.fields[i].rank);
        }
        CHECK_FALSE(exact.offset("no such field").has_value());
    }
}
