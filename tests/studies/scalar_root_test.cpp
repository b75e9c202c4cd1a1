// Root finding as a study: iterates against the exact errors, and the orders that the shipped studies observe.
#include <cmath>

#include "oracles/scalar_root_convergence.hpp"
#include "solvers/root_finding/root_finding.hpp"
#include "studies/engine/engine.hpp"
#include "studies/engine/judge.hpp"
#include "studies/reader/study_reader.hpp"
#include "tests/catch.hpp"

using namespace ordo;
using Exact = oracles::ScalarRootConvergence;

namespace {

std::string shipped(const std::string& name) {
    return std::string(ORDO_SOURCE_DIR) + "/studies/scalar_roots/" + name + ".json";
}

}  // namespace

TEST_CASE("scalar roots: iterates have the errors that the recursions say, to round-off", "[gate]") {
    using solvers::root_finding::Method;
    const solvers::ScalarEquation parabola{.f = [](double x) { return (x - 1.5) * (x - 2.3); },
                                           .slope = [](double x) { return (x - 1.5) + (x - 2.3); },
                                           .start = 0,
                                           .second_start = 0.5};
    const std::vector<std::pair<Method, Exact::Method>> methods{
        {Method::newton, Exact::Method::newton},
        {Method::modified_newton, Exact::Method::modified_newton},
        {Method::secant, Exact::Method::secant}};
    for (const auto& [method, exact_method] : methods) {
        const auto x = solvers::root_finding::iterates(parabola, method, 9);
        const auto e = Exact{.method = exact_method}.errors(9);
        REQUIRE(x.size() == e.size());
        // Each step rounds x, f and the quotient: a few ulp of 2.3, damped by the next step.
        for (std::size_t i = 0; i < x.size(); ++i) CHECK(std::abs(x[i] - 1.5 - e[i]) < 4e-15);
    }
}

TEST_CASE("scalar roots: the shipped studies observe 2, 1 and the golden ratio", "[convergence]") {
    for (const char* name : {"newton", "modified_newton", "secant"}) {
        const auto study = studies::read_study(shipped(name));
        const auto result = studies::judged(study, studies::run_all(study, {}));
        INFO(name);
        CHECK(result.verdict == studies::Verdict::pass);
    }
}
