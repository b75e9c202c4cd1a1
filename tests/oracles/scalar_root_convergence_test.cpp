#include "oracles/scalar_root_convergence.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "tests/catch.hpp"
#include "tests/oracles/fuzz.hpp"
#include "tests/oracles/scalar_root_convergence_gate.hpp"

using namespace ordo;
using namespace ordo::oracles;
using namespace ordo::oracles::gate;
using namespace ordo::oracles::gate::root_iteration;

namespace {

const std::array words{"newton", "modified_newton", "secant"};

std::vector<Problem> problems() {
    std::vector<Problem> list;
    for (const auto method : {Method::newton, Method::modified_newton, Method::secant}) {
        list.push_back({.method = method});
        list.push_back({method, 2.3, 1.5, 4.0, 3.1});
        list.push_back({method, -3e5, 0.1, -7e5, -6e5});
        list.push_back({method, 1e-3, -1, 0.9, 0.2});
        list.push_back({method, 1, 2, 0.999, 0.99});
        if (method != Method::secant) list.push_back({method, 1.5, 2.3, 1.59, 0});
    }
    return list;
}

Exact bound(const Given& given) {
    static const Oracle oracle = scalar_root_convergence();
    return oracle.bind(resolve(oracle.parameters, given, "", oracle.name));
}

std::array<double, 3> row_of(const Exact& exact, double i) {
    std::array<double, 3> row{};
    exact.sample({&i, 1}, 0, row);
    return row;
}

}  // namespace

TEST_CASE("scalar_root_convergence: errors on (x - 1.5)(x - 2.3) from 0, six digits", "[published]") {
    const std::vector<std::vector<double>> printed{
        {1.5, 0.592105, 0.176689, 2.70675e-2, 8.57769e-4, 9.17741e-7, 1.05281e-12, 1.38551e-24},
        {1.5, 0.592105, 0.375191, 0.259159, 0.186925, 0.138377, 0.104206, 7.94104e-2, 6.10330e-2, 4.72037e-2},
        {1.5, 1.0, 0.454545, 0.201613, 6.29342e-2, 1.19190e-2, 8.57417e-4, 1.25737e-5, 1.34615e-8, 2.11571e-13}};
    for (std::size_t m = 0; m < 3; ++m) {
        const Exact exact = bound({{"method", words[m]}});
        for (std::size_t i = 0; i < printed[m].size(); ++i) {
            const double unit = std::pow(10, std::floor(std::log10(printed[m][i])) - 5);
            INFO(words[m] << ", i = " << i);
            CHECK(row_of(exact, double(i))[1] == Approx(printed[m][i]).epsilon(0).margin(0.5001 * unit));
        }
    }
    // Orders that the secant method shows near the end, and the limits of the ratios.
    const Exact secant = bound({{"method", "secant"}});
    CHECK(row_of(secant, 7)[2] == Approx(1.604).margin(5e-4));
    CHECK(row_of(secant, 8)[2] == Approx(1.620).margin(5e-4));
    CHECK(Problem{}.asymptotic_constant() == Approx(1.25));
    CHECK(Problem{.method = Method::modified_newton}.asymptotic_constant() == Approx(0.78947).margin(5e-6));
    CHECK(Problem{.method = Method::secant}.order() == Approx((1 + std::sqrt(5.0)) / 2));
}

TEST_CASE("scalar_root_convergence: errors are those of 50-digit iterations and of the closed powers", "[gate]") {
    for (const auto& problem : problems()) {
        for (const auto& gate : {iteration, powers}) {
            const Defect defect = gate(sequence(problem));
            INFO(words[static_cast<std::size_t>(problem.method)] << ", root " << problem.root << ", start "
                                                                 << problem.start << ": defect " << defect.found
                                                                 << ", allowed " << defect.allowed);
            CHECK(defect.holds());
        }
    }
}

// |e_{i+1}| / |e_i|^order reaches its limit, with a relative difference of the size of what was dropped: e / d for
// Newton's method and the secant method's exponent phi^-i; the linear one at the rate of its own errors.
TEST_CASE("scalar_root_convergence: orders and ratios tend to the stated ones", "[gate]") {
    for (const auto& problem : problems()) {
        const auto e = problem.errors(problem.method == Method::modified_newton ? 900 : 9);
        std::size_t last = e.size() - 1;
        while (std::abs(e[last]) < 1e-280) --last;  // still a normal number
        const double seen = std::abs(e[last]) / std::pow(std::abs(e[last - 1]), problem.order());
        INFO(words[static_cast<std::size_t>(problem.method)] << ", root " << problem.root << ", last " << last);
        if (problem.method == Method::secant) {
            CHECK(observed_order(e, last) == Approx(problem.order()).margin(0.05));
            // ln of the ratio still swings by ln(constant) phi^-i.
            CHECK(std::abs(std::log(seen / problem.asymptotic_constant())) <
                  15 * std::pow(problem.order(), -double(last)) *
                      (1 + std::abs(std::log(problem.asymptotic_constant()))));
        } else {
            CHECK(observed_order(e, last) == Approx(problem.order()).margin(0.01));
            CHECK(seen ==
                  Approx(problem.asymptotic_constant()).epsilon(1e-9 + 2 * std::abs(e[last - 1] / problem.gap())));
        }
    }
}

TEST_CASE("scalar_root_convergence: fields, constants and what x may be", "[unit]") {
    const Exact exact = bound({{"method", "secant"}, {"iterations", 12.0}});
    const Problem problem{.method = Method::secant};
    const auto errors = problem.errors(12);
    for (std::size_t i = 0; i <= 12; ++i) {
        const auto [x, error, order] = row_of(exact, double(i));
        CHECK((x == 1.5 + errors[i] && error == std::abs(errors[i]) && std::isnan(order) == (i < 2)));
    }
    CHECK_THROWS_AS(row_of(exact, 2.5), InputError);
    CHECK_THROWS_AS(row_of(exact, 13), InputError);
    CHECK((exact.lower == std::vector{0.0} && exact.upper == std::vector{12.0} && exact.jumps(0).empty()));
    const auto constants = exact.constants({});
    REQUIRE(constants.size() == 4);
    const auto& iterates = std::get<std::vector<Constants>>(constants[3].value);
    REQUIRE(iterates.size() == 13);
    CHECK((iterates[9][1].name == "x" && std::get<double>(iterates[9][2].value) == std::abs(errors[9])));
    // Once below the doubles the error is 0, and the order has no value.
    const Exact newton = bound({{"iterations", 40.0}});
    CHECK((row_of(newton, 40)[1] == 0 && std::isnan(row_of(newton, 40)[2]) && row_of(newton, 40)[0] == 1.5));
}

TEST_CASE("scalar_root_convergence: refuses starts that do not lead to the root, and says where to start", "[unit]") {
    const auto refusal = [](const Given& given) -> std::string {
        try {
            bound(given);
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    };
    CHECK_THAT(refusal({{"root", 2.3}}), ContainsSubstring("double root"));
    CHECK_THAT(refusal({{"start", 2.0}}), ContainsSubstring("1.9"));
    CHECK_THAT(refusal({{"start", 1.9}}), ContainsSubstring("not nearer"));
    CHECK_THAT(refusal({{"method", "modified_newton"}, {"start", 1.75}}), ContainsSubstring("1.7"));
    CHECK_THAT(refusal({{"method", "secant"}, {"start", 2.4}, {"second_start", 2.2}}), ContainsSubstring("secant"));
    CHECK_THAT(refusal({{"method", "secant"}, {"second_start", 0.0}}), ContainsSubstring("secant"));
    CHECK_THAT(refusal({{"method", "bisection"}}), ContainsSubstring("bisection"));
    // r_0 = 2, r_1 = 1/2: the third iterate is at infinity although the pair would converge.
    CHECK_THAT(
        refusal({{"root", 0.0}, {"other_root", 3.0}, {"start", 6.0}, {"second_start", -3.0}, {"method", "secant"}}),
        ContainsSubstring("level"));
    CHECK(refusal({{"start", 1.5}}).empty());
}

// The iterates, as printed, obey the method's definition to round-off: the line through (x_i, f) with its slope is zero
// at x_{i+1}. A refusal counts when the plain iteration does not find the root.
TEST_CASE("scalar_root_convergence: random problems obey the definition of the method", "[property]") {
    Random random(23);
    Tally tally;
    for (int round = 0; round < fuzz_rounds(3000); ++round) {
        const auto method = static_cast<std::size_t>(random.whole(0, 2));
        const double a = random.uniform(-1, 1) * random.log_uniform(1e-3, 1e3);
        const double b = a + random.log_uniform(1e-3, 1e3) * (random.coin() ? 1 : -1);
        const double near = random.whole(0, 3) > 0 ? 0.24 : 3;  // most start near the root
        const double start = a + (b - a) * random.uniform(-near, near);
        const double second = a + (b - a) * random.uniform(-near, near);
        const auto f = [&](double x) { return (x - a) * (x - b); };
        const auto slope = [&](double x, double before) {
            return method == 0 ? (x - a) + (x - b) : method == 1 ? (start - a) + (start - b) : (x - a) + (before - b);
        };
        Exact exact;
        try {
            exact = bound({{"method", words[method]},
                           {"root", a},
                           {"other_root", b},
                           {"start", start},
                           {"second_start", second},
                           {"iterations", 12.0}});
        } catch (const InputError&) {
            double before = start, x = method == 2 ? second : start;
            for (int i = 0; i < 100 && x != before + (method == 2 ? 0 : 1); ++i) {
                const double next = x - f(x) / slope(x, before);
                before = x;
                x = next;
            }
            if (std::abs(x - a) < 1e-6 * std::abs(b - a)) FAIL("round " << round << ": refused, but finds the root");
            ++tally.refused;
            continue;
        }
        const double size = std::abs(a) + std::abs(b);
        bool good = true;
        for (int i = method == 2 ? 1 : 0; i < 12; ++i) {
            const auto [x, error, order] = row_of(exact, i);
            const auto next = row_of(exact, i + 1);
            const double before = i > 0 ? row_of(exact, i - 1)[0] : x;
            const double s = slope(x, before);
            // Each x and each of its differences is rounded once or twice.
            const double noise = 8 * eps * (size + std::abs(x) + std::abs(before) + std::abs(next[0]));
            const double slack = noise * (std::abs(x - a) + std::abs(x - b) + std::abs(s) + std::abs(next[0] - x));
            good = good && std::abs(f(x) + s * (next[0] - x)) <= slack && std::abs(error - std::abs(x - a)) <= noise;
            good = good && (i < 2 || error == 0 || !std::isinf(order));
        }
        if (!good)
            FAIL("round " << round << ": " << words[method] << ", " << a << ", " << b << ", " << start << ", "
                          << second);
        ++tally.checked;
    }
    CHECK(tally.mostly_checked());
}

TEST_CASE("scalar_root_convergence: the gate rings for seeded faults", "[alarm]") {
    for (const auto& problem : problems()) {
        const Sequence good = sequence(problem);
        INFO(words[static_cast<std::size_t>(problem.method)] << ", root " << problem.root);
        CHECK(ringing(good).empty());
        const double d = problem.gap(), first = problem.start - problem.root;
        // Recursions with a fault: other root 1e-6 of the gap off, factor 2 forgotten, a slope of the root, and errors
        // taken as the difference of iterates in double precision.
        const auto with = [&](auto next) {
            Sequence claimed = good;
            for (std::size_t i = problem.method == Method::secant ? 2 : 1; i < claimed.errors.size(); ++i)
                claimed.errors[i] = next(claimed.errors[i - 1], i > 1 ? claimed.errors[i - 2] : 0.0);
            return claimed;
        };
        const double off = d * (1 + 1e-6);
        if (problem.method == Method::newton) {
            CHECK(ringing(with([&](double e, double) { return e * e / (2 * e + off); })) == "iteration; powers; ");
            CHECK(ringing(with([&](double e, double) { return e * e / (e + d); })) == "iteration; powers; ");
        } else if (problem.method == Method::modified_newton) {
            CHECK(ringing(with([&](double e, double) { return e * (2 * first - e) / (2 * first + off); })) ==
                  "iteration; ");
            CHECK(ringing(with([&](double e, double) { return -e * e / d; })) == "iteration; ");
        } else {
            CHECK(ringing(with([&](double e, double b) { return e * b / (e + b + off); })) == "iteration; powers; ");
            CHECK(ringing(with([&](double e, double) { return e * e / (2 * e + d); })) == "iteration; powers; ");
        }
        Sequence rounded = good;
        for (double& e : rounded.errors) e = (problem.root + e) - problem.root;
        CHECK_THAT(ringing(rounded), ContainsSubstring("iteration"));
        Sequence broken = good;
        std::fill(broken.errors.begin() + 2, broken.errors.end(), std::nan(""));
        CHECK_THAT(ringing(broken), ContainsSubstring("iteration"));
    }
}
