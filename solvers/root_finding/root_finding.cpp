#include "solvers/root_finding/root_finding.hpp"

#include <cmath>

#include "core/error.hpp"

namespace ordo::solvers::root_finding {
namespace {

Method method_from(const Values& options) {
    const auto& word = options.word("method");
    return word == "newton" ? Method::newton : word == "secant" ? Method::secant : Method::modified_newton;
}

/// All iterations are done when a run starts; they are its state at every time.
class Running : public Simulation {
public:
    Running(const ScalarEquation& equation, Method method, int n) : x_(iterates(equation, method, n)) {}

    void advance_to(double t, const Interrupt&) override { t_ = t; }

    Snapshot snapshot() const override {
        return {.t = t_,
                .X = {static_cast<double>(x_.size() - 1)},
                .x = {static_cast<double>(x_.size() - 1)},
                .weights = {1},
                .fields = {{"root", 1, {x_.back()}}}};
    }

    std::vector<Figure> work() const override { return {{"iterations", static_cast<double>(x_.size() - 1)}}; }
    std::vector<Figure> drift() const override { return {}; }

private:
    std::vector<double> x_;
    double t_ = 0;
};

const ScalarEquation& equation_of(const Scene& scene) { return std::get<ScalarEquation>(scene); }

Plan plan(const Scene& scene, const Values& options, const Values& resolution) {
    const int n = resolution.whole("iterations");
    const Method method = method_from(options);
    if (method == Method::secant && n < 2)
        throw InputError("solver root_finding", "the secant method begins with two points; iterations must be >= 2");
    const auto x = iterates(equation_of(scene), method, n);
    const double correction = std::abs(x.back() - x[x.size() - 2]);
    if (!(correction > 0))
        throw InputError("solver root_finding", "the iteration arrives before " + std::to_string(n) +
                                                    " iterations in double precision; ask for fewer");
    return {.h = correction, .dt = 1, .points = 1};
}

Claim claim(const Values& options) {
    const Method method = method_from(options);
    const double golden_ratio = (1 + std::sqrt(5.0)) / 2;
    return {.order_in_space = method == Method::newton   ? 2
                              : method == Method::secant ? golden_ratio
                                                         : 1,
            .order_in_time = 0,
            .conserves = {},
            .provided = "near a simple root, error against the last correction",
            .source = "Traub1964"};
}

}  // namespace

std::vector<double> iterates(const ScalarEquation& equation, Method method, int n) {
    std::vector<double> x{equation.start};
    if (method == Method::secant) x.push_back(equation.second_start);
    const double first_slope = equation.slope(equation.start);
    while (static_cast<int>(x.size()) <= n) {
        const double here = x.back();
        const double f = equation.f(here);
        if (f == 0) {
            x.push_back(here);
            continue;
        }
        double slope = first_slope;
        if (method == Method::newton) slope = equation.slope(here);
        if (method == Method::secant) {
            const double before = x[x.size() - 2];
            slope = (f - equation.f(before)) / (here - before);
        }
        if (slope == 0 || !std::isfinite(slope)) throw Diverged("the slope is not a finite number other than zero");
        x.push_back(here - f / slope);
    }
    return x;
}

Solver solver() {
    return {.name = "root_finding",
            .about = "Newton's, modified Newton's and the secant iteration for one root of an equation",
            .source = {"Traub1964"},
            .options = {word("method", "newton",
                             {{"newton", "slope at every iterate"},
                              {"modified_newton", "slope at the first iterate, kept"},
                              {"secant", "slope through the last two iterates"}},
                             "how the next iterate is found")},
            .resolution = {whole("iterations", 5, between(1, 1000), "number of iterations")},
            .width_axis = "iterations",
            .width = "last correction |x_n - x_(n-1)|",
            .fields = {"root"},
            .claim = claim,
            .accepts = [](const Scene& scene) { return std::holds_alternative<ScalarEquation>(scene); },
            .plan = plan,
            .start = [](const Scene& scene, const Values& options, const Values& resolution,
                        std::span<const std::string>) -> std::unique_ptr<Simulation> {
                return std::make_unique<Running>(equation_of(scene), method_from(options),
                                                 resolution.whole("iterations"));
            }};
}

}  // namespace ordo::solvers::root_finding
