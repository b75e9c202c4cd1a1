#include "core/parameter.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "tests/catch.hpp"

using namespace ordo;

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
const double nan_value = std::nan("");

/// One parameter of each kind, and one of each way to have no default.
std::vector<Parameter> declared() {
    return {number("E", "Pa", 100, positive, "modulus"),
            number("v0", "m/s", 0.1, ordo::finite, "speed"),
            required(whole("cells", 1, between(1, 512), "cells")),
            word("ends", "fixed_free", {{"fixed_free", ""}, {"fixed_fixed", ""}}, "ends"),
            toggle("half_kick", false, "leapfrog"),
            without_default(number("dt", "s", 0, positive, "step"))};
}

Values resolved(const Given& given) { return resolve(declared(), given, "bar.json: /scene", "scene bar"); }

/// The message that refuses `name` = `value` (with `cells` given, so that nothing else is wrong).
std::string refusal(const std::string& name, const Value& value) {
    Given given{{"cells", 8.0}};
    given[name] = value;
    try {
        resolved(given);
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

}  // namespace

TEST_CASE("parameter: defaults are filled in, given values kept, what may be absent stays absent", "[unit]") {
    const Values values = resolved({{"cells", 8.0}, {"E", 5.0}});
    CHECK(values.number("E") == 5);
    CHECK(values.number("v0") == 0.1);
    CHECK(values.whole("cells") == 8);
    CHECK(values.word("ends") == "fixed_free");
    CHECK_FALSE(values.toggle("half_kick"));
    CHECK_FALSE(values.has("dt"));
    CHECK(values.all().size() == 5);
    CHECK(resolved({{"cells", 8.0}, {"dt", 0.5}}).number("dt") == 0.5);
}

TEST_CASE("parameter: a value out of its range is refused with member, value and rule", "[unit]") {
    CHECK(refusal("E", -1.0) == "bar.json: /scene: 'E' is -1, but must be > 0");
    CHECK(refusal("E", 0.0) == "bar.json: /scene: 'E' is 0, but must be > 0");
    CHECK(refusal("cells", 513.0) == "bar.json: /scene: 'cells' is 513, but must be a whole number in [1, 512]");
    CHECK(refusal("cells", 0.0) == "bar.json: /scene: 'cells' is 0, but must be a whole number in [1, 512]");
    CHECK(refusal("cells", 1.0) == "accepted");
    CHECK(refusal("cells", 512.0) == "accepted");
}

TEST_CASE("parameter: NaN, infinities and fractions are refused", "[unit]") {
    for (const double value : {nan_value, inf, -inf}) {
        const std::string shown = std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf";
        CHECK(refusal("v0", value) == "bar.json: /scene: 'v0' is " + shown + ", but must be finite");
        CHECK(refusal("E", value) == "bar.json: /scene: 'E' is " + shown + ", but must be > 0");
        CHECK(refusal("cells", value) ==
              "bar.json: /scene: 'cells' is " + shown + ", but must be a whole number in [1, 512]");
    }
    CHECK(refusal("cells", 2.5) == "bar.json: /scene: 'cells' is 2.5, but must be a whole number in [1, 512]");
}

TEST_CASE("parameter: a value of another type is refused, strings in quotes", "[unit]") {
    CHECK(refusal("E", "100") == "bar.json: /scene: 'E' is '100', but must be a number, > 0");
    CHECK(refusal("v0", true) == "bar.json: /scene: 'v0' is true, but must be a number, finite");
    CHECK(refusal("cells", "many") == "bar.json: /scene: 'cells' is 'many', but must be a whole number in [1, 512]");
    CHECK(refusal("ends", 1.0) ==
          "bar.json: /scene: 'ends' is 1, but must be a string, one of: fixed_free, fixed_fixed");
    CHECK(refusal("half_kick", 1.0) == "bar.json: /scene: 'half_kick' is 1, but must be true or false");
    CHECK(refusal("half_kick", "true") == "bar.json: /scene: 'half_kick' is 'true', but must be true or false");
}

TEST_CASE("parameter: a word out of its set is refused with the nearest one", "[unit]") {
    CHECK(
        refusal("ends", "fixd_free") ==
        "bar.json: /scene: 'ends' is 'fixd_free', but must be one of: fixed_free, fixed_fixed (nearest: 'fixed_free')");
    CHECK_THAT(refusal("ends", "periodic"), ContainsSubstring("(valid: fixed_free, fixed_fixed)"));
}

TEST_CASE("parameter: an unknown name is refused with its owner and the nearest name", "[unit]") {
    CHECK(refusal("cels", 8.0) == "bar.json: /scene: 'cels' is not a parameter of scene bar (nearest: 'cells')");
    CHECK(refusal("temperature", 8.0) ==
          "bar.json: /scene: 'temperature' is not a parameter of scene bar (valid: E, v0, cells, ends, half_kick, dt)");
}

TEST_CASE("parameter: a missing one is named with its owner and rule", "[unit]") {
    CHECK_THROWS_WITH(resolved({}), "bar.json: /scene: 'cells' of scene bar is missing (a whole number in [1, 512])");
    CHECK_THROWS_WITH(resolve(declared(), {}, "", "scene bar"),
                      "'cells' of scene bar is missing (a whole number in [1, 512])");
}

TEST_CASE("parameter: a range says in words what it accepts", "[unit]") {
    struct Row {
        Range range;
        std::string text;
        double inside, outside;
    };
    const std::vector<Row> rows{{positive, "> 0", 1e-300, 0},
                                {at_least(2), ">= 2", 2, 1.999},
                                {between(0, 0.5), "in [0, 0.5]", 0.5, 0.501},
                                {{.low = 0, .high = 1, .low_excluded = true}, "in (0, 1]", 1, 0},
                                {{.high = 3}, "<= 3", -1e300, 3.001},
                                {ordo::finite, "finite", -1e300, inf}};
    for (const auto& [range, text, inside, outside] : rows) {
        CHECK(range.text() == text);
        CHECK(range.contains(inside));
        CHECK_FALSE(range.contains(outside));
        CHECK_FALSE(range.contains(nan_value));
        CHECK_FALSE(range.contains(inf));
        CHECK_FALSE(range.contains(-inf));
    }
}

TEST_CASE("parameter: a declaration says what holds when nothing is given", "[unit]") {
    const auto list = declared();
    CHECK(find_parameter(list, "E")->default_text() == "100");
    CHECK(find_parameter(list, "ends")->default_text() == "fixed_free");
    CHECK(find_parameter(list, "half_kick")->default_text() == "false");
    CHECK(find_parameter(list, "cells")->default_text() == "required");
    CHECK(find_parameter(list, "dt")->default_text() == "absent");
    CHECK(find_parameter(list, "e") == nullptr);
    CHECK(names_of(list) == std::vector<std::string>{"E", "v0", "cells", "ends", "half_kick", "dt"});
}

TEST_CASE("parameter: asking for an undeclared name or another kind is a programming error", "[unit]") {
    const Values values = resolved({{"cells", 8.0}});
    CHECK_THROWS_AS(values.number("dt"), std::logic_error);
    CHECK_THROWS_AS(values.number("ends"), std::logic_error);
    CHECK_THROWS_AS(values.toggle("E"), std::logic_error);
    CHECK_THROWS_AS(values.word("half_kick"), std::logic_error);
}
