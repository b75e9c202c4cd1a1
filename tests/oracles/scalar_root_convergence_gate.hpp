#pragma once
// What is true of a root finder's errors on a quadratic, in 50 digits: the textbook's iteration in x, and the powers to
// which two of the methods raise (x - root) / (x - other_root). Over sequences, so that faulty ones can be passed too.
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

#include "oracles/scalar_root_convergence.hpp"
#include "tests/oracles/differences.hpp"

namespace ordo::oracles::gate::root_iteration {

using Wide = boost::multiprecision::cpp_bin_float_50;
using Problem = ScalarRootConvergence;
using Method = Problem::Method;

inline constexpr double eps = std::numeric_limits<double>::epsilon();

/// A claimed sequence of errors with the problem that it was claimed for.
struct Sequence {
    Problem problem;
    std::vector<double> errors;

    /// Relative error of e_i that is stated; `condition` is what cancels in the slope at the start.
    double accuracy(std::size_t i) const {
        const double from_root = problem.start - problem.root, from_other = problem.start - problem.other_root;
        const double condition = (std::abs(from_root) + std::abs(from_other)) / std::abs(from_root + from_other);
        const double growth = problem.method == Method::newton            ? std::pow(2, i)
                              : problem.method == Method::modified_newton ? double(i + 1)
                                                                          : std::pow(1.6180339887, i);
        return 4 * eps * growth * condition;
    }
};

inline Sequence sequence(const Problem& problem) {
    return {problem, problem.errors(problem.method == Method::modified_newton ? 60 : 12)};
}

/// The textbook's iterates in x with 50 digits: x - f / slope.
inline std::vector<Wide> textbook(const Problem& problem, std::size_t count) {
    const Wide a = problem.root, b = problem.other_root;
    const auto f = [&](const Wide& x) -> Wide { return (x - a) * (x - b); };
    const auto slope = [&](const Wide& x) -> Wide { return (x - a) + (x - b); };
    std::vector<Wide> x{problem.start};
    if (problem.method == Method::secant) x.emplace_back(problem.second_start);
    while (x.size() < count) {
        const Wide now = x.back();
        Wide s = slope(problem.method == Method::newton ? now : x.front());
        if (problem.method == Method::secant) {
            const Wide before = x[x.size() - 2];
            if (abs(now - a) < 1e-40) break;  // the secant's own differences are used up
            s = (f(now) - f(before)) / (now - before);
        }
        x.push_back(now - f(now) / s);
    }
    return x;
}

/// Errors agree with those of the textbook's iterates for as long as 50 digits show them.
inline Defect iteration(const Sequence& claimed) {
    const auto x = textbook(claimed.problem, claimed.errors.size());
    Defect defect;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const Wide e = x[i] - Wide(claimed.problem.root);
        if (abs(e) < 1e-30 * std::abs(claimed.problem.root)) break;
        defect.add(static_cast<double>(Wide(claimed.errors[i]) / e - 1), claimed.accuracy(i), 1);
    }
    return defect;
}

/// r = (x - root) / (x - other_root) is squared by Newton's method and multiplied by the one before by the secant
/// method: errors down to 1e-290, without iterating.
inline Defect powers(const Sequence& claimed) {
    Defect defect;
    const auto& problem = claimed.problem;
    if (problem.method == Method::modified_newton) return defect;
    const Wide d = Wide(problem.root) - Wide(problem.other_root);
    const auto ratio = [&](double x) -> Wide { return (Wide(x) - problem.root) / (Wide(x) - problem.other_root); };
    int in_first = 1, in_second = 0;  // r_i = r_0^in_first r_1^in_second
    int next_first = 0, next_second = 1;
    for (std::size_t i = 0; i < claimed.errors.size(); ++i) {
        const Wide r = problem.method == Method::newton
                           ? Wide(pow(ratio(problem.start), 1 << i))
                           : Wide(pow(ratio(problem.start), in_first) * pow(ratio(problem.second_start), in_second));
        const Wide e = d * r / (1 - r);
        if (abs(e) < Wide("1e-290")) break;
        defect.add(static_cast<double>(Wide(claimed.errors[i]) / e - 1), claimed.accuracy(i), 1);
        std::tie(in_first, in_second, next_first, next_second) =
            std::tuple(next_first, next_second, in_first + next_first, in_second + next_second);
    }
    return defect;
}

inline std::string ringing(const Sequence& claimed) {
    return std::string(iteration(claimed).holds() ? "" : "iteration; ") + (powers(claimed).holds() ? "" : "powers; ");
}

}  // namespace ordo::oracles::gate::root_iteration
