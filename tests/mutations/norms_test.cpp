// Broken norms: what is measured of a right solution is wrong.
#include <algorithm>
#include <cmath>
#include <limits>

#include "studies/engine/measure.hpp"
#include "tests/catch.hpp"
#include "tests/mutations/broken.hpp"
#include "tests/mutations/shipped.hpp"

namespace ordo::tests {
namespace {

using enum studies::Fault;
using solvers::Plan;
using solvers::Snapshot;

/// sum over the points of f(weight, length of the error).
template <class F>
double sum(const Compared& both, F f) {
    double total = 0;
    for (std::size_t i = 0; i < both.weights.size(); ++i) total += f(both.weights[i], both.error(i));
    return total;
}

double weight_in_power(const Compared& both) {
    return std::sqrt(sum(both, [](double w, double e) { return w * w * e * e; }));
}
double without_root(const Compared& both) {
    return sum(both, [](double w, double e) { return w * e * e; });
}
double without_mean(const Compared& both) {
    return std::sqrt(sum(both, [](double, double e) { return e * e; }));
}
double relative(const Compared& both) {
    double largest = 1e-300;
    for (const double value : both.exact) largest = std::max(largest, std::abs(value));
    return std::sqrt(sum(both, [](double w, double e) { return w * e * e; })) / largest;
}
double of_the_mean(const Compared& both) {
    double mean = 0;
    for (std::size_t k = 0; k < both.found.size(); ++k) mean += both.found[k] - both.exact[k];
    return std::abs(mean) / static_cast<double>(both.found.size());
}
double of_the_first_point(const Compared& both) { return both.error(0); }

double without_nan(const Compared& both) {
    const double square = sum(both, [](double, double e) { return std::isnan(e) ? 0 : e * e; });
    return std::sqrt(square / static_cast<double>(both.weights.size()));
}

/// A norm that takes no notice of a NaN, and a solution that has one.
Broken dropped_nan() {
    Broken broken = behind("mpm", {.clock = {}, .shown = [](Snapshot& shot, const Plan&) {
                                       shot.fields[0].values[shot.points() / 2] = std::nan("");
                                   }});
    broken.parts->errors = with_norm(without_nan).parts->errors;
    return broken;
}

/// The exact solution's columns stand under each other's names.
std::vector<studies::RunFigure> swapped_columns(const std::vector<studies::Quantity>& quantities, const Snapshot& shot,
                                                const oracles::Exact& exact) {
    oracles::Exact swapped = exact;
    std::swap(swapped.fields[0].name, swapped.fields[1].name);
    return studies::errors_against_exact(quantities, shot, swapped);
}

/// x for y.
std::vector<studies::RunFigure> swapped_components(const std::vector<studies::Quantity>& quantities,
                                                   const Snapshot& shot, const oracles::Exact& exact) {
    Snapshot turned = shot;
    for (auto& field : turned.fields) {
        for (std::size_t k = 0; k + 1 < field.values.size(); k += 2) std::swap(field.values[k], field.values[k + 1]);
    }
    return studies::errors_against_exact(quantities, turned, exact);
}

/// Integrals over cells are sums over them.
std::vector<studies::RunFigure> without_widths(const std::vector<studies::Quantity>& quantities, const Snapshot& shot,
                                               const oracles::Exact& exact) {
    auto errors = studies::errors_against_exact(quantities, shot, exact);
    for (std::size_t k = 0; k < errors.size(); ++k) {
        const bool integral = quantities[k].norm == studies::Norm::l1 || quantities[k].norm == studies::Norm::l1_fans;
        if (integral) errors[k].value *= static_cast<double>(shot.points()) / (shot.edges.back() - shot.edges.front());
    }
    return errors;
}

}  // namespace

MutationClass broken_norms() {
    return {
        "norm",
        {
            {"the weight stands inside the power", shipped::mpm_gauss_2, with_norm(weight_in_power), {order_too_high}},
            {"the root is forgotten", shipped::mpm_gauss_2, with_norm(without_root), {order_too_high}},
            {"the root is forgotten, third order", shipped::mpm_gauss_3, with_norm(without_root), {order_too_high}},
            {"the sum is not divided by the number of points",
             shipped::mpm_bar,
             with_norm(without_mean),
             {order_too_low}},
            {"the sum over cells is without their widths",
             shipped::gas_tube,
             with_errors(without_widths),
             {error_too_large}},
            {"relative to the largest exact value", shipped::mpm_gauss_2, with_norm(relative), {published_differs}},
            {"errors of both signs cancel", shipped::mpm_gauss_3, with_norm(of_the_mean), {order_too_high}},
            {"the first point stands for all", shipped::mpm_bar, with_norm(of_the_first_point), {order_too_high}},
            {"a NaN is dropped", shipped::mpm_bar, dropped_nan(), {run_diverged}},
            {"displacement is compared with the exact velocity",
             shipped::mpm_flight,
             with_errors(swapped_columns),
             {error_too_large}},
            {"x is compared with y", shipped::mpm_flight, with_errors(swapped_components), {error_too_large}},
        }};
}

TEST_CASE("mutations: broken norms ring", "[alarm]") { try_all(broken_norms()); }

}  // namespace ordo::tests
