// Orders that theory expects, and errors in parts, in a study file.
#include "core/error.hpp"
#include "tests/catch.hpp"
#include "tests/studies/sample_study.hpp"

using namespace ordo;
using namespace ordo::studies;
using ordo::tests::sample_document;
using ordo::tests::study_of;

namespace {

/// Sod's tube by Godunov's method of both orders, held to the expected order.
Json expected_tube(const std::string& field) {
    auto document = Json::parse(R"json({
        "study": "tube", "scene": { "name": "gas_riemann" },
        "solvers": [ { "name": "godunov", "order": ["first", "second"] } ],
        "sweep": { "cells": [50, 100, 200], "path": "space" },
        "measure": { "at": 1, "fields": ["density"], "norms": ["l1", "l2"] },
        "expect": [ { "order": "expected", "within": 0.1, "may_exceed": "ours", "levels": 3, "source": "theory" } ]
    })json");
    document["measure"]["fields"] = field;
    return document;
}

}  // namespace

TEST_CASE("an expected order stands for one of each quantity and solver, and says what it follows from", "[unit]") {
    const auto study = study_of(expected_tube("density"));
    REQUIRE(study.expect.size() == 4);  // two solvers, two norms
    const auto& first = study.expect.at(0);
    CHECK(first.solvers == std::vector<std::string>{"godunov first"});
    CHECK(first.quantities == std::vector<std::string>{"density.l1"});
    CHECK(text_of_order(first) == "expected order 0.5 +- 0.1 (contact, l1, formal order 1)");
    CHECK(text_of_order(study.expect.at(2)) == "expected order 0.667 +- 0.1 (contact, l1, formal order 2)");
    CHECK(text_of_order(study.expect.at(3)) == "expected order 0.333 +- 0.1 (contact, l2, formal order 2)");
    CHECK(study_of(expected_tube("pressure")).expect.at(2).value == 1);
    CHECK(study.expect.at(2).may_exceed == "ours");
    CHECK(study.expect.at(2).levels == 3);
    const auto numbered = study_of(sample_document()).expect.at(0);
    CHECK(text_of_order(numbered) == "order 2 +- 0.1");
    CHECK((numbered.may_exceed.empty() && numbered.levels == 0));
}

TEST_CASE("an expected order knows the observed part of the line, and the time step", "[unit]") {
    // Contact and shock have left the line, which ends at 5; the corner of a fan is 4/3 in l1.
    auto document = expected_tube("density");
    document["scene"]["x0"] = 4.5;
    CHECK(study_of(document).expect.at(2).value == Approx(4.0 / 3));
    auto bar = sample_document();
    bar["expect"][0]["order"] = "expected";
    CHECK(study_of(bar).expect.at(0).theory == "smooth, rms, formal order 2");
    bar["solvers"][0]["stress_update"] = "usf";
    bar["sweep"] = Json::parse(R"({"cells": [4, 8], "courant": 0.2, "path": "joint"})");
    CHECK(study_of(bar).expect.at(0).value == 1);  // symplectic Euler along dt = 0.2 h / c
}

TEST_CASE("an order that theory does not have is refused with the reason", "[alarm]") {
    const auto refused = [](const Json& document) -> std::string {
        try {
            study_of(document);
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    };
    auto tube = expected_tube("density");
    tube["measure"]["norms"] = "contact";
    CHECK_THAT(refused(tube), ContainsSubstring("/expect/0/order: for godunov first: density.contact, theory expects "
                                                "no order: it has no rule for the place of a contact"));
    tube["measure"]["norms"] = "linf";
    CHECK_THAT(refused(tube), ContainsSubstring("in linf the"));
    tube = expected_tube("density");
    tube["measure"]["orders_against"] = Json::parse(R"(["h", "1/cell_updates"])");
    CHECK(refused(tube).empty());
    tube["expect"][0]["against"] = "1/cell_updates";
    CHECK_THAT(refused(tube), ContainsSubstring("theory expects orders against h only"));
    auto vacuum = expected_tube("density");
    vacuum["scene"] = Json::parse(R"({"name": "gas_riemann", "v_L": -6, "v_R": 6})");
    vacuum["measure"]["at"] = 0.5;
    CHECK_THAT(refused(vacuum), ContainsSubstring("no rule for the singular place"));
    auto bar = sample_document();
    bar["expect"][0]["order"] = "expected";
    bar["measure"]["fields"] = "stress";
    CHECK_THAT(refused(bar), ContainsSubstring("the solver claims one of displacement, velocity only"));
    bar["measure"] = Json::parse(R"({"at": 20, "until": "steps", "fields": "displacement"})");
    CHECK_THAT(refused(bar), ContainsSubstring("needs 'until' to be 'exact' or 'accumulated'"));
    bar["measure"] = Json::parse(R"({"at": 0.2, "fields": "displacement", "against": "finest"})");
    bar["sweep"] = Json::parse(R"({"cells": 8, "dt": [0.01, 0.005], "path": "time"})");
    CHECK_THAT(refused(bar), ContainsSubstring("theory expects orders against h only"));
}

TEST_CASE("parts of l1 are refused where nothing is to be parted", "[alarm]") {
    auto tube = expected_tube("density");
    tube["expect"] = Json::array();
    tube["measure"]["norms"] = Json::parse(R"(["l1", "l1_near", "l1_away"])");
    CHECK_THROWS_WITH(study_of(tube), ContainsSubstring("the member 'near' is missing"));
    tube["measure"]["near"] = 0;
    CHECK_THROWS_WITH(study_of(tube), ContainsSubstring("/measure/near: is 0, but must be > 0"));
    tube["measure"]["near"] = 0.2;
    CHECK(study_of(tube).measure.quantities.at(1).near == 0.2);
    CHECK(study_of(tube).measure.quantities.at(0).near == 0);
    tube["measure"]["over"] = "maximum";
    CHECK_THROWS_WITH(study_of(tube), ContainsSubstring("'l1_near' needs 'over' to be 'final'"));
    auto bar = sample_document();
    bar["measure"] = Json::parse(R"({"at": 0.2, "fields": "displacement", "norms": "l1_away", "near": 0.1})");
    bar["expect"] = Json::array();
    CHECK_THROWS_WITH(study_of(bar), ContainsSubstring("the exact solution is smooth everywhere at t = 0.2"));
}
