#include "reports/cost/methods.hpp"

#include <algorithm>
#include <cmath>

#include "reports/view.hpp"
#include "studies/order/order_fit.hpp"

namespace ordo::reports {
namespace {

using namespace ordo::studies;

Method method_of(const Result& result, const Series& series, const std::string& key, Cost cost) {
    Method method{.label = series.label, .shown = series.shown, .runs = series.runs, .points = {}, .descent = {}};
    for (const int id : series.runs) {
        const Run& run = run_of(result, id);
        const double spent = cost_of(run, cost);
        method.points.push_back(stopped(run) ? CostPoint{} : CostPoint{spent, run.error(key)});
        if (spent > method.limit) method.limit = spent;
        if (cost == Cost::time && run.status == Status::timed_out)
            method.limit = std::max(method.limit, result.study.timeout_s.value_or(0));
    }
    method.descent = descent_of(method.points);
    return method;
}

/// No third method has a smaller error at this cost.
bool leads(const std::vector<Method>& methods, std::size_t one, std::size_t other, const CostPoint& at) {
    constexpr double rounding = 1e-9;
    for (std::size_t k = 0; k < methods.size(); ++k) {
        if (k != one && k != other && error_for(methods[k].descent, at.cost) < (1 - rounding) * at.error) return false;
    }
    return true;
}

}  // namespace

std::vector<Method> methods_of(const Result& result, const Quantity& quantity, Cost cost) {
    std::vector<Method> methods;
    for (const auto& series : lines_in(result)) methods.push_back(method_of(result, series, quantity.key(), cost));
    return methods;
}

FitOutcome cost_exponent(const Method& method) {
    std::vector<FitPoint> points;
    for (const auto& point : method.points) {
        if (placed(point) && point.error > 0) points.push_back({1 / point.cost, point.error});
    }
    return fit_order(std::move(points));
}

Reach reach_of(const Method& method, double error) {
    Reach reach{cost_to(method.descent, error)};
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < method.points.size(); ++k) {
        const CostPoint& point = method.points[k];
        if (!placed(point) || point.error > error || point.cost >= least) continue;
        least = point.cost;
        reach.run = method.runs[k];
    }
    return reach;
}

std::vector<std::size_t> ranked_at(const std::vector<Method>& methods, double error) {
    std::vector<std::size_t> order;
    for (std::size_t k = 0; k < methods.size(); ++k) {
        if (cost_to(methods[k].descent, error).reached != Reached::never) order.push_back(k);
    }
    std::ranges::stable_sort(order, {}, [&](std::size_t k) { return cost_to(methods[k].descent, error).cost; });
    return order;
}

std::vector<LeadChange> lead_changes(const std::vector<Method>& methods) {
    std::vector<LeadChange> changes;
    for (std::size_t a = 0; a < methods.size(); ++a) {
        for (std::size_t b = a + 1; b < methods.size(); ++b) {
            for (const auto& [at, first_leads] : crossovers(methods[a].descent, methods[b].descent)) {
                if (leads(methods, a, b, at)) changes.push_back({at, first_leads ? b : a, first_leads ? a : b});
            }
        }
    }
    std::ranges::sort(changes, {}, [](const LeadChange& change) { return change.at.cost; });
    return changes;
}

std::vector<FrontPoint> front_of(const std::vector<Method>& methods) {
    std::vector<CostPoint> points;
    std::vector<FrontPoint> all, front;
    for (std::size_t m = 0; m < methods.size(); ++m) {
        for (std::size_t k = 0; k < methods[m].points.size(); ++k) {
            points.push_back(methods[m].points[k]);
            all.push_back({points.back(), m, methods[m].runs[k]});
        }
    }
    for (const std::size_t i : pareto_front(points)) front.push_back(all[i]);
    return front;
}

}  // namespace ordo::reports
