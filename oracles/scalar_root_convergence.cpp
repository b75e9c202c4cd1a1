#include "oracles/scalar_root_convergence.hpp"

#include <array>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <limits>
#include <optional>

#include "core/error.hpp"
#include "core/text.hpp"

namespace ordo::oracles {
namespace {

using Method = ScalarRootConvergence::Method;

constexpr double phi = boost::math::constants::phi<double>();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
const std::string where = "oracle scalar_root_convergence";
const std::vector<FieldInfo> sequence_fields{{"iterate", "-", 0}, {"error", "-", 0}, {"order", "-", 0}};

/// Throws InputError where the method does not find the root.
void check(const ScalarRootConvergence& problem, const std::vector<double>& errors) {
    const auto& [method, root, other_root, start, second_start] = problem;
    const auto refuse = [](const std::string& text) { throw InputError(where, text); };
    if (root == other_root)
        refuse("root and other_root are both " + shortest(root) + ": a double root has other orders");
    if (!problem.converges() && method == Method::newton)
        refuse("start = " + shortest(start) +
               " is not nearer to root than to other_root: Newton's method does not "
               "find root; start on its side of " +
               shortest(0.5 * root + 0.5 * other_root) + ", or swap the roots");
    if (!problem.converges() && method == Method::modified_newton)
        refuse("start = " + shortest(start) +
               " is not nearer to root than to the middle of the roots: with its slope "
               "the iterates do not converge to root; start on the root's side of " +
               shortest(0.75 * root + 0.25 * other_root));
    if (!problem.converges())
        refuse("start = " + shortest(start) + ", second_start = " + shortest(second_start) +
               ": the secant method does not find root; start nearer to root = " + shortest(root));
    for (std::size_t i = 0; i < errors.size(); ++i) {
        if (!std::isfinite(errors[i]))
            refuse("iterate " + std::to_string(i) + " does not exist: the secant before it is level");
    }
}

/// One whole number of iterations out of 0 ... last.
std::size_t index_of(double x, std::size_t last) {
    if (x != std::floor(x) || x < 0 || x > static_cast<double>(last))
        throw InputError(where,
                         "x = " + shortest(x) + " is no iteration; x counts them: 0, 1, ... " + std::to_string(last));
    return static_cast<std::size_t>(x);
}

Constants constants_of(const ScalarRootConvergence& problem, const std::vector<double>& errors) {
    std::vector<Constants> iterates;
    for (std::size_t i = 0; i < errors.size(); ++i) {
        iterates.push_back({{"i", static_cast<double>(i)},
                            {"x", problem.root + errors[i]},
                            {"error", std::abs(errors[i])},
                            {"order", observed_order(errors, i)}});
    }
    return {{"root", problem.root},
            {"order", problem.order()},
            {"asymptotic_constant", problem.asymptotic_constant()},
            {"iterates", iterates}};
}

Exact bind(const Values& values) {
    const auto& word = values.word("method");
    const ScalarRootConvergence problem{.method = word == "newton"   ? Method::newton
                                                  : word == "secant" ? Method::secant
                                                                     : Method::modified_newton,
                                        .root = values.number("root"),
                                        .other_root = values.number("other_root"),
                                        .start = values.number("start"),
                                        .second_start = values.number("second_start")};
    const auto errors = problem.errors(values.whole("iterations"));
    check(problem, errors);
    return {.dim = 1,
            .coordinates = Coordinates::material,
            .abscissa = "iteration",
            .lower = {0},
            .upper = {values.number("iterations")},
            .fields = sequence_fields,
            .sample = along_a_line([root = problem.root, errors](double x, double) {
                const std::size_t i = index_of(x, errors.size() - 1);
                return std::array{root + errors[i], std::abs(errors[i]), observed_order(errors, i)};
            }),
            .jumps = no_jumps,
            .features = no_features,
            .constants = [problem, errors](std::optional<double>) { return constants_of(problem, errors); }};
}

}  // namespace

// In terms of r = e / (e + d) = (x - root) / (x - other_root): Newton's method squares r, so that |r_0| < 1 decides;
// the secant method has r_{i+1} = r_i r_{i-1}, so that r_n is r_1 to the n-th Fibonacci number times r_0 to the one
// before; with y = e / (2 e_0) the modified one is the logistic map y' = (1 - c) y (1 - y) from y = 1/2, c = d / (2 e_0
// + d), which goes to 0 for |1 - c| < 1.
bool ScalarRootConvergence::converges() const {
    const double slope = (start - root) + (start - other_root);
    if (method == Method::newton) return gap() * slope > 0;
    if (method == Method::modified_newton) return gap() * (slope + 2 * (start - root)) > 0;
    const auto log_ratio = [&](double x) { return std::log(std::abs((x - root) / (x - other_root))); };
    return start != second_start && phi * log_ratio(second_start) + log_ratio(start) < 0;
}

double ScalarRootConvergence::next(double e, double before) const {
    const double d = gap();
    const double first = start - root;
    if (method == Method::newton) return e * (e / (2 * e + d));
    if (method == Method::modified_newton) return e * ((2 * first - e) / (2 * first + d));
    return e * (before / (e + before + d));
}

std::vector<double> ScalarRootConvergence::errors(int iterations) const {
    std::vector<double> e{start - root};
    if (method == Method::secant) e.push_back(second_start - root);
    while (e.size() <= static_cast<std::size_t>(iterations))
        e.push_back(next(e.back(), e[e.size() - std::min<std::size_t>(2, e.size())]));
    return e;
}

double ScalarRootConvergence::order() const {
    return method == Method::newton ? 2 : method == Method::secant ? phi : 1;
}

double ScalarRootConvergence::asymptotic_constant() const {
    const double first = start - root;
    if (method == Method::newton) return 1 / std::abs(gap());
    if (method == Method::secant) return std::pow(std::abs(gap()), 1 - phi);
    return std::abs(2 * first / (2 * first + gap()));
}

double observed_order(const std::vector<double>& errors, std::size_t i) {
    if (i < 2 || errors[i] == 0 || errors[i - 1] == 0 || errors[i - 2] == 0) return nan;
    const double order =
        std::log(std::abs(errors[i] / errors[i - 1])) / std::log(std::abs(errors[i - 1] / errors[i - 2]));
    return std::isfinite(order) ? order : nan;
}

Oracle scalar_root_convergence() {
    return {
        .name = "scalar_root_convergence",
        .about = "Newton, modified Newton and secant method on a quadratic: iterates, errors, observed orders",
        .source = {"Brannon2011"},
        .explanation =
            "f(x) = (x - root) (x - other_root), error e = x - root, d = root - other_root = f'(root). The errors "
            "come\n"
            "from recursions that do not cancel, so that those below 1e-16 keep their digits:\n"
            "  newton:           e' = e^2 / (2 e + d)                 order 2, constant 1 / |d| = |f'' / (2 f')|\n"
            "  modified_newton:  e' = e (2 e_0 - e) / (2 e_0 + d)     order 1, constant |1 - f'(root) / f'(start)|\n"
            "  secant:           e' = e e_before / (e + e_before + d) order (1 + sqrt(5)) / 2 = phi, constant\n"
            "                                                         |d|^(1 - phi)\n"
            "modified_newton keeps the slope of the start; second_start is for the secant method alone.\n"
            "x counts the iterations, 0 (the start), 1, ... iterations; t has no meaning. iterate = root + e,\n"
            "error = |e|, order = ln(error_i / error_{i-1}) / ln(error_{i-1} / error_{i-2}), empty where i < 2 or "
            "where\n"
            "an error is 0 (below 1e-308 it is).\n"
            "Refused: equal roots, and starts from which the method does not find root. newton needs start nearer to\n"
            "root than to other_root; modified_newton nearer to root than to the middle of the two; secant\n"
            "|r(second_start)|^phi |r(start)| < 1 with r(x) = (x - root) / (x - other_root), and no level secant.\n"
            "constants: root, order, asymptotic_constant (limit of error_{i+1} / error_i^order),\n"
            "iterates [{i, x, error, order}]",
        .example = "scalar_root_convergence --set method=secant --t 0 --x 0,1,2,3,4,5",
        .parameters = {word("method", "newton",
                            {{"newton", "slope f'(x_i)"},
                             {"modified_newton", "slope f'(start) for ever"},
                             {"secant", "slope through the last two iterates"}},
                            "which root finder"),
                       number("root", "-", 1.5, between(-1e100, 1e100), "the root that is sought"),
                       number("other_root", "-", 2.3, between(-1e100, 1e100), "the other root of f"),
                       number("start", "-", 0, between(-1e100, 1e100), "first iterate"),
                       number("second_start", "-", 0.5, between(-1e100, 1e100), "second iterate of the secant method"),
                       whole("iterations", 9, between(1, 1000), "last iterate")},
        .fields = sequence_fields,
        .smoothness = "a sequence: x is a whole number",
        .accuracy =
            "error: 4 order^i ulp of itself (modified_newton 4 (i + 1)) down to 1e-300, started outside the "
            "roots; a start between them adds what cancels in f'(start); iterate: 1 ulp more",
        .bind = bind};
}

}  // namespace ordo::oracles
