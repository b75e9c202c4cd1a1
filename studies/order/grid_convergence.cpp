#include "studies/order/grid_convergence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/math/tools/roots.hpp>
#include <cmath>

#include "core/text.hpp"
#include "studies/order/distributions.hpp"
#include "studies/order/value_fit.hpp"

namespace ordo::studies {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double highest_order = 50;

/// Of two values: no more apart than round-off.
bool alike(double a, double b) {
    return std::abs(a - b) <= 4 * std::numeric_limits<double>::epsilon() * std::max(std::abs(a), std::abs(b));
}

/// (h_c^p - h_m^p) / (h_m^p - h_f^p), by the logarithms of h_c / h_m and of h_f / h_m.
double ratio_at(double p, double coarse, double fine) {
    return p == 0 ? coarse / -fine : std::expm1(p * coarse) / -std::expm1(p * fine);
}

Refused refused(const std::vector<GridValue>& grids) {
    for (std::size_t i = 0; i < grids.size(); ++i) {
        const auto& [h, value] = grids[i];
        if (!(h > 0) || !std::isfinite(h))
            return {Refusal::abscissa, "the abscissa " + shortest(h) + " is not positive"};
        if (!std::isfinite(value))
            return {std::isnan(value) ? Refusal::is_nan : Refusal::infinite,
                    "the value is " + shortest(value) + " at abscissa " + shortest(h)};
        if (i > 0 && grids[i - 1].h == h) return {Refusal::repeated, "the abscissa " + shortest(h) + " is repeated"};
    }
    return {};
}

void sort_by_falling_h(std::vector<GridValue>& grids) {
    std::ranges::stable_sort(grids, [](const GridValue& a, const GridValue& b) { return a.h > b.h; });
}

Triple finest_triple(const std::vector<GridValue>& grids) {
    const std::size_t n = grids.size();
    return {grids[n - 3], grids[n - 2], grids[n - 1]};
}

/// Verdict and reason where three values have no order to extrapolate by; false where they have.
bool stops(const Triple& triple, Extrapolation& found) {
    switch (triple.behaviour()) {
        case Behaviour::monotone: return false;
        case Behaviour::oscillatory:
            found.verdict = Convergence::inconclusive;
            found.reason = "oscillatory: the three finest values go to and fro";
            break;
        case Behaviour::divergent:
            found.verdict = Convergence::diverges;
            found.reason = "divergent: the three finest values move apart as h falls";
            break;
        case Behaviour::equal:
            found.verdict = Convergence::stalled;
            found.reason = "equal: the two finest values do not differ";
            break;
    }
    return true;
}

/// The order that two grids, or three, give; false, with verdict and reason, where they give none.
bool order_for(const std::vector<GridValue>& grids, double formal, Extrapolation& found) {
    if (grids.size() < 2) found.reason = "fewer than two grids";
    else if (grids.size() == 2 && !(formal > 0)) found.reason = "two grids, and no formal order";
    else if (grids.size() == 2) found.order = formal;
    else if (const Triple triple = finest_triple(grids); !stops(triple, found)) found.order = triple.order();
    return found.order > 0;
}

Extrapolation by_richardson(const std::vector<GridValue>& grids, double formal) {
    Extrapolation found{"Richardson", "the grids lie in the asymptotic range: value = limit + C h^p"};
    if (grids.size() == 2) found.assumes += ", with the formal order";
    if (!order_for(grids, formal, found)) return found;
    found.model = "h^p";
    found.limit = richardson(grids.back(), grids[grids.size() - 2], found.order);
    found.uncertainty = std::abs(found.limit - grids.back().value);
    found.verdict = Convergence::converges;
    return found;
}

Extrapolation by_gci(const std::vector<GridValue>& grids, double formal) {
    Extrapolation found{"GCI", "the error of the finest grid is that of Richardson, times a factor of safety"};
    if (!order_for(grids, formal, found)) return found;
    const double highest = formal > 0 ? formal + 0.1 : 2.1;
    const bool in_range = grids.size() > 2 && found.order >= 0.5 && found.order <= highest;
    const GridValue fine = grids.back(), coarse = grids[grids.size() - 2];
    found.model = "h^p";
    found.safety = in_range ? 1.25 : 3;
    found.limit = richardson(fine, coarse, found.order);
    found.uncertainty = found.safety * std::abs(found.limit - fine.value);
    found.verdict = in_range ? Convergence::converges : Convergence::inconclusive;
    if (!in_range)
        found.reason = grids.size() == 2
                           ? "two grids show no order"
                           : fmt::format("the order {:.3g} is outside [0.5, {:.3g}]", found.order, highest);
    return found;
}

/// h and values as vectors, by falling h.
std::pair<VectorXd, VectorXd> vectors_of(const std::vector<GridValue>& grids) {
    const auto n = static_cast<Index>(grids.size());
    std::pair<VectorXd, VectorXd> both{VectorXd(n), VectorXd(n)};
    for (Index i = 0; i < n; ++i) {
        both.first(i) = grids[static_cast<std::size_t>(i)].h;
        both.second(i) = grids[static_cast<std::size_t>(i)].value;
    }
    return both;
}

/// The power law, weighted or not, that scatters less; below p = 0.5 the best law of fixed powers.
ValueFit least_scattering(const VectorXd& h, const VectorXd& values) {
    const auto scatters_less = [](const ValueFit& a, const ValueFit& b) { return a.spread < b.spread; };
    const std::array powers{fit_power(h, values, Weights::equal), fit_power(h, values, Weights::fine_grids)};
    const ValueFit best = std::ranges::min(powers, scatters_less);
    if (best.order >= 0.5) return best;
    std::vector<ValueFit> fixed;
    for (const Weights weights : {Weights::equal, Weights::fine_grids}) {
        fixed.push_back(fit_fixed(h, values, true, false, weights));
        fixed.push_back(fit_fixed(h, values, false, true, weights));
        fixed.push_back(fit_fixed(h, values, true, true, weights));
    }
    return std::ranges::min(fixed, scatters_less);
}

Extrapolation by_eca_hoekstra(const std::vector<GridValue>& grids) {
    Extrapolation found{"Eca-Hoekstra", "the values scatter around one law of h; a factor of safety covers the rest"};
    if (grids.size() < 4) {
        found.reason = "fewer than four grids";
        return found;
    }
    const auto [h, values] = vectors_of(grids);
    if (alike(values.maxCoeff(), values.minCoeff())) {
        found.verdict = Convergence::stalled;
        found.reason = "equal: the values do not differ";
        return found;
    }
    const ValueFit fit = least_scattering(h, values);
    const Index finest = h.size() - 1;
    const double range = (values.maxCoeff() - values.minCoeff()) / static_cast<double>(finest);
    const bool scatters = !(fit.spread < range);
    const bool in_range = fit.model == "h^p" && fit.order < 2.1;
    found.model = fit.model;
    if (fit.model == "h^p") found.order = fit.order;
    found.limit = fit.limit;
    found.safety = in_range && !scatters ? 1.25 : 3;
    const double error = std::abs(values(finest) - fit.limit);
    const double misfit = fit.spread + std::abs(values(finest) - fit.fitted(finest));
    found.uncertainty = scatters ? 3 * fit.spread / range * (error + misfit) : found.safety * error + misfit;
    found.verdict = in_range && !scatters ? Convergence::converges : Convergence::inconclusive;
    if (scatters) found.reason = "the values scatter by more than their range over a grid";
    else if (!in_range && found.model == "h^p") found.reason = fmt::format("the order {:.3g} is above 2.1", fit.order);
    else if (!in_range) found.reason = "the order is below 0.5";
    return found;
}

Extrapolation by_finest_level(std::vector<GridValue> grids) {
    Extrapolation found{"finest level",
                        "the finest grid is exact: the order comes out too high unless it is far finer than the rest"};
    if (grids.size() < 3) {
        found.reason = "fewer than three grids";
        return found;
    }
    const GridValue finest = grids.back();
    grids.pop_back();
    std::vector<FitPoint> points;
    for (const auto& [h, value] : grids) points.push_back({h, std::abs(value - finest.value)});
    const FitOutcome outcome = fit_order(points);
    found.limit = finest.value;
    found.reason = outcome.reason;
    found.verdict = outcome.verdict;
    if (!outcome.fit) return found;
    found.model = "h^p";
    found.order = outcome.fit->order;
    return found;
}

}  // namespace

std::string text_of(Behaviour behaviour) {
    switch (behaviour) {
        case Behaviour::monotone: return "monotone";
        case Behaviour::oscillatory: return "oscillatory";
        case Behaviour::divergent: return "divergent";
        case Behaviour::equal: break;
    }
    return "equal";
}

Behaviour Triple::behaviour() const {
    if (alike(medium.value, fine.value)) return Behaviour::equal;
    const double ratio = (coarse.value - medium.value) / (medium.value - fine.value);
    if (ratio < 0) return Behaviour::oscillatory;
    const bool nears = ratio > ratio_at(0, std::log(coarse.h / medium.h), std::log(fine.h / medium.h));
    return nears ? Behaviour::monotone : Behaviour::divergent;
}

double Triple::order() const {
    const double to_coarse = std::log(coarse.h / medium.h), to_fine = std::log(fine.h / medium.h);
    const double ratio = (coarse.value - medium.value) / (medium.value - fine.value);
    const auto excess = [&](double p) { return std::log(ratio_at(p, to_coarse, to_fine) / ratio); };
    const bool has_order = ratio > 0 && behaviour() != Behaviour::equal;
    if (!has_order || excess(-highest_order) > 0 || excess(highest_order) < 0)
        return std::numeric_limits<double>::quiet_NaN();
    std::uintmax_t most = 200;
    const auto [low, high] = boost::math::tools::toms748_solve(excess, -highest_order, highest_order,
                                                               boost::math::tools::eps_tolerance<double>(), most);
    return (low + high) / 2;
}

double gci(GridValue fine, GridValue coarse, double order, double safety) {
    return safety * std::abs(1 - coarse.value / fine.value) / std::expm1(order * std::log(coarse.h / fine.h));
}

double richardson(GridValue fine, GridValue coarse, double order) {
    return fine.value + (fine.value - coarse.value) / std::expm1(order * std::log(coarse.h / fine.h));
}

std::vector<Extrapolation> extrapolations(std::vector<GridValue> grids, double formal) {
    sort_by_falling_h(grids);
    if (auto [refusal, why] = refused(grids); refusal != Refusal::none) {
        Extrapolation none;
        none.method = "none";
        none.verdict = Convergence::invalid;
        none.reason = std::move(why);
        return {none};
    }
    return {by_richardson(grids, formal), by_gci(grids, formal), by_eca_hoekstra(grids), by_finest_level(grids)};
}

FitOutcome fit_order_of_values(std::vector<GridValue> grids) {
    sort_by_falling_h(grids);
    FitOutcome outcome;
    if (auto [refusal, why] = refused(grids); refusal != Refusal::none) {
        outcome.refusal = refusal;
        outcome.reason = std::move(why);
        return outcome;
    }
    if (grids.size() < 3) {
        outcome.refusal = Refusal::too_few;
        outcome.reason = "fewer than three grids";
        return outcome;
    }
    Extrapolation stopped;
    if (stops(finest_triple(grids), stopped)) {
        outcome.verdict = stopped.verdict;
        outcome.reason = stopped.reason;
        return outcome;
    }
    OrderFit fit;
    for (std::size_t i = 2; i < grids.size(); ++i)
        fit.neighbours.push_back(Triple{grids[i - 2], grids[i - 1], grids[i]}.order());
    fit.correlation = std::numeric_limits<double>::quiet_NaN();
    if (grids.size() == 3) {
        const double limit = richardson(grids[2], grids[1], fit.neighbours[0]);
        fit.order = fit.neighbours[0];
        fit.low = -inf;
        fit.high = inf;
        fit.coefficient = std::abs(grids[0].value - limit) / std::pow(grids[0].h, fit.order);
    } else {
        const auto [h, values] = vectors_of(grids);
        const ValueFit law = fit_power(h, values, Weights::equal);
        const double freedom = static_cast<double>(grids.size() - 3);
        const double width = student_quantile(freedom, 0.975) * error_of_order(h, law);
        fit.order = law.order;
        // Triples whose orders drift show that one law does not hold: the interval bears them all.
        const auto [least, largest] = std::ranges::minmax(fit.neighbours);
        const bool orderly = std::ranges::all_of(fit.neighbours, [](double order) { return std::isfinite(order); });
        fit.low = orderly ? std::min(law.order - width, least) : -inf;
        fit.high = orderly ? std::max(law.order + width, largest) : inf;
        fit.coefficient = std::abs(law.constant) / std::pow(h.maxCoeff(), law.order);
    }
    outcome.verdict = fit.low > 0    ? Convergence::converges
                      : fit.high < 0 ? Convergence::diverges
                                     : Convergence::inconclusive;
    outcome.reason =
        outcome.verdict == Convergence::inconclusive ? "the interval of the order holds zero" : "value = limit + C h^p";
    outcome.fit = std::move(fit);
    return outcome;
}

}  // namespace ordo::studies
