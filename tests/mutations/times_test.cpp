// Broken times: solution and truth are compared at different times.
#include <algorithm>

#include "tests/catch.hpp"
#include "tests/mutations/broken.hpp"
#include "tests/mutations/shipped.hpp"

namespace ordo::tests {
namespace {

using enum studies::Fault;
using solvers::Plan;
using solvers::Snapshot;

/// The error is taken against the truth `share` steps later.
Broken truth_later(const std::string& solver, double share) {
    return behind(solver,
                  {.clock = {}, .shown = [share](Snapshot& shot, const Plan& plan) { shot.t += share * plan.dt; }});
}

/// The solver goes `share` steps too far, and says that it has not.
Broken solver_later(const std::string& solver, double share) {
    return behind(solver, {.clock = [share](double t, const Plan& plan) { return t + share * plan.dt; }, .shown = {}});
}

/// The solver goes to another time, and says that it has not.
Broken goes_to(const std::string& solver, double factor) {
    return behind(solver, {.clock = [factor](double t, const Plan&) { return factor * t; }, .shown = {}});
}

}  // namespace

MutationClass broken_times() {
    return {
        "time",
        {
            {"mpm: error at t + dt, fixed dt",
             shipped::mpm_bar,
             truth_later("mpm", 1),
             {order_too_low, at_floor, published_differs}},
            {"mpm: error at t + dt, dt refined with h", shipped::mpm_gauss_3, truth_later("mpm", 1), {order_too_low}},
            {"mpm: error at t + dt/2, dt refined with h",
             shipped::mpm_gauss_2,
             truth_later("mpm", 0.5),
             {order_too_low}},
            {"mpm: one step too many", shipped::mpm_manufactured, solver_later("mpm", 1), {order_too_low}},
            {"mpm: one step too few, in the steps themselves",
             shipped::mpm_flight,
             solver_later("mpm", -1),
             {error_too_large}},
            {"fem: error at t + dt",
             shipped::fem_bar,
             truth_later("fem", 1),
             {order_too_low, at_floor, stalled, published_differs}},
            {"fem: one step too few",
             shipped::fem_column,
             solver_later("fem", -1),
             {order_too_low, at_floor, stalled, pre_asymptotic}},
            {"godunov: 1 % too far",
             shipped::gas_tube,
             goes_to("godunov", 1.01),
             {order_too_low, at_floor, stalled, order_uncertain}},
            {"rrm: the last 0.1 % of the events are missing",
             shipped::gas_tube,
             goes_to("rrm", 0.999),
             {error_too_large}},
            {"rrm: the last 1e-6 of the time is missing, exact solution",
             shipped::elastic_wall,
             goes_to("rrm", 1 - 1e-6),
             {error_too_large}},
        }};
}

TEST_CASE("mutations: broken times ring", "[alarm]") { try_all(broken_times()); }

}  // namespace ordo::tests
