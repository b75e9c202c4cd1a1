// Plausible faults that the studies as shipped do not see, so that nobody believes more than is proven. A fault that
// begins to ring, because a study was tightened, makes this test fail and moves to its class.
#include <cmath>

#include "tests/catch.hpp"
#include "tests/mutations/broken.hpp"
#include "tests/mutations/shipped.hpp"

namespace ordo::tests {
namespace {

using solvers::LineScene;
using solvers::Plan;
using studies::Run;
using studies::RunSpec;

double twice_the_rms(const Compared& both) {
    double sum = 0;
    for (std::size_t i = 0; i < both.weights.size(); ++i) sum += both.error(i) * both.error(i);
    return 2 * std::sqrt(sum / static_cast<double>(both.weights.size()));
}

void ends_early(std::vector<RunSpec>& specs) { specs.back().t_end *= 0.9; }

void nan_in_an_unjudged_run(std::vector<Run>& runs) {
    for (auto& run : runs) {
        if (run.solver != "rrm nothing") continue;
        for (auto& error : run.errors) error.value = std::nan("");
    }
}

}  // namespace

std::vector<BlindSpot> blind_spots() {
    return {
        {"godunov: one wave for contact and fan, hll", shipped::gas_contact,
         with_choices("godunov", [](Given& options, Given&) { options["flux"] = std::string("hll"); }),
         "has the order of hllc; an `error_at_most` on the finest grid would see it"},
        {"godunov: the wall stands half a cell off", shipped::gas_wall,
         on_problem<LineScene>("godunov",
                               [](LineScene& line, const Plan& plan) { line.edges.front() += 0.5 * plan.h; }),
         "an error of O(h) beside shocks that are of first order themselves; an `error_at_most` would see it"},
        {"godunov: the last step is not cut", shipped::gas_tube,
         behind("godunov", {.clock = [](double t, const Plan& plan) { return t + 0.2 * plan.h; }, .shown = {}}),
         "an error of O(h) beside shocks that are of first order themselves; an `error_at_most` would see it"},
        {"a norm is twice too large", shipped::fem_column, with_norm(twice_the_rms),
         "an order does not see a factor; an `error_at_most` would"},
        {"mpm: body force a step late, six bases", shipped::mpm_bases,
         on_problem<solvers::SolidScene<1>>("mpm",
                                            [](auto& bar, const Plan& plan) {
                                                *bar.body_force = [force = *bar.body_force, dt = plan.dt](
                                                                      auto X, double t, auto out) {
                                                    force(X, t + dt, out);
                                                };
                                            }),
         "at this amplitude the force is a correction below the error"},
        {"one run is compared at an earlier time", shipped::fem_column, with_plan(ends_early),
         "the time of a run is not compared with the study's"},
        {"NaN in runs that no expectation speaks of", shipped::elastic_wall, with_runs(nan_in_an_unjudged_run),
         "only what is expected is judged"},
    };
}

TEST_CASE("mutations: what is listed as unseen is unseen", "[alarm]") {
    for (const auto& [what, study, fault, why] : blind_spots()) {
        const auto result = broken(study, fault);
        INFO(what << ", " << study.name << "\n" << what_rings(result));
        CHECK(result.verdict == studies::Verdict::pass);
    }
}

}  // namespace ordo::tests
