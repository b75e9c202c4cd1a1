#include "reports/cache/kept_run.hpp"

#include <cmath>
#include <limits>

#include "core/text.hpp"
#include "studies/reader/json_input.hpp"

namespace ordo::reports {
namespace {

using studies::Json;
using studies::Node;

constexpr const char* entry_schema = "ordo-run-1";

/// JSON knows no infinity and no NaN: they stand as words.
Json exact(double value) { return std::isfinite(value) ? Json(value) : Json(shortest(value)); }

double exact_from(const Node& node) {
    if (!node.is_text()) return node.number();
    const double infinite = std::numeric_limits<double>::infinity();
    const double known[] = {std::nan(""), infinite, -infinite};
    return known[node.one_of({"nan", "inf", "-inf"})];
}

Json figures(const std::vector<studies::RunFigure>& from) {
    Json list = Json::array();
    for (const auto& [name, value] : from) list.push_back({name, exact(value)});
    return list;
}

std::vector<studies::RunFigure> figures_from(const Node& node) {
    if (!node.is_array()) node.refuse("must be a list");
    std::vector<studies::RunFigure> figures;
    for (const auto& item : node.items()) {
        const auto pair = item.items();
        if (pair.size() != 2) item.refuse("must be a name and a number");
        figures.push_back({pair[0].text(), exact_from(pair[1])});
    }
    return figures;
}

/// Statuses that are kept, in the order of the words.
constexpr studies::Status kept[] = {studies::Status::ok, studies::Status::reference, studies::Status::diverged};

}  // namespace

std::string text_of(const KeptRun& entry) {
    const auto& run = entry.run;
    const Json json{{"schema", entry_schema},
                    {"build", Json::parse(entry.build)},
                    {"run", Json::parse(entry.description)},
                    {"status", studies::text_of(run.status)},
                    {"reason", run.reason},
                    {"errors", figures(run.errors)},
                    {"drift", figures(run.drift)},
                    {"work", figures(run.work)},
                    {"skipped", figures(run.skipped)},
                    {"seconds", exact(run.seconds)}};
    return json.dump() + "\n";
}

KeptRun kept_run_from(const std::string& text, const std::string& where) {
    const Json json = studies::parse_json(text, where);
    const Node root(json, where);
    root.only({"schema", "build", "run", "status", "reason", "errors", "drift", "work", "skipped", "seconds"});
    root.at("schema").one_of({entry_schema});
    KeptRun entry{root.at("build").json().dump(), root.at("run").json().dump(), {}};
    entry.run.status = kept[root.at("status").one_of({"ok", "reference", "diverged"})];
    entry.run.reason = root.at("reason").text();
    entry.run.errors = figures_from(root.at("errors"));
    entry.run.drift = figures_from(root.at("drift"));
    entry.run.work = figures_from(root.at("work"));
    entry.run.skipped = figures_from(root.at("skipped"));
    entry.run.seconds = exact_from(root.at("seconds"));
    return entry;
}

}  // namespace ordo::reports
