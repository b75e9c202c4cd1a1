#include "studies/engine/value_check.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "core/text.hpp"
#include "studies/engine/judge.hpp"

namespace ordo::studies {
namespace {

std::string value_claim(const Expectation& expectation) {
    const std::string what = expectation.kind == Expectation::Kind::value ? "value " + shortest(expectation.value)
                                                                          : "agrees with " + expectation.other;
    return what + " +- " + shortest(expectation.within) + range_text(expectation.where);
}

}  // namespace

void check_values(const Result& result, const Expectation& expectation, std::vector<Check>& checks) {
    const bool agrees = expectation.kind == Expectation::Kind::agreement;
    const std::size_t before = checks.size();
    for (const auto& key : expectation.quantities) {
        std::map<std::string, Check> of_solver;
        std::map<std::string, double> worst;
        for (const Run& run : result.runs) {
            if (!speaks_of(expectation, key, run.solver) || !admits(expectation, run)) continue;
            auto& check = of_solver
                              .try_emplace(run.solver, Check{value_claim(expectation), run.solver + ": " + key,
                                                             expectation.source, Verdict::pass, ""})
                              .first->second;
            const double wanted = agrees ? run.error(expectation.other) : expectation.value;
            const double off = std::abs(run.error(key) - wanted);
            if (!(off <= expectation.within)) {
                check.verdict = Verdict::fail;
                check.fault = std::isnan(off) ? Fault::error_is_nan : Fault::value_off;
            }
            double& largest = worst[run.solver];
            if (!(off <= largest)) largest = off;
        }
        for (auto& [solver, check] : of_solver) {
            check.found = fmt::format("off by {:.3g} at most", worst[solver]);
            checks.push_back(std::move(check));
        }
    }
    if (checks.size() == before)
        checks.push_back(
            {value_claim(expectation), "all runs", expectation.source, Verdict::fail, "no run", Fault::no_such_series});
}

}  // namespace ordo::studies
