#pragma once
// The errors of three root finders on a quadratic, exact far below the round-off of the iterates.
#include <vector>

#include "oracles/oracle.hpp"

namespace ordo::oracles {

/// Newton's, the modified Newton (slope of the start kept) and the secant method on f(x) = (x - root) (x - other_root).
///
/// With e = x - root and d = root - other_root = f'(root), f = e (e + d) and f' = 2 e + d. In e, each method is a
/// recursion without a difference of nearly equal numbers, so that errors far below 1e-16 keep their digits:
///
///   newton            e_{i+1} = e_i^2 / (2 e_i + d)                    order 2,   constant 1 / |d|
///   modified_newton   e_{i+1} = e_i (2 e_0 - e_i) / (2 e_0 + d)        order 1,   constant |2 e_0 / (2 e_0 + d)|
///   secant            e_{i+1} = e_i e_{i-1} / (e_i + e_{i-1} + d)      order phi = (1 + sqrt(5)) / 2,
///                                                                      constant |d|^(1 - phi)
///
/// constant limit of |e_{i+1}| / |e_i|^order
/// accurate errors 4 order^i ulp, relative (modified_newton 4 (i + 1)), down to 1e-300, started outside the two roots;
///          a start between them adds what cancels in f'(start)  (gate: tests/oracles/scalar_root_convergence_test.cpp)
/// source   problem and numbers [Brannon2011]; formulas our own
struct ScalarRootConvergence {
    enum class Method { newton, modified_newton, secant };

    Method method = Method::newton;
    double root = 1.5;          ///< the one that is sought
    double other_root = 2.3;    ///< not the same
    double start = 0;           ///< x_0
    double second_start = 0.5;  ///< x_1 of the secant method

    double gap() const { return root - other_root; }   ///< d
    bool converges() const;                            ///< to root, by the theory of each method
    std::vector<double> errors(int iterations) const;  ///< e_0 ... e_iterations with their signs; infinite: no iterate
    double order() const;
    double asymptotic_constant() const;

private:
    double next(double e, double before) const;
};

/// Order seen at iterate i: ln |e_i / e_{i-1}| / ln |e_{i-1} / e_{i-2}|. NaN for i < 2 and where an error is 0.
double observed_order(const std::vector<double>& errors, std::size_t i);

Oracle scalar_root_convergence();

}  // namespace ordo::oracles
