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

/// What a group usually scatters by: an amount, or a share of the value.
struct Usual {
    double spread = 0;
    bool relative = false;

    double at(double value) const { return relative ? spread * std::abs(value) : spread; }
};

/// Size and spread of one figure.
struct Scatter {
    double size = 0;
    double spread = 0;
};

double median_of(const std::vector<Scatter>& group, std::size_t first, std::size_t end, double Scatter::*member) {
    std::vector<double> values;
    for (std::size_t i = first; i < end; ++i) values.push_back(group[i].*member);
    return median(std::move(values));
}

/// A share where spreads grow with the values (more than with their root, from the lower half to the upper one) and
/// are small beside them; else an amount, as round-off is.
Usual usual_of(std::vector<Scatter> group) {
    std::ranges::sort(group, {}, &Scatter::size);
    const Usual amount{median_of(group, 0, group.size(), &Scatter::spread), false};
    if (group.size() < 4 || group.front().size == 0) return amount;
    const std::size_t half = group.size() / 2;
    const double growth =
        median_of(group, half, group.size(), &Scatter::spread) / median_of(group, 0, half, &Scatter::spread);
    const double sizes =
        median_of(group, half, group.size(), &Scatter::size) / median_of(group, 0, half, &Scatter::size);
    std::vector<double> shares;
    for (const auto& [size, spread] : group) shares.push_back(spread / size);
    const double share = median(std::move(shares));
    return growth > std::sqrt(sizes) && share < 0.5 ? Usual{share, true} : amount;
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
    std::map<std::string, std::vector<Scatter>> groups;
    for (std::size_t i = 0; i < figures.size(); ++i) {
        if (!std::isnan(figures[i].value))
            groups[figures[i].group()].push_back({std::abs(figures[i].value), spread[i]});
    }
    std::map<std::string, Usual> usual;
    for (const auto& [group, scatter] : groups) usual[group] = usual_of(scatter);
    std::vector<double> found;
    for (std::size_t i = 0; i < figures.size(); ++i) {
        const double value = figures[i].value;
        const double measured = std::isnan(value) ? 0 : std::max(spread[i], usual.at(figures[i].group()).at(value));
        found.push_back(std::max(times_spread * measured, least_tolerance(figures[i])));
    }
    return found;
}

}  // namespace ordo::reports
