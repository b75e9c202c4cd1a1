#include "reports/gate/tolerance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace ordo::reports {
namespace {

/// The upper median.
double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace

double least_tolerance(const Figure& figure) {
    if (figure.kind == FigureKind::work || std::isnan(figure.value)) return 0;
    const double size = std::abs(figure.value);
    return least_ulps * (std::nextafter(size, std::numeric_limits<double>::infinity()) - size);
}

std::vector<double> spreads(const std::vector<std::vector<Figure>>& reports) {
    std::vector<double> spread;
    for (std::size_t i = 0; i < reports.front().size(); ++i) {
        double low = reports.front()[i].value;
        double high = low;
        for (const auto& figures : reports) {
            low = std::min(low, figures[i].value);
            high = std::max(high, figures[i].value);
        }
        spread.push_back(std::isnan(high - low) ? 0 : high - low);
    }
    return spread;
}

std::vector<double> tolerances(const std::vector<std::vector<Figure>>& reports) {
    const auto& figures = reports.front();
    const auto spread = spreads(reports);
    std::map<std::string, std::vector<double>> groups;
    for (std::size_t i = 0; i < figures.size(); ++i) {
        if (!std::isnan(figures[i].value)) groups[figures[i].group()].push_back(spread[i]);
    }
    std::map<std::string, double> usual;
    for (const auto& [group, values] : groups) usual[group] = median(values);
    std::vector<double> found;
    for (std::size_t i = 0; i < figures.size(); ++i) {
        const double measured = std::isnan(figures[i].value) ? 0 : std::max(spread[i], usual.at(figures[i].group()));
        found.push_back(std::max(times_spread * measured, least_tolerance(figures[i])));
    }
    return found;
}

}  // namespace ordo::reports
