// A history as text and as JSON.
#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/text.hpp"
#include "reports/gate/history.hpp"
#include "reports/gate/outcome.hpp"

namespace ordo::reports {
namespace {

std::string level(double value) { return std::isnan(value) ? "none" : fmt::format("{:.6g}", value); }

/// "+3.2 %"; the difference itself where there is no old level to compare with, or where it is zero.
std::string change(const HistoryStep& step) {
    const double difference = step.new_level - step.old_level;
    if (std::isnan(difference)) return "";
    if (step.old_level == 0) return fmt::format("{:+.3g}", difference);
    return fmt::format("{:+.3g} %", 100 * difference / std::abs(step.old_level));
}

}  // namespace

std::string history_text(const History& history) {
    std::string text;
    if (!history.steps.empty()) {
        std::vector<std::vector<std::string>> rows{{"study", "figure", "revision", "old", "new", "change"}};
        for (const auto& step : history.steps) {
            rows.push_back({step.study, step.figure, step.before + " -> " + step.now, level(step.old_level),
                            level(step.new_level), change(step)});
        }
        text += "steps:\n" + aligned(rows) + '\n';
    }
    for (const auto& note : history.notes) text += "note: " + one_line(note) + '\n';
    return text + fmt::format("{} reports of {} studies at {} revisions, {} figures looked at: {} steps\n",
                              history.reports, history.studies, history.revisions, history.figures,
                              history.steps.size());
}

std::string history_json(const History& history) {
    using Json = nlohmann::ordered_json;
    const auto number = [](double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); };
    Json steps = Json::array();
    for (const auto& step : history.steps) {
        steps.push_back({{"study", step.study},
                         {"figure", step.figure},
                         {"before", step.before},
                         {"now", step.now},
                         {"old", number(step.old_level)},
                         {"new", number(step.new_level)}});
    }
    const Json json{{"schema", "ordo-history-1"},     {"reports", history.reports}, {"studies", history.studies},
                    {"revisions", history.revisions}, {"figures", history.figures}, {"steps", steps},
                    {"notes", history.notes}};
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace ordo::reports
