#include "studies/engine/order_check.hpp"

#include <fmt/format.h>

namespace ordo::studies {
namespace {

struct Finding {
    Verdict verdict;
    Fault fault;
};

/// What a verdict of the fit is called where it stands in the way of a pass.
Fault fault_of(Convergence verdict, Fault otherwise) {
    switch (verdict) {
        case Convergence::at_floor: return Fault::at_floor;
        case Convergence::pre_asymptotic: return Fault::pre_asymptotic;
        case Convergence::stalled: return Fault::stalled;
        case Convergence::diverges: return Fault::diverges;
        default: return otherwise;
    }
}

Finding finding_of(const Expectation& expectation, const SeriesFit& fit) {
    const FitOutcome& outcome = fit.outcome;
    if (outcome.refusal != Refusal::none) return {Verdict::fail, fault_of(outcome.refusal)};
    if (!outcome.fit) return {Verdict::fail, fault_of(outcome.verdict, Fault::order_uncertain)};
    if (static_cast<int>(fit.used.size()) < expectation.levels) return {Verdict::fail, Fault::fewer_levels};
    const double least = expectation.value - expectation.within;
    const double most = expectation.value + expectation.within;
    const bool too_high = expectation.may_exceed.empty() && outcome.fit->low > most;
    if (outcome.fit->high < least) return {Verdict::fail, fault_of(outcome.verdict, Fault::order_too_low)};
    if (too_high) return {Verdict::fail, Fault::order_too_high};
    const bool inside = outcome.fit->low >= least && (outcome.fit->high <= most || !expectation.may_exceed.empty());
    if (inside) return {Verdict::pass, Fault::none};
    return {Verdict::inconclusive, fault_of(outcome.verdict, Fault::order_uncertain)};
}

std::string found_text(const SeriesFit& fit) {
    if (!fit.outcome.fit) return "no order: " + fit.outcome.reason;
    const OrderFit& order = *fit.outcome.fit;
    return fmt::format("{:.3f} [{:.3f}, {:.3f}], {} points, {}: {}", order.order, order.low, order.high,
                       fit.used.size(), text_of(fit.outcome.verdict), fit.outcome.reason);
}

}  // namespace

Fault fault_of(Refusal refusal) {
    switch (refusal) {
        case Refusal::none: return Fault::none;
        case Refusal::too_few: return Fault::fewer_levels;
        case Refusal::abscissa: return Fault::point_missing;
        case Refusal::repeated: return Fault::point_repeated;
        case Refusal::is_nan: return Fault::error_is_nan;
        case Refusal::infinite: return Fault::error_is_infinite;
        case Refusal::negative: return Fault::error_is_negative;
        case Refusal::zero: break;
    }
    return Fault::error_is_zero;
}

Check order_check(const Expectation& expectation, const SeriesFit& fit, const std::string& claim) {
    const auto [verdict, fault] = finding_of(expectation, fit);
    const std::string levels =
        fault == Fault::fewer_levels ? fmt::format("; at least {} levels are asked for", expectation.levels) : "";
    const std::string declared = expectation.may_exceed.empty() ? "" : "; may exceed: " + expectation.may_exceed;
    return {claim,   fit.series + ": " + fit.quantity,    expectation.source,
            verdict, found_text(fit) + levels + declared, fault};
}

}  // namespace ordo::studies
