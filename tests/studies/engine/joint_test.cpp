// Joint fits of h and dt over the runs of a study, made by hand.
#include "studies/engine/joint.hpp"

#include "studies/engine/judge.hpp"
#include "tests/catch.hpp"
#include "tests/studies/planned_runs.hpp"
#include "tests/studies/sample_study.hpp"

using namespace ordo;
using namespace ordo::studies;
using ordo::tests::planned_runs;
using ordo::tests::study_of;

namespace {

Study grid_study() {
    auto document = tests::sample_document();
    document["sweep"] = {{"cells", {4, 8, 16}}, {"ppc", {1, 2}}, {"dt", {0.04, 0.02, 0.01}}, {"path", "grid"}};
    document.erase("expect");
    return study_of(document);
}

std::vector<Run> grid_runs(const Study& study) {
    auto runs = planned_runs(study, tests::second_order);
    for (auto& run : runs) run.errors[0].value = 4e-3 * run.h * run.h + run.axis("ppc") * run.dt;
    return runs;
}

}  // namespace

TEST_CASE("a grid has one joint fit for each quantity and setting", "[unit]") {
    const Study study = grid_study();
    const auto runs = grid_runs(study);
    const auto joint = joint_fits_of(study, runs);
    REQUIRE(joint.size() == 2);
    CHECK(joint[0].grid == "ppc = 1");
    CHECK(joint[1].grid == "ppc = 2");
    for (const auto& result : joint) {
        CHECK(result.quantity == "displacement.rms");
        CHECK(result.used.size() == 9);
        CHECK(result.fit.p.value == Approx(2).epsilon(1e-5));
        CHECK(result.fit.q.value == Approx(1).epsilon(1e-5));
    }
    CHECK(joint[1].fit.B.value == Approx(2).epsilon(1e-4));
    CHECK(joint_fits_of(study_of(tests::sample_document()), runs).empty());  // another path
}

TEST_CASE("a joint fit leaves out runs that stopped, by name, and refuses a NaN", "[alarm]") {
    const Study study = grid_study();
    auto runs = grid_runs(study);
    runs[0].status = Status::diverged;
    runs[0].reason = "left";
    auto joint = joint_fits_of(study, runs);
    REQUIRE(joint[0].left_out.size() == 1);
    CHECK(joint[0].left_out[0].why == "diverged: left");
    CHECK(joint[0].fit.verdict == Convergence::converges);
    runs[1].errors.clear();
    joint = joint_fits_of(study, runs);
    CHECK(joint[0].fit.verdict == Convergence::invalid);
    CHECK_THAT(joint[0].fit.reason, ContainsSubstring("nan"));
    CHECK(joint[1].fit.verdict == Convergence::converges);
}
