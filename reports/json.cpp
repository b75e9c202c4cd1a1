// A report as JSON and back.
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "reports/order_view.hpp"
#include "reports/report.hpp"
#include "studies/engine/extrapolated.hpp"
#include "studies/engine/joint.hpp"
#include "studies/engine/judge.hpp"
#include "studies/reader/json_input.hpp"
#include "studies/reader/study_reader.hpp"

namespace ordo::reports {
namespace {

using studies::Json;
using studies::Node;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json figures(const std::vector<studies::RunFigure>& from) {
    Json object = Json::object();
    for (const auto& [name, value] : from) object[name] = number(value);
    return object;
}

Json run_json(const studies::Run& run) {
    Json json{{"run", run.id},
              {"solver", run.solver},
              {"axes", figures(run.axes)},
              {"h", number(run.h)},
              {"dt", number(run.dt)},
              {"t", number(run.t)},
              {"status", studies::text_of(run.status)},
              {"reason", run.reason},
              {"errors", figures(run.errors)},
              {"drift", figures(run.drift)},
              {"work", figures(run.work)}};
    if (!run.skipped.empty()) json["skipped"] = figures(run.skipped);
    return json;
}

Json series_json(const studies::Series& series) {
    return {{"label", series.label}, {"abscissa", series.abscissa}, {"shown", series.shown}, {"runs", series.runs}};
}

Json fit_json(const studies::SeriesFit& fit) {
    Json json{{"series", fit.series}, {"abscissa", fit.abscissa}, {"quantity", fit.quantity}, {"where", fit.where}};
    const auto put = [&](const char* name, double studies::OrderFit::*member) {
        json[name] = fit.outcome.fit ? number((*fit.outcome.fit).*member) : Json(nullptr);
    };
    put("order", &studies::OrderFit::order);
    put("low", &studies::OrderFit::low);
    put("high", &studies::OrderFit::high);
    put("coefficient", &studies::OrderFit::coefficient);
    put("floor", &studies::OrderFit::floor);
    put("second_coefficient", &studies::OrderFit::second_coefficient);
    put("second_order", &studies::OrderFit::second_order);
    put("correlation", &studies::OrderFit::correlation);
    json["model"] = fit.outcome.fit ? studies::text_of(fit.outcome.fit->model) : "";
    json["verdict"] = studies::text_of(fit.outcome.verdict);
    json["reason"] = fit.outcome.reason;
    json["neighbours"] = Json::array();
    if (fit.outcome.fit) {
        for (const double order : fit.outcome.fit->neighbours) json["neighbours"].push_back(number(order));
    }
    json["used"] = fit.used;
    json["left_out"] = Json::array();
    for (const auto& [run, why] : fit.left_out) json["left_out"].push_back({{"run", run}, {"why", why}});
    return json;
}

Json joint_json(const studies::JointResult& joint) {
    Json json{{"grid", joint.grid}, {"quantity", joint.quantity}, {"used", joint.used}, {"left_out", Json::array()}};
    for (const auto& [run, why] : joint.left_out) json["left_out"].push_back({{"run", run}, {"why", why}});
    json.update(json_of(joint.fit));
    return json;
}

Json extrapolation_json(const studies::SeriesExtrapolation& found) {
    Json methods = Json::array();
    for (const auto& method : found.methods) methods.push_back(json_of(method));
    return {{"series", found.series},
            {"abscissa", found.abscissa},
            {"quantity", found.quantity},
            {"used", found.used},
            {"methods", std::move(methods)}};
}

Json check_json(const studies::Check& check) {
    return {{"verdict", studies::text_of(check.verdict)},
            {"claim", check.claim},
            {"subject", check.subject},
            {"found", check.found},
            {"fault", studies::text_of(check.fault)},
            {"source", check.source}};
}

Json match_json(const studies::PublishedMatch& match) {
    return {{"table", match.table},
            {"run", match.run},
            {"printed", match.printed},
            {"ours", number(match.ours)},
            {"ours_as_printed", match.ours_as_printed},
            {"agrees", match.agrees},
            {"judged", match.judged}};
}

/// Ids of the runs whose figures come from there.
Json runs_of(const studies::Result& result, studies::Origin origin) {
    Json ids = Json::array();
    for (const auto& run : result.runs) {
        if (run.origin == origin) ids.push_back(run.id);
    }
    return ids;
}

template <class T, class F>
Json list(const std::vector<T>& items, F&& as_json) {
    Json array = Json::array();
    for (const auto& item : items) array.push_back(as_json(item));
    return array;
}

bool is_timed(const studies::Run& run) { return run.repeats.has_value(); }
Json spread_json(const studies::Run& run) { return run.repeats ? number(run.repeats->spread) : Json(nullptr); }
Json repetitions_json(const studies::Run& run) { return run.repeats ? run.repeats->number : 1; }

Json provenance_json(const Report& report) {
    const Provenance& from = report.provenance;
    Json seconds = Json::array();
    for (const auto& run : report.result.runs) seconds.push_back(number(run.seconds));
    Json json{{"time_utc", from.time_utc},
              {"ordo_version", from.ordo_version},
              {"revision", from.revision},
              {"compiler", from.compiler},
              {"flags", from.flags},
              {"build_type", from.build_type},
              {"libraries", from.libraries},
              {"cpu", from.cpu},
              {"cores", from.cores},
              {"os", from.os},
              {"jobs", from.jobs},
              {"seconds", number(from.seconds)},
              {"run_seconds", std::move(seconds)},
              {"cached", runs_of(report.result, studies::Origin::cached)},
              {"shared", runs_of(report.result, studies::Origin::shared)},
              {"kernel_seconds", number(from.kernel_seconds)}};
    if (std::ranges::any_of(report.result.runs, is_timed)) {
        json["run_spreads"] = list(report.result.runs, spread_json);
        json["run_repetitions"] = list(report.result.runs, repetitions_json);
    }
    return json;
}

double number_or_nan(const Node& node) { return node.json().is_null() ? std::nan("") : node.number(); }

/// A whole number that an int holds.
int whole(const Node& node) {
    const double value = node.number();
    if (value != std::floor(value) || std::abs(value) > std::numeric_limits<int>::max())
        node.refuse("must be a whole number");
    return static_cast<int>(value);
}

/// The entries of a list; unlike in a study, one alone is none.
std::vector<Node> entries(const Node& node) {
    if (!node.is_array()) node.refuse("must be a list");
    return node.items();
}

std::vector<studies::RunFigure> figures_from(const Node& node) {
    if (!node.is_object()) node.refuse("must be an object");
    std::vector<studies::RunFigure> figures;
    for (const auto& member : node.members()) figures.push_back({member.key(), number_or_nan(member)});
    return figures;
}

studies::Run run_from(const Node& node) {
    node.only({"run", "solver", "axes", "h", "dt", "t", "status", "reason", "errors", "drift", "work", "skipped"});
    studies::Run run;
    run.id = whole(node.at("run"));
    run.solver = node.at("solver").text();
    run.axes = figures_from(node.at("axes"));
    run.h = number_or_nan(node.at("h"));
    run.dt = number_or_nan(node.at("dt"));
    run.t = number_or_nan(node.at("t"));
    run.status = static_cast<studies::Status>(
        node.at("status").one_of({"ok", "reference", "diverged", "failed", "timed_out", "skipped"}));
    run.reason = node.at("reason").text();
    run.errors = figures_from(node.at("errors"));
    run.drift = figures_from(node.at("drift"));
    run.work = figures_from(node.at("work"));
    if (node.has("skipped")) run.skipped = figures_from(node.at("skipped"));
    return run;
}

/// How often each run was repeated, and the spread; empty where runs were not timed by themselves.
std::vector<studies::Repeats> repeats_from(const Node& provenance) {
    if (!provenance.has("run_repetitions") || !provenance.has("run_spreads")) return {};
    const auto numbers = entries(provenance.at("run_repetitions"));
    const auto spreads = entries(provenance.at("run_spreads"));
    if (numbers.size() != spreads.size()) provenance.at("run_spreads").refuse("must be as long as run_repetitions");
    std::vector<studies::Repeats> repeats;
    for (std::size_t i = 0; i < numbers.size(); ++i) repeats.push_back({whole(numbers[i]), number_or_nan(spreads[i])});
    return repeats;
}

Provenance provenance_from(const Node& node) {
    node.only({"time_utc", "ordo_version", "revision", "compiler", "flags", "build_type", "libraries", "cpu", "cores",
               "os", "jobs", "seconds", "run_seconds", "run_spreads", "run_repetitions", "cached", "shared",
               "kernel_seconds"});
    return {.time_utc = node.at("time_utc").text(),
            .ordo_version = node.at("ordo_version").text(),
            .revision = node.at("revision").text(),
            .compiler = node.at("compiler").text(),
            .flags = node.at("flags").text(),
            .build_type = node.at("build_type").text(),
            .libraries = node.at("libraries").texts(),
            .cpu = node.at("cpu").text(),
            .cores = whole(node.at("cores")),
            .os = node.at("os").text(),
            .jobs = whole(node.at("jobs")),
            .seconds = number_or_nan(node.at("seconds")),
            .kernel_seconds = node.has("kernel_seconds") ? number_or_nan(node.at("kernel_seconds")) : std::nan("")};
}

/// Says of the runs of that list where they come from; reports of an earlier time have no such list.
void mark(std::vector<studies::Run>& runs, const Node& provenance, const char* list, studies::Origin origin) {
    if (!provenance.has(list)) return;
    for (const auto& item : entries(provenance.at(list))) {
        const int id = whole(item);
        if (id < 0 || static_cast<std::size_t>(id) >= runs.size()) item.refuse("is no run");
        runs[static_cast<std::size_t>(id)].origin = origin;
    }
}

}  // namespace

std::string to_json(const Report& report) {
    const auto& result = report.result;
    const Json json{{"schema", report_schema},
                    {"study", Json::parse(result.study.document)},
                    {"verdict", studies::text_of(result.verdict)},
                    {"series", list(result.series, series_json)},
                    {"runs", list(result.runs, run_json)},
                    {"fits", list(result.fits, fit_json)},
                    {"joint", list(studies::joint_fits_of(result.study, result.runs), joint_json)},
                    {"extrapolations", list(studies::extrapolations_of(result), extrapolation_json)},
                    {"checks", list(result.checks, check_json)},
                    {"published", list(result.published, match_json)},
                    {"provenance", provenance_json(report)}};
    return json.dump(1) + "\n";
}

Report report_from_json(const std::string& text, const std::string& where) {
    const Json json = studies::parse_json(text, where);
    const Node root(json, where);
    if (!root.has("schema") || !root.at("schema").is_text() || root.at("schema").text() != report_schema) {
        root.refuse(std::string("is not a report of the schema '") + report_schema + "'");
    }
    root.only({"schema", "study", "verdict", "series", "runs", "fits", "joint", "extrapolations", "checks", "published",
               "provenance"});
    const auto study = studies::study_from_text(root.at("study").json().dump(), where + ": /study", "");
    const auto provenance = root.at("provenance");
    const auto seconds = entries(provenance.at("run_seconds"));
    const auto repeats = repeats_from(provenance);
    std::vector<studies::Run> runs;
    for (const auto& item : entries(root.at("runs"))) {
        runs.push_back(run_from(item));
        if (runs.back().id != static_cast<int>(runs.size()) - 1)
            item.at("run").refuse("must be the place of the run in the list");
        const bool timed = runs.size() <= seconds.size();
        runs.back().seconds = timed ? number_or_nan(seconds[runs.size() - 1]) : std::nan("");
        if (runs.size() <= repeats.size()) runs.back().repeats = repeats[runs.size() - 1];
    }
    mark(runs, provenance, "cached", studies::Origin::cached);
    mark(runs, provenance, "shared", studies::Origin::shared);
    return {studies::judged(study, std::move(runs)), provenance_from(provenance)};
}

Report read_report(const std::string& path) { return report_from_json(studies::read_text(path), path); }

}  // namespace ordo::reports
