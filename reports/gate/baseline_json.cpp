// A baseline as JSON and back.
#include <fmt/format.h>

#include <cmath>

#include "reports/gate/baseline.hpp"
#include "reports/gate/question.hpp"
#include "reports/gate/tolerance.hpp"
#include "studies/reader/json_input.hpp"
#include "studies/reader/study_reader.hpp"

namespace ordo::reports {
namespace {

using studies::Json;
using studies::Node;

constexpr const char* baseline_schema = "ordo-baseline-2";

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

double number_or_nan(const Node& node) { return node.json().is_null() ? std::nan("") : node.number(); }

Json maker_json(const Maker& maker) {
    return {{"time_utc", maker.time_utc}, {"revision", maker.revision}, {"compiler", maker.compiler},
            {"flags", maker.flags},       {"cpu", maker.cpu},           {"os", maker.os}};
}

Json run_json(const AcceptedRun& run) { return {{"run", run.run}, {"status", run.status}}; }

Json figure_json(const AcceptedFigure& accepted) {
    const Figure& figure = accepted.figure;
    return {{"kind", figure_kinds()[static_cast<std::size_t>(figure.kind)]},
            {"of", figure.subject},
            {"solver", figure.solver},
            {"what", figure.what},
            {"value", number(figure.value)},
            {"tolerance", number(accepted.tolerance)}};
}

std::string on_a_line(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

/// A list with one item a line.
template <class T, class F>
std::string lines(const std::vector<T>& items, F&& as_json) {
    std::string text = "[";
    for (const auto& item : items) text += (text.size() > 1 ? ",\n  " : "\n  ") + on_a_line(as_json(item));
    return text + "\n ]";
}

Maker maker_from(const Node& node) {
    node.only({"time_utc", "revision", "compiler", "flags", "cpu", "os"});
    return {node.at("time_utc").text(), node.at("revision").text(), node.at("compiler").text(),
            node.at("flags").text(),    node.at("cpu").text(),      node.at("os").text()};
}

AcceptedRun run_from(const Node& node) {
    node.only({"run", "status"});
    return {node.at("run").text(), node.at("status").text()};
}

AcceptedFigure figure_from(const Node& node) {
    node.only({"kind", "of", "solver", "what", "value", "tolerance"});
    const double tolerance = node.at("tolerance").number();
    if (!(tolerance >= 0)) node.at("tolerance").refuse("must not be negative");
    return {{static_cast<FigureKind>(node.at("kind").one_of(figure_kinds())), node.at("of").text(),
             node.at("solver").text(), node.at("what").text(), number_or_nan(node.at("value"))},
            tolerance};
}

/// The items of a list that must not be empty.
template <class F>
auto list_from(const Node& node, F&& item_from) {
    if (!node.is_array() || node.json().empty()) node.refuse("must be a list that is not empty");
    std::vector<decltype(item_from(node))> items;
    for (const auto& item : node.items()) items.push_back(item_from(item));
    return items;
}

}  // namespace

std::string to_json(const Baseline& baseline) {
    return fmt::format(
        "{{\n \"schema\": \"{}\",\n \"because\": {},\n \"reports\": {},\n \"tolerance\": {},\n \"time_ratio\": {},\n"
        " \"study\": {},\n \"runs\": {},\n \"figures\": {}\n}}\n",
        baseline_schema, on_a_line(baseline.because), lines(baseline.makers, maker_json),
        on_a_line({{"times_spread", times_spread}, {"least_ulps", least_ulps}}), on_a_line(number(baseline.time_ratio)),
        baseline.question, lines(baseline.runs, run_json), lines(baseline.figures, figure_json));
}

Baseline read_baseline(const std::string& path) {
    const Json json = studies::parse_json(studies::read_text(path), path);
    const Node root(json, path);
    if (!root.has("schema") || !root.at("schema").is_text() || root.at("schema").text() != baseline_schema)
        root.refuse(fmt::format("is not a baseline of the schema '{}'; make one: ordo accept", baseline_schema));
    root.only({"schema", "because", "reports", "tolerance", "time_ratio", "study", "runs", "figures"});
    root.at("tolerance").only({"times_spread", "least_ulps"});
    const auto study = studies::study_from_text(root.at("study").json().dump(), path + ": /study", "");
    return {.because = root.at("because").text(),
            .makers = list_from(root.at("reports"), maker_from),
            .time_ratio = number_or_nan(root.at("time_ratio")),
            .study = study.name,
            .question = question_of(study),
            .runs = list_from(root.at("runs"), run_from),
            .figures = list_from(root.at("figures"), figure_from)};
}

}  // namespace ordo::reports
