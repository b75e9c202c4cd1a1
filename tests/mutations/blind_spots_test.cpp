// Plausible faults that the expectations of the studies as shipped do not see, so that nobody believes more than is
// proven; a baseline sees them. A fault that begins to ring, because a study was tightened, makes this test fail and
// moves to its class.
#include <algorithm>
#include <cmath>

#include "reports/gate/compare.hpp"
#include "tests/catch.hpp"
#include "tests/mutations/broken.hpp"
#include "tests/mutations/shipped.hpp"

namespace ordo::tests {
namespace {

using solvers::LineScene;
using solvers::Plan;
using studies::Fault;

double twice_the_rms(const Compared& both) {
    double sum = 0;
    for (std::size_t i = 0; i < both.weights.size(); ++i) sum += both.error(i) * both.error(i);
    return 2 * std::sqrt(sum / static_cast<double>(both.weights.size()));
}

/// The fault as `ordo check --against` sees it, where the unbroken answer was accepted.
std::vector<Fault> seen_by_baseline(const Shipped& study, const Broken& fault) {
    const reports::Report whole{unbroken(study), {}};
    const auto baseline = reports::baseline_of({whole}, {study.name}, "unbroken");
    std::vector<Fault> faults;
    for (const auto& check : reports::checks_against({broken(study, fault), {}}, baseline)) {
        if (check.verdict != studies::Verdict::pass) faults.push_back(check.fault);
    }
    return faults;
}

}  // namespace

std::vector<BlindSpot> blind_spots() {
    return {
        {"godunov: one wave for contact and fan, hll", shipped::gas_contact,
         with_choices("godunov", [](Given& options, Given&) { options["flux"] = std::string("hll"); }),
         "has the order of hllc"},
        {"godunov: the wall stands half a cell off", shipped::gas_wall,
         on_problem<LineScene>("godunov",
                               [](LineScene& line, const Plan& plan) { line.edges.front() += 0.5 * plan.h; }),
         "an error of O(h) beside shocks that are of first order themselves"},
        {"godunov: the last step is not cut", shipped::gas_tube,
         behind("godunov", {.clock = [](double t, const Plan& plan) { return t + 0.2 * plan.h; }, .shown = {}}),
         "an error of O(h) beside shocks that are of first order themselves"},
        {"a norm is twice too large", shipped::fem_column, with_norm(twice_the_rms), "an order does not see a factor"},
        {"mpm: body force a step late, six bases", shipped::mpm_bases,
         on_problem<solvers::SolidScene<1>>("mpm",
                                            [](auto& bar, const Plan& plan) {
                                                *bar.body_force = [force = *bar.body_force, dt = plan.dt](
                                                                      auto X, double t, auto out) {
                                                    force(X, t + dt, out);
                                                };
                                            }),
         "at this amplitude the force is a correction below the error"},
    };
}

TEST_CASE("mutations: what expectations do not see, the baseline does", "[alarm]") {
    for (const auto& [what, study, fault, why] : blind_spots()) {
        const auto result = broken(study, fault);
        INFO(what << ", " << study.name << "\n" << what_rings(result));
        CHECK(result.verdict == studies::Verdict::pass);
        const auto seen = seen_by_baseline(study, fault);
        CHECK(std::ranges::count(seen, Fault::error_changed) > 0);
    }
}

}  // namespace ordo::tests
