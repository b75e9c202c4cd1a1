#include "studies/engine/decided.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "core/text.hpp"
#include "studies/engine/judge.hpp"
#include "studies/engine/order_check.hpp"

namespace ordo::studies {
namespace {

constexpr std::size_t least_points = 5;  // of a fit that decides an order; it holds without its finest one too
constexpr double near_floor = 2;         // an error up to so many floors is at the floor

/// The levels of one line: those that have ended, and those that may be left.
struct Levels {
    const Study& study;
    const std::vector<Run>& runs;
    const Series& line;
    std::size_t ended;

    const Run& run(std::size_t level) const { return runs[static_cast<std::size_t>(line.runs[level])]; }
    const Run& finest() const { return run(ended - 1); }
    const std::string& solver() const { return run(0).solver; }
    Series first(std::size_t levels) const {
        return {line.label, line.abscissa, line.shown, {line.runs.begin(), line.runs.begin() + std::ptrdiff_t(levels)}};
    }
    template <class Holds>
    bool any_left(Holds&& holds) const {
        for (std::size_t level = ended; level < line.runs.size(); ++level) {
            if (holds(run(level))) return true;
        }
        return false;
    }
};

/// A printed value that is judged stands at this run.
bool has_printed_value(const Study& study, const Run& run) {
    const auto matches = [&](const PublishedValue& value) {
        return std::ranges::all_of(value.axes, [&](const auto& at) { return run.axis(at.first) == at.second; });
    };
    return std::ranges::any_of(study.published, [&](const Published& table) {
        return table.compare != Compare::none && table.solver == run.solver &&
               std::ranges::any_of(table.values, matches);
    });
}

/// A level that ended is outside the bound already, which no finer one can mend.
bool bound_is_broken(const Levels& levels, const Expectation& expectation, const std::string& key) {
    for (std::size_t level = 0; level < levels.ended; ++level) {
        const Run& run = levels.run(level);
        if (admits(expectation, run) && !(run.error(key) <= expectation.value)) return true;
    }
    return false;
}

/// What an order is expected of, and what the fit over the first levels says of it.
struct Judged {
    const Expectation& expectation;
    SeriesFit fit;
    Check check;
};

std::vector<Judged> orders_over(const Levels& levels, std::size_t count) {
    std::vector<Judged> orders;
    const Series series = levels.first(count);
    for (const auto& fit : fits_of(levels.study, levels.runs, {series})) {
        for (const auto& expectation : levels.study.expect) {
            const bool ours = expectation.kind == Expectation::Kind::order &&
                              speaks_of(expectation, fit.quantity, levels.solver()) &&
                              speaks_along(expectation, fit.abscissa) && fit.where == text_of(expectation.where);
            if (ours) orders.push_back({expectation, fit, order_check(expectation, fit, "")});
        }
    }
    return orders;
}

/// A gate that is not lost yet waits for a level that is left.
bool is_waited_for(const Levels& levels, const std::vector<Judged>& orders) {
    const auto& study = levels.study;
    if (levels.any_left([&](const Run& run) { return has_printed_value(study, run); })) return true;
    for (const auto& expectation : study.expect) {
        if (expectation.kind == Expectation::Kind::order) continue;
        if (!levels.any_left([&](const Run& run) { return admits(expectation, run); })) continue;
        for (const auto& quantity : study.measure.quantities) {
            const std::string key = quantity.key();
            if (speaks_of(expectation, key, levels.solver()) && !bound_is_broken(levels, expectation, key)) return true;
        }
    }
    return std::ranges::any_of(orders, [&](const Judged& order) {
        const auto enough = std::max(std::size_t{3}, static_cast<std::size_t>(order.expectation.levels));
        return order.fit.used.size() < enough &&
               levels.any_left([&](const Run& run) { return admits(order.expectation, run); });
    });
}

/// Where a step is swept as such, the Courant number grows with dt/h.
bool courant_grows(const Levels& levels) {
    const auto has_step = [](const Run& run) {
        return std::ranges::find(run.axes, "dt", &RunFigure::name) != run.axes.end() && run.h > 0;
    };
    const Run& last = levels.finest();
    return has_step(last) && !levels.any_left([&](const Run& run) {
        return !has_step(run) || !(run.dt / run.h > last.dt / last.h * (1 + 1e-9));
    });
}

/// The estimator finds a floor under the errors, and the two finest levels are at it.
bool is_at_floor(const Levels& levels, const Quantity& quantity) {
    if (is_place(quantity.norm)) return true;
    std::vector<FitPoint> points;
    for (std::size_t level = 0; level < levels.ended; ++level) {
        const Run& run = levels.run(level);
        if (run.status == Status::ok) points.push_back({run.at(levels.line.abscissa), run.error(quantity.key())});
    }
    if (points.size() < least_points) return false;
    const double larger = std::max(points.back().error, points[points.size() - 2].error);
    const auto found = fit_order(std::move(points));
    const bool known = found.verdict == Convergence::at_floor || found.verdict == Convergence::converges;
    return known && found.fit && found.fit->model == ErrorModel::power_and_floor &&
           larger <= near_floor * found.fit->floor;
}

/// Nothing that is left is in the order's range; or the order passes with five points, and did without the finest.
bool is_decided(const Levels& levels, const Judged& now, const std::vector<Judged>& before) {
    if (!levels.any_left([&](const Run& run) { return admits(now.expectation, run); })) return true;
    const auto passes = [&](const Judged& order, std::size_t points) {
        return order.check.verdict == Verdict::pass && order.fit.used.size() >= points &&
               order.fit.outcome.verdict == Convergence::converges;
    };
    const auto least = std::max(least_points, static_cast<std::size_t>(now.expectation.levels));
    return passes(now, least) && std::ranges::any_of(before, [&](const Judged& order) {
               return &order.expectation == &now.expectation && order.fit.quantity == now.fit.quantity &&
                      passes(order, least - 1);
           });
}

}  // namespace

std::string why_decided(const Study& study, const std::vector<Run>& runs, const Series& line, std::size_t ended) {
    if (ended == 0 || ended >= line.runs.size()) return "";
    const Levels levels{study, runs, line, ended};
    const std::string last = line.shown + " = " + shortest(levels.finest().at(line.shown));
    const auto orders = orders_over(levels, ended);
    if (levels.finest().status == Status::diverged && courant_grows(levels) && !is_waited_for(levels, {}))
        return "it blew up at " + last + ", and the Courant number grows from level to level";
    if (is_waited_for(levels, orders)) return "";
    const auto at_floor = [&](const Quantity& quantity) { return is_at_floor(levels, quantity); };
    if (std::ranges::all_of(study.measure.quantities, at_floor)) return "all errors are at their floor at " + last;
    if (orders.empty() || ended < 2) return "";
    const auto before = orders_over(levels, ended - 1);
    const auto decided = [&](const Judged& order) { return is_decided(levels, order, before); };
    return std::ranges::all_of(orders, decided) ? "every expected order is decided at " + last : "";
}

long skipped_wrongly(const Study& study, const std::vector<Run>& runs) {
    const auto skipped = [&](int id) { return runs[static_cast<std::size_t>(id)].status == Status::skipped; };
    if (!study.stops_when_decided) return std::ranges::count(runs, Status::skipped, &Run::status);
    long wrong = 0;
    for (const auto& line : lines_of(study, runs)) {
        const auto first = std::ranges::find_if(line.runs, skipped);
        if (first == line.runs.end()) continue;
        const auto ended = static_cast<std::size_t>(first - line.runs.begin());
        const bool rest = std::all_of(first, line.runs.end(), skipped);
        if (!rest || why_decided(study, runs, line, ended).empty())
            wrong += std::count_if(first, line.runs.end(), skipped);
    }
    return wrong;
}

}  // namespace ordo::studies
