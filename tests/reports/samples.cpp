#include "tests/reports/samples.hpp"

#include <cmath>

#include "studies/engine/engine.hpp"
#include "studies/engine/judge.hpp"
#include "studies/reader/study_reader.hpp"

namespace ordo::samples {
namespace {

studies::Study read(const Json& study) { return studies::study_from_text(study.dump(), "sample", ""); }

reports::Report with_provenance(studies::Result result) {
    for (auto& run : result.runs) run.seconds = 0.25;
    return {std::move(result), reports::provenance_here(1, 0.75)};
}

/// Refined in time, against the finest dt and against the exact solution.
Json in_time() {
    Json json = study();
    json["sweep"] = {{"cells", 4}, {"dt", {0.02, 0.01, 0.005, 0.001}}, {"path", "time"}};
    json["measure"]["against"] = {"finest", "exact"};
    json["expect"] = Json::array({{{"error_at_most", 1}, {"source", "any"}}});
    return json;
}

/// A step far beyond the stability limit h sqrt(rho/E): these runs blow up.
Json too_large_a_step() {
    Json json = study();
    json["sweep"]["dt"] = 5;
    json["measure"]["at"] = 5000;
    json["allow"] = "diverged";
    return json;
}

/// A printed value that agrees in its one digit, and one that does not.
Json with_a_table() {
    const std::string of_4_cells = "2.6865e-04", none = "1.5e+03";
    Json json = study();
    Json table{{"id", "T1"}, {"title", "made up"}, {"source", "made up for a test"}, {"quantity", "displacement.rms"}};
    table["rows"] = Json::array({{{"cells", 4}, {"value", of_4_cells}}, {{"cells", 8}, {"value", none}}});
    json["published"] = {{"table", table}, {"compare", "digits"}};
    return json;
}

}  // namespace

Json study() {
    return studies::parse_json(R"({
        "study": "sample", "about": "three runs of the bar", "scene": { "name": "bar_vibration" },
        "solvers": [ { "name": "mpm" } ],
        "sweep": { "cells": [4, 8, 16], "dt": 5e-3, "path": "space" },
        "measure": { "at": 0.1, "fields": "displacement" },
        "expect": [ { "order": 2, "within": 0.2, "source": "linear functions" },
                    { "error_at_most": 1e-3, "source": "h^2" } ] })",
                               "sample");
}

reports::Report report_of(const Json& json) {
    const auto study = read(json);
    return with_provenance(studies::judged(study, studies::run_all(study, {})));
}

reports::Report report_of(const Json& json, std::vector<studies::Run> runs) {
    return with_provenance(studies::judged(read(json), std::move(runs)));
}

std::map<std::string, reports::Report> reports_of_every_kind() {
    std::map<std::string, reports::Report> all;
    all["ok"] = report_of(study());
    all["reference"] = report_of(in_time());
    all["diverged"] = report_of(too_large_a_step());
    all["published"] = report_of(with_a_table());
    auto runs = all["ok"].result.runs;
    runs[1].errors[0].value = runs[1].drift[0].value = std::nan("");
    all["nan"] = report_of(study(), runs);
    Json changed = study();
    changed["sweep"]["cells"] = {4, 8};
    all["two points"] = report_of(changed);
    changed = study();
    changed.erase("expect");
    all["nothing expected"] = report_of(changed);
    changed = study();
    changed["solvers"][0]["stress_update"] = {"usl", "musl"};
    changed["measure"]["norms"] = {"rms", "l1", "l2", "linf"};
    changed["measure"]["over"] = "maximum";
    all["two solvers"] = report_of(changed);
    changed = study();
    changed["sweep"] = {{"cells", {4, 8, 16}}, {"dt", {0.02, 0.01, 0.005}}, {"path", "grid"}};
    changed.erase("expect");
    all["grid"] = report_of(changed);
    changed = study();
    changed["measure"]["against"] = "itself";
    changed["expect"].erase(1);
    all["itself"] = report_of(changed);
    return all;
}

}  // namespace ordo::samples
