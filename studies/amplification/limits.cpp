#include "studies/amplification/limits.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <boost/math/constants/constants.hpp>
#include <complex>
#include <limits>

#include "core/error.hpp"
#include "oracles/stability/mpm_limits.hpp"

namespace ordo::studies {
namespace {

bool is_periodic(const Scheme& scheme) {
    const auto* body = std::get_if<solvers::SolidScene<1>>(&scheme.scene);
    return body != nullptr && solvers::any_face(*body, solvers::Face::periodic);
}

/// Cells of a periodic body in each of which the points stand alike; 0 otherwise.
int equal_cells(const Scheme& scheme, Eigen::Index points) {
    const auto number = [&](const char* name) { return scheme.resolution.number(name); };
    if (!is_periodic(scheme) || scheme.solver->name != "mpm" || number("scatter") > 0) return 0;
    const int cells = scheme.resolution.whole("cells");
    return points % cells == 0 && scheme.options.word("placement") != "body_centred" ? cells : 0;
}

/// Places of a cell's particles in it, read off a run of one cell that has not begun.
std::vector<double> places_in_cell(Scheme scheme) {
    Given given = scheme.resolution.all();
    given.insert_or_assign("cells", 1.0);
    scheme.resolution = Values(given);
    const auto still = at_rest(scheme.scene);
    const auto shot = scheme.start(still, 1, {})->snapshot();
    std::vector<double> xi;
    for (const double X : shot.X) xi.push_back((X - still.lower[0]) / (still.upper - still.lower)[0]);
    return xi;
}

bool is(const Scheme& scheme, const char* option, const char* word) { return scheme.options.word(option) == word; }

/// Tents with FLIP, in equal cells: of a periodic bar with these cells; for another body, of an endless one.
std::optional<double> tents_by_theory(const Scheme& scheme) {
    using oracles::TentScheme;
    const bool plain = is(scheme, "basis", "linear") && is(scheme, "transfer", "flip") &&
                       is(scheme, "time", "symplectic_euler") && !is(scheme, "mass", "fmpm") &&
                       !is(scheme, "stress_update", "usavg");
    const bool alike = !is(scheme, "placement", "body_centred") && scheme.resolution.number("scatter") == 0;
    if (!plain || !alike) return {};
    const int cells = scheme.resolution.whole("cells");
    const auto xi = places_in_cell(scheme);
    const TentScheme tents{.consistent = is(scheme, "mass", "consistent"),
                           .order = is(scheme, "stress_update", "usl") ? TentScheme::Order::stress_last
                                                                       : TentScheme::Order::stress_first_or_remapped};
    if (cells == 1 && xi.size() == 1 && !is_periodic(scheme) && !tents.consistent)
        return oracles::largest_courant_of_one_cell(tents.order, xi.front());
    return oracles::largest_courant(tents, xi, is_periodic(scheme) ? cells : 0);
}

std::optional<double> elements_by_theory(const Scheme& scheme) {
    const auto& body = std::get<solvers::SolidScene<1>>(scheme.scene);
    if (!is(scheme, "mass", "lumped") || body.faces[0][0] != solvers::Face::fixed) return {};
    const bool free_end = body.faces[0][1] == solvers::Face::free;
    const int elements = scheme.resolution.whole("cells");
    if (elements == 1 && !free_end) return {};
    return oracles::largest_courant_of_elements(elements, free_end);
}

}  // namespace

Limit first_limit(const std::function<bool(double)>& is_stable, const Stability& asked) {
    if (!is_stable(asked.from)) return {0, asked.from};
    double low = asked.from;
    double high = low;
    while (is_stable(high)) {
        if (high >= asked.to) return {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
        low = high;
        high = std::min(1.1 * high, asked.to);
    }
    while (high - low > asked.tolerance) {
        const double middle = 0.5 * (low + high);
        (is_stable(middle) ? low : high) = middle;
    }
    return {low, high};
}

double radius(const OneStep& step, const Scheme& scheme, double courant) {
    const int cells = equal_cells(scheme, step.points());
    return cells > 0 ? spectral_radius(waves_of(step, courant, cells)) : spectral_radius(step.matrix(courant));
}

Limit limit_by_matrix(const Scheme& scheme, const Stability& asked) {
    const OneStep step(scheme);
    return first_limit([&](double courant) { return radius(step, scheme, courant) <= radius_of_stable; }, asked);
}

Wave longest_wave(const Scheme& scheme, double courant) {
    const OneStep step(scheme);
    const int cells = equal_cells(scheme, step.points());
    if (cells < 2) throw InputError("", "waves need a periodic body of two equal cells at least");
    const double turn = 2 * boost::math::constants::pi<double>() / cells * courant;  // of the exact wave
    const auto waves = waves_of(step, courant, cells);
    const auto values = Eigen::ComplexEigenSolver<Eigen::MatrixXcd>(waves[1], false).eigenvalues();
    std::complex<double> nearest = std::numeric_limits<double>::infinity();
    for (const auto& value : values) {
        const bool stands = std::abs(value - 1.0) < 1e-6;  // what the grid does not see
        if (!stands && std::abs(value - std::polar(1.0, turn)) < std::abs(nearest - std::polar(1.0, turn)))
            nearest = value;
    }
    return {std::abs(std::arg(nearest)) / turn, std::abs(nearest)};
}

std::string growing_mode(const Scheme& scheme, double courant) {
    const OneStep step(scheme);
    const Eigen::EigenSolver<Eigen::MatrixXd> solver(step.matrix(courant));
    Eigen::Index largest = 0;
    solver.eigenvalues().cwiseAbs().maxCoeff(&largest);
    const Eigen::VectorXcd mode = solver.eigenvectors().col(largest);
    // Strains, which a grid of tents makes alike all over a cell; turned so that the largest one is real.
    const Eigen::VectorXcd strains = mode.tail(step.points());
    Eigen::Index top = 0;
    strains.cwiseAbs().maxCoeff(&top);
    const Eigen::VectorXd e = (strains / strains[top]).real();
    const int cells = scheme.resolution.whole("cells");
    std::vector<double> means(static_cast<std::size_t>(cells));
    for (Eigen::Index p = 0; p < e.size(); ++p) means[static_cast<std::size_t>(p * cells / e.size())] += e[p];
    int turns = 0;
    for (std::size_t k = 1; k < means.size(); ++k) turns += means[k] * means[k - 1] < 0;
    if (turns == 0) return "a mode without a node";
    if (turns + 2 >= cells) return "the saw-tooth mode";
    return fmt::format("a wave of about {:.1f} cells", 2.0 * cells / turns);
}

std::optional<double> limit_by_theory(const Scheme& scheme) {
    if (!std::holds_alternative<solvers::SolidScene<1>>(scheme.scene)) return {};
    if (scheme.solver->name == "mpm") return tents_by_theory(scheme);
    return scheme.solver->name == "fem" ? elements_by_theory(scheme) : std::nullopt;
}

std::optional<double> limit_while_crossing(const Scheme& scheme) {
    if (scheme.solver->name != "mpm" || is(scheme, "frame", "total") || !limit_by_theory(scheme)) return {};
    double smallest = std::numeric_limits<double>::infinity();
    Scheme moved = scheme;
    for (int k = 0; k <= 7; ++k) {
        Given given = scheme.resolution.all();
        given.insert_or_assign("shift", 0.07 * k);
        given.insert_or_assign("spread", 1.0);
        moved.resolution = Values(given);
        smallest = std::min(smallest, *limit_by_theory(moved));
    }
    return smallest;
}

}  // namespace ordo::studies
