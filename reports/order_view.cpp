#include "reports/order_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ordo::reports {
namespace {

using namespace studies;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json json_of(const Estimate& estimate) {
    return {{"value", number(estimate.value)}, {"low", number(estimate.low)}, {"high", number(estimate.high)}};
}

std::string dominance_line(const JointFit& fit) {
    const auto count = [&](ErrorPart part) { return std::ranges::count(fit.shares, part, &Shares::dominant); };
    return fmt::format("largest part of the error: space at {}, time at {}, floor at {} of {} points",
                       count(ErrorPart::space), count(ErrorPart::time), count(ErrorPart::floor), fit.shares.size());
}

std::string next_line(const NextRun& next) {
    std::string line = fmt::format("next run: h = {:.6g}, dt = {:.6g}: {}", next.h, next.dt, next.why);
    if (std::isfinite(next.p_half_width))
        line += fmt::format(", to p +- {:.2g} and q +- {:.2g}", next.p_half_width, next.q_half_width);
    return line;
}

}  // namespace

std::string words_of(const Estimate& estimate) {
    if (std::isnan(estimate.value)) return "unknown";
    if (!std::isfinite(estimate.low)) return fmt::format("{:.4g} [no interval]", estimate.value);
    return fmt::format("{:.4g} [{:.4g}, {:.4g}]", estimate.value, estimate.low, estimate.high);
}

std::vector<std::string> lines_of(const JointFit& fit) {
    std::vector<std::string> lines;
    if (!fit.shares.empty()) {
        lines.push_back("error = A h^p + B dt^q + f, 95 % intervals");
        lines.push_back("order in h:  p = " + words_of(fit.p) + ", A = " + words_of(fit.A));
        lines.push_back("order in dt: q = " + words_of(fit.q) + ", B = " + words_of(fit.B));
        lines.push_back("floor: f = " + (std::isnan(fit.f.value) ? "none that shows" : words_of(fit.f)));
        lines.push_back(dominance_line(fit));
    }
    if (fit.next) lines.push_back(next_line(*fit.next));
    lines.push_back("verdict: " + text_of(fit.verdict) + (fit.reason.empty() ? "" : ": " + fit.reason));
    return lines;
}

std::string line_of(const Extrapolation& found) {
    std::string line = "no exact solution: " + found.method + ": ";
    if (found.model.empty()) return line + text_of(found.verdict) + ": " + found.reason;
    line += std::isnan(found.order) ? "law in " + found.model : fmt::format("order {:.6g}", found.order);
    line += fmt::format(", limit {:.8g}", found.limit);
    if (std::isfinite(found.uncertainty)) line += fmt::format(", finest value +- {:.4g}", found.uncertainty);
    if (std::isfinite(found.safety)) line += fmt::format(" (factor of safety {})", found.safety);
    return line + ", " + text_of(found.verdict) + (found.reason.empty() ? "" : ": " + found.reason);
}

Json json_of(const JointFit& fit) {
    Json shares = Json::array();
    for (const auto& each : fit.shares) {
        shares.push_back({{"space", number(each.space)},
                          {"time", number(each.time)},
                          {"floor", number(each.floor)},
                          {"largest", text_of(each.dominant())}});
    }
    Json next = nullptr;
    if (fit.next) {
        next = {{"h", number(fit.next->h)},
                {"dt", number(fit.next->dt)},
                {"p_half_width", number(fit.next->p_half_width)},
                {"q_half_width", number(fit.next->q_half_width)},
                {"why", fit.next->why}};
    }
    return {{"verdict", text_of(fit.verdict)},
            {"reason", fit.reason},
            {"p", json_of(fit.p)},
            {"q", json_of(fit.q)},
            {"A", json_of(fit.A)},
            {"B", json_of(fit.B)},
            {"f", json_of(fit.f)},
            {"scatter", number(fit.scatter)},
            {"shares", std::move(shares)},
            {"next", std::move(next)}};
}

Json json_of(const Extrapolation& found) {
    return {{"method", found.method},
            {"assumes", found.assumes},
            {"verdict", text_of(found.verdict)},
            {"reason", found.reason},
            {"model", found.model},
            {"order", number(found.order)},
            {"limit", number(found.limit)},
            {"uncertainty", number(found.uncertainty)},
            {"safety", number(found.safety)}};
}

}  // namespace ordo::reports
