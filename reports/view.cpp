#include "reports/view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/field.hpp"
#include "core/text.hpp"
#include "studies/amplification/figures.hpp"

namespace ordo::reports {
namespace {

using studies::Norm;

View& view_for(std::vector<View>& views, const studies::Quantity& quantity, const studies::Series& series) {
    for (auto& view : views) {
        if (view.quantity == quantity && view.abscissa == series.abscissa && view.shown == series.shown) return view;
    }
    return views.emplace_back(View{quantity, series.abscissa, series.shown, {}});
}

std::string norm_words(Norm norm) {
    switch (norm) {
        case Norm::rms: return "RMS";
        case Norm::l1: return "L1";
        case Norm::l2: return "L2";
        case Norm::linf: return "Linf";
        case Norm::l1_fans: return "L1 (inside of fans)";
        case Norm::shock: return "shocks";
        case Norm::contact: return "contacts";
        case Norm::l1_near: return "L1 (near waves)";
        case Norm::l1_away: return "L1 (away from waves)";
        case Norm::fan_edge:
        case Norm::value: break;
    }
    return "edges of the fans";
}

}  // namespace

std::vector<View> views_of(const studies::Result& result) {
    std::vector<View> views;
    for (const auto& quantity : result.study.measure.quantities) {
        for (const auto& series : result.series) view_for(views, quantity, series).series.push_back(&series);
    }
    return views;
}

const studies::Run& run_of(const studies::Result& result, int id) {
    const auto found = std::ranges::find(result.runs, id, &studies::Run::id);
    if (found == result.runs.end()) throw std::logic_error("no run has the id " + std::to_string(id));
    return *found;
}

bool stopped(const studies::Run& run) {
    return run.status != studies::Status::ok && run.status != studies::Status::reference;
}

std::vector<const studies::SeriesFit*> fits_along(const studies::Result& result, const View& view,
                                                  const studies::Series& series) {
    const auto ours = [&](int id) { return std::ranges::find(series.runs, id) != series.runs.end(); };
    std::vector<const studies::SeriesFit*> fits;
    for (const auto& fit : result.fits) {
        // Two series of one label differ in their runs.
        if (fit.series == series.label && fit.abscissa == series.abscissa && fit.quantity == view.quantity.key() &&
            std::ranges::all_of(fit.used, ours) && std::ranges::all_of(fit.left_out, ours, &studies::LeftOut::run)) {
            fits.push_back(&fit);
        }
    }
    return fits;
}

std::string error_words(const studies::Quantity& quantity) {
    if (is_value(quantity.norm)) return studies::stability_words(quantity.field);
    if (studies::is_place(quantity.norm))
        return "error of the place of the " + norm_words(quantity.norm) + " in " + quantity.field;
    const std::string norm = (quantity.maximum ? "largest " : "") + norm_words(quantity.norm) +
                             (quantity.undeformed ? " (undeformed volumes)" : "");
    if (quantity.against == studies::Against::itself) return norm + " norm of " + quantity.field;
    if (quantity.against == studies::Against::exact) return norm + " error of " + quantity.field;
    return norm + " difference of " + quantity.field + " from the finest run";
}

std::string unit_words(const studies::Quantity& quantity) {
    if (studies::is_place(quantity.norm)) return " [m]";
    const auto& fields = standard_fields();
    const auto field = std::ranges::find(fields, quantity.field, &FieldInfo::name);
    if (field == fields.end()) return "";
    const bool l1 = quantity.norm == Norm::l1 || quantity.norm == Norm::l1_fans || is_part(quantity.norm);
    const std::string length = l1 ? "m^dim" : quantity.norm == Norm::l2 ? "m^(dim/2)" : "";
    if (length.empty()) return " [" + field->unit + "]";
    return field->unit == "-" ? " [" + length + "]" : " [" + field->unit + " * " + length + "]";
}

std::string spoken(std::string name) {
    std::ranges::replace(name, '_', ' ');
    return name;
}

std::string time_words(const studies::Result& result, const studies::Quantity& quantity) {
    std::vector<double> times;
    for (const auto& run : result.runs) {
        if (!stopped(run) && std::isfinite(run.t)) times.push_back(run.t);
    }
    if (times.empty()) return "(no run reached the end)";
    const auto [first, last] = std::ranges::minmax(times);
    const std::string from = fmt::format("{:.6g}", first);
    const std::string to = fmt::format("{:.6g}", last);
    if (quantity.maximum) return "at any step up to t = " + to + " s";
    return "at t = " + (from == to ? to : from + " to " + to) + " s";
}

std::string decimal(double value, int decimals) {
    const std::string text = fmt::format("{:.{}f}", value, decimals);
    return text.starts_with('-') && text.find_first_not_of("-0.") == std::string::npos ? text.substr(1) : text;
}

std::string order_words(const studies::OrderFit& fit) {
    const bool bounded = std::isfinite(fit.low) && std::isfinite(fit.high);
    const std::string interval = bounded ? decimal(fit.low, 2) + ", " + decimal(fit.high, 2) : "no interval";
    return decimal(fit.order, 3) + " [" + interval + "]";
}

std::size_t width_of(const std::string& text) {
    return static_cast<std::size_t>(std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

std::string clipped(const std::string& text, std::size_t most) {
    if (width_of(text) <= most) return text;
    std::size_t characters = 0;
    const auto cut = std::ranges::find_if(text, [&](char c) { return (c & 0xC0) != 0x80 && ++characters > most; });
    return std::string(text.begin(), cut) + "...";
}

}  // namespace ordo::reports
