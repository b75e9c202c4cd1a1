// Broken truths: one coefficient of an exact solution is wrong.
#include <cmath>
#include <numbers>

#include "core/elastic_constants.hpp"
#include "oracles/bars/oedometer.hpp"
#include "tests/catch.hpp"
#include "tests/mutations/broken.hpp"
#include "tests/mutations/shipped.hpp"

namespace ordo::tests {
namespace {

using enum studies::Fault;
using oracles::Exact;

/// The oracle's own solution with other numbers filled in: `change` rewrites those that the scene has.
Broken with_numbers(const std::string& scene, const std::function<void(Given&)>& change) {
    const auto truth = studies::scene_named(scene, "").truth;
    return with_truth([=](const Values& values, const Exact&) {
        Given given = values.all();
        change(given);
        return truth(Values(given));
    });
}

/// A number of the solution times `factor`.
Broken scaled(const std::string& scene, const std::string& name, double factor) {
    return with_numbers(scene, [=](Given& given) { given[name] = factor * std::get<double>(given.at(name)); });
}

/// The solution as the given one gives it at other places or times, in all its forms.
Exact moved(const Exact& truth, double stretch, double delay) {
    const auto there = [=](const Exact::Sample& given) {
        return [=](std::span<const double> x, double t, std::span<double> values) {
            std::vector<double> places(x.begin(), x.end());
            for (double& place : places) place /= stretch;
            given(places, t - delay, values);
        };
    };
    Exact other = truth;
    other.sample = there(truth.sample);
    if (truth.averages) other.averages = there(truth.averages);
    return other;
}

/// All waves run 0.1 % faster.
Exact faster(const Values&, const Exact& truth) { return moved(truth, 1.001, 0); }

/// The second coefficient of the column's series is 1 % too large: displacement only.
Exact second_coefficient(const Values& values, const Exact& truth) {
    const oracles::Oedometer column{
        .H = values.number("H"), .E = values.number("E"), .rho = values.number("rho"), .g = values.number("g")};
    const double u_2 =
        16 * column.rho * column.g * column.H * column.H / (27 * std::pow(std::numbers::pi, 3) * column.E);
    const double k_2 = 3 * std::numbers::pi / (2 * column.H);
    Exact other = truth;
    other.sample = [=, place = truth.offset("displacement").value()](std::span<const double> y, double t,
                                                                     std::span<double> rows) {
        truth.sample(y, t, rows);
        for (std::size_t i = 0; i < y.size(); ++i)
            rows[i * truth.width() + place] +=
                0.01 * u_2 * std::cos(k_2 * column.wave_speed() * t) * std::sin(k_2 * y[i]);
    };
    return other;
}

/// x = v t + g t^2: the half is lost.
Exact lost_half(const Values& values, const Exact& truth) {
    Exact other = truth;
    other.sample = [=, g = values.number("g")](std::span<const double> x, double t, std::span<double> rows) {
        truth.sample(x, t, rows);
        const std::size_t along = truth.offset("displacement").value();
        for (std::size_t row = along; row < rows.size(); row += truth.width())
            rows[row + static_cast<std::size_t>(truth.dim) - 1] += 0.5 * g * t * t;
    };
    return other;
}

}  // namespace

MutationClass broken_oracles() {
    return {
        "oracle",
        {
            {"bar: wave speed 1 % too large",
             shipped::mpm_bar,
             scaled("bar_vibration", "E", 1.01 * 1.01),
             {order_too_low, at_floor, stalled, published_differs}},
            {"bar: amplitude 1 % too large",
             shipped::fem_bar,
             scaled("bar_vibration", "v0", 1.01),
             {order_too_low, at_floor, stalled, published_differs}},
            {"column: second coefficient 1 % too large",
             shipped::fem_column,
             with_truth(second_coefficient),
             {order_too_low, at_floor, stalled}},
            {"column: series cut after three terms",
             shipped::fem_column,
             with_numbers("oedometer", [](Given& given) { given["terms"] = 3.0; }),
             {order_too_low, at_floor, stalled, diverges}},
            {"manufactured bar: amplitude 0.1 % too large",
             shipped::mpm_gauss_2,
             scaled("bar_mms", "A", 1.001),
             {order_too_low, at_floor, stalled, published_differs}},
            {"manufactured bar: amplitude 0.01 % too large, third order",
             shipped::mpm_gauss_3,
             scaled("bar_mms", "A", 1.0001),
             {order_too_low, at_floor, stalled, published_differs}},
            {"free flight: g t^2 for g t^2 / 2", shipped::mpm_flight, with_truth(lost_half), {error_too_large}},
            {"gas: exponent gamma 1.41 for 1.4",
             shipped::gas_tube,
             scaled("gas_riemann", "gamma", 1.41 / 1.4),
             {error_too_large}},
            {"gas: waves run 0.1 % faster", shipped::gas_tube, with_truth(faster), {order_too_low, at_floor, stalled}},
            {"gas: pressure on the right 1 % too large",
             shipped::gas_tube,
             scaled("gas_riemann", "p_R", 1.01),
             {error_too_large}},
            {"elastic bar: modulus 1e-6 too large",
             shipped::elastic_wall,
             scaled("elastic_end", "E", 1 + 1e-6),
             {error_too_large}},
            {"root: 1e-9 too large",
             shipped::newton,
             scaled("scalar_root", "root", 1 + 1e-9),
             {order_too_low, at_floor, stalled, order_uncertain}},
        }};
}

TEST_CASE("mutations: broken oracles ring", "[alarm]") { try_all(broken_oracles()); }

}  // namespace ordo::tests
