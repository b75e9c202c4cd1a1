// Quantities that are measured against themselves.
#include "studies/engine/extrapolated.hpp"

#include <algorithm>
#include <cmath>

#include "studies/engine/engine.hpp"
#include "studies/engine/judge.hpp"
#include "tests/catch.hpp"
#include "tests/studies/planned_runs.hpp"
#include "tests/studies/sample_study.hpp"

using namespace ordo;
using namespace ordo::studies;
using ordo::tests::planned_runs;
using ordo::tests::study_of;
using ordo::tests::with;

namespace {

Study self_study() {
    auto document = with("/measure/against", "\"itself\"");
    document["sweep"]["cells"] = {4, 8, 16, 32};
    return study_of(document);
}

std::vector<Run> self_runs(const Study& study, double order) {
    auto runs = planned_runs(study, [](double) { return 0.0; });
    for (auto& run : runs) run.errors = {{"displacement.rms@itself", 3 - 0.01 * std::pow(run.h, order)}};
    return runs;
}

}  // namespace

TEST_CASE("a norm against itself is extrapolated, and has an order", "[unit]") {
    const Study study = self_study();
    const Result result = judged(study, self_runs(study, 2));
    REQUIRE(result.fits.size() == 1);
    REQUIRE(result.fits[0].outcome.fit);
    CHECK(result.fits[0].outcome.fit->order == Approx(2).epsilon(1e-5));
    const auto found = extrapolations_of(result);
    REQUIRE(found.size() == 1);
    CHECK(found[0].used.size() == 4);
    CHECK(found[0].methods.at(0).limit == Approx(3).epsilon(1e-9));
    CHECK(judged(study, self_runs(study, 1)).verdict == Verdict::fail);  // order 2 is expected
    CHECK(extrapolations_of(judged(study_of(tests::sample_document()), {})).empty());
}

TEST_CASE("a norm against itself needs no exact solution: it is the norm of the field", "[unit]") {
    auto document = with("/measure/against", R"(["exact", "itself"])");
    document["expect"][0]["of"] = "displacement.rms";
    const auto runs = run_all(study_of(document), {});
    for (const auto& run : runs) {
        const double norm = run.error("displacement.rms@itself");
        // v0 sin(pi x / 2 L) at t = 0.2 s displaces about v0 t / sqrt(2) = 0.014 m, and errors are far smaller.
        CHECK(norm == Approx(0.1 * 0.2 / std::sqrt(2)).epsilon(0.1));
        CHECK(run.error("displacement.rms") < 0.1 * norm);
    }
}

TEST_CASE("a bound on what is no error is refused", "[alarm]") {
    auto document = with("/measure/against", R"(["exact", "itself"])");
    document["expect"] = {{{"error_at_most", 1}, {"source", "made by hand"}}};
    CHECK_THROWS_WITH(study_of(document), ContainsSubstring("/expect/0: bounds 'displacement.rms@itself'"));
    document["expect"][0]["of"] = "displacement.rms";
    CHECK_NOTHROW(study_of(document));
}
