// The two schemas: reports and studies are valid, what is wrong with them is found, by two validators without common
// code.
#include "reports/schema.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "core/error.hpp"
#include "studies/reader/study_reader.hpp"
#include "tests/app/process.hpp"
#include "tests/catch.hpp"
#include "tests/reports/samples.hpp"

using namespace ordo;
using samples::Json;

namespace {

namespace fs = std::filesystem;

const fs::path schemas = fs::path(ORDO_SOURCE_DIR) / "reports/schema";
const fs::path report_schema = schemas / "report-1.json";
const fs::path study_schema = schemas / "study-1.json";

/// Documents by name.
using Documents = std::map<std::string, Json>;

/// Validates by valijson.
class Validator {
public:
    explicit Validator(const fs::path& path) {
        const auto json = nlohmann::json::parse(studies::read_text(path.string()));
        valijson::SchemaParser(valijson::SchemaParser::kDraft7)
            .populateSchema(valijson::adapters::NlohmannJsonAdapter(json), schema_);
    }
    bool operator()(const Json& document) {
        const auto json = nlohmann::json::parse(document.dump());
        return validator_.validate(schema_, valijson::adapters::NlohmannJsonAdapter(json), nullptr);
    }

private:
    valijson::Schema schema_;
    valijson::Validator validator_;
};

/// Validates all of them by python3-jsonschema, and checks that each is found valid, or that each is found invalid.
void check_by_python(const fs::path& schema, const Documents& documents, bool valid) {
    const outside::Folder folder;
    outside::Words words{ORDO_PYTHON, std::string(ORDO_SOURCE_DIR) + "/tests/reports/validate.py", schema.string()};
    std::string expected;
    std::size_t number = 0;
    for (const auto& [name, document] : documents) {
        words.push_back(std::to_string(number++) + ".json");
        folder.write(words.back(), document.dump());
    }
    const auto outcome = outside::run(words, folder.here());
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    std::istringstream lines(outcome.out);
    std::string line;
    for (const auto& [name, document] : documents) {
        REQUIRE(std::getline(lines, line));
        INFO(name << ": " << line);
        CHECK(line.starts_with(valid ? "valid " : "invalid "));
    }
}

void check_by_valijson(const fs::path& schema, const Documents& documents, bool valid) {
    Validator validates(schema);
    for (const auto& [name, document] : documents) {
        INFO(name);
        CHECK(validates(document) == valid);
    }
}

Documents reports_of_every_kind() {
    Documents documents;
    for (const auto& [kind, report] : samples::reports_of_every_kind()) {
        documents[kind] = Json::parse(reports::to_json(report));
    }
    return documents;
}

/// One edit of a document: a place and, as JSON, what to put there; nothing takes the place away.
struct Edit {
    std::string place;
    std::string value;
};

/// The document once for each edit.
Documents edited(const Json& good, const std::vector<Edit>& edits) {
    Documents documents;
    for (const auto& [place, value] : edits) {
        Json json = good;
        const Json::json_pointer pointer(place);
        if (value.empty()) json[pointer.parent_pointer()].erase(pointer.back());
        else json[pointer] = Json::parse(value);
        documents[place + " = " + value] = json;
    }
    return documents;
}

/// Faults of every sort in a report: missing, of another type, unknown, outside the words, outside the range.
Documents wrong_reports() {
    const auto report = Json::parse(reports::to_json(samples::reports_of_every_kind().at("published")));
    const std::vector<Edit> edits{{"/schema", R"("ordo-report-2")"},
                                  {"/study", R"("sample")"},
                                  {"/verdict", R"("perhaps")"},
                                  {"/checks/0/verdict", R"("passed")"},
                                  {"/checks", "[]"},
                                  {"/series/0/abscissa", R"("1/")"},
                                  {"/series/0/runs", "[]"},
                                  {"/series/0/runs/0", "0.5"},
                                  {"/runs", "{}"},
                                  {"/runs/0/run", "-1"},
                                  {"/runs/0/status", R"("fine")"},
                                  {"/runs/0/h", R"("wide")"},
                                  {"/runs/0/axes", "{}"},
                                  {"/runs/0/axes/cells", "null"},
                                  {"/runs/0/errors/displacement.rms", R"("small")"},
                                  {"/runs/0/drift", "[]"},
                                  {"/fits/0/order", R"("2")"},
                                  {"/fits/0/abscissa", R"("1/")"},
                                  {"/fits/0/used/0", R"("first")"},
                                  {"/fits/0/left_out", R"([{"run": 0}])"},
                                  {"/published/0/agrees", "1"},
                                  {"/published/0/printed", R"("about 3")"},
                                  {"/published/0/run", "-2"},
                                  {"/provenance/time_utc", R"("yesterday")"},
                                  {"/provenance/cores", R"("two")"},
                                  {"/provenance/host", R"("here")"},
                                  {"/provenance/run_seconds", "1"}};
    auto all = edited(report, edits);
    for (const char* object : {"", "/series/0", "/runs/0", "/fits/0", "/checks/0", "/published/0", "/provenance"}) {
        const std::string place(object);
        all.merge(edited(report, {{place + "/extra", "1"}}));
        for (const auto& [member, value] : report[Json::json_pointer(place)].items()) {
            all.merge(edited(report, {{place + "/" + member, ""}}));
        }
    }
    return all;
}

/// Every study file of the project as the reader understands it, and as it stands in the file.
Documents shipped_studies() {
    Documents documents;
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(ORDO_SOURCE_DIR) / "studies")) {
        if (entry.path().extension() != ".json" || entry.path().parent_path().filename() == "published") continue;
        const auto path = entry.path().string();
        documents[path] = studies::parse_json(studies::read_text(path), path);
        documents[path + ", complete"] = Json::parse(studies::read_study(path).document);
    }
    return documents;
}

/// Studies that the reader takes, each with something else in it than the shipped ones.
Documents good_studies() {
    return edited(samples::study(), {{"/solvers", R"("all")"},
                                     {"/solvers", R"({"name": "mpm", "stress_update": ["usl", "usf"]})"},
                                     {"/solvers/0/conservative", "false"},
                                     {"/solvers/0/label", R"("ours")"},
                                     {"/measure/volume", R"("undeformed")"},
                                     {"/scene/ends", R"("fixed_fixed")"},
                                     {"/scene/mode", "3"},
                                     {"/sweep/ppc", "[1, 2, 3]"},
                                     {"/sweep/cells", "4"},
                                     {"/measure/norms", R"(["rms", "linf"])"},
                                     {"/measure/over", R"("maximum")"},
                                     {"/measure/orders_against", R"(["h", "1/steps"])"},
                                     {"/measure/orders_against", R"("h")"},
                                     {"/expect/0/against", R"("h")"},
                                     {"/expect", "[]"},
                                     {"/expect", R"({"exact_within": 1, "source": "any"})"},
                                     {"/expect/0/where", R"(["cells <= 8", "cells > 2"])"},
                                     {"/published", "[]"},
                                     {"/allow", R"("diverged")"},
                                     {"/allow", "[]"},
                                     {"/timeout_s", "1e-9"},
                                     {"/source", "[]"},
                                     {"/about", ""}});
}

/// Studies that the reader refuses.
Documents wrong_studies() {
    return edited(samples::study(), {{"/scene/Emodul", "5"},
                                     {"/scene/E", R"("stiff")"},
                                     {"/scene/E", "0"},
                                     {"/scene/mode", "1.5"},
                                     {"/scene/mode", "0"},
                                     {"/scene/name", R"("bar_vibrations")"},
                                     {"/scene/law", R"("E*F")"},
                                     {"/scene", ""},
                                     {"/scene", R"("bar_vibration")"},
                                     {"/solvers", "[]"},
                                     {"/solvers", R"("some")"},
                                     {"/solvers/0/name", R"("mpmm")"},
                                     {"/solvers/0/bases", "1"},
                                     {"/solvers/0/mass", R"("lump")"},
                                     {"/solvers/0/conservative", "1"},
                                     {"/solvers/0/label", "1"},
                                     {"/measure/volume", R"("now")"},
                                     {"/solvers/0/mass", "[]"},
                                     {"/sweep/cells", "-4"},
                                     {"/sweep/cells", R"("many")"},
                                     {"/sweep/cells", "[]"},
                                     {"/sweep/dt", "0"},
                                     {"/sweep/path", R"("sideways")"},
                                     {"/sweep/path", ""},
                                     {"/sweep/speed", "1"},
                                     {"/measure/at", "0"},
                                     {"/measure/at", R"("end")"},
                                     {"/measure/fields", R"("power")"},
                                     {"/measure/fields", "[]"},
                                     {"/measure/norms", R"("l3")"},
                                     {"/measure/orders_against", R"("1/")"},
                                     {"/measure/orders_against", "[]"},
                                     {"/expect/0/against", R"("1/")"},
                                     {"/measure/against", R"("x")"},
                                     {"/measure/until", R"("late")"},
                                     {"/expect/0/order", R"("two")"},
                                     {"/expect/0/within", "0"},
                                     {"/expect/0/source", ""},
                                     {"/expect/0/orders", "2"},
                                     {"/expect/0/error_at_most", "1"},
                                     {"/expect/0/within", ""},
                                     {"/published", R"({"compare": "digits"})"},
                                     {"/allow", R"("everything")"},
                                     {"/timeout_s", "0"},
                                     {"/study", R"("")"},
                                     {"/study", "1"},
                                     {"/studies", "1"},
                                     {"/source", "7"}});
}

}  // namespace

TEST_CASE("schema: the file of the study's schema is what the program writes", "[unit]") {
    const bool same = studies::read_text(study_schema.string()) == reports::study_schema();
    INFO("write it again: ordo list schema > reports/schema/study-1.json");
    CHECK(same);
}

TEST_CASE("schema: reports of every kind are valid", "[unit]") {
    check_by_valijson(report_schema, reports_of_every_kind(), true);
}

TEST_CASE("schema: the second validator finds reports of every kind valid, too", "[unit]") {
    check_by_python(report_schema, reports_of_every_kind(), true);
}

TEST_CASE("alarm: a report with a fault is invalid", "[alarm]") {
    const auto wrong = wrong_reports();
    CHECK(wrong.size() > 80);
    check_by_valijson(report_schema, wrong, false);
    check_by_python(report_schema, wrong, false);
}

TEST_CASE("schema: every shipped study is valid", "[unit]") {
    const auto shipped = shipped_studies();
    REQUIRE(shipped.size() >= 8);
    check_by_valijson(study_schema, shipped, true);
}

TEST_CASE("schema: the second validator finds every shipped study valid, too", "[unit]") {
    check_by_python(study_schema, shipped_studies(), true);
}

TEST_CASE("schema: what the reader takes is valid", "[unit]") {
    for (const auto& [name, document] : good_studies()) {
        INFO(name);
        CHECK_NOTHROW(studies::study_from_text(document.dump(), "sample", ""));
    }
    check_by_valijson(study_schema, good_studies(), true);
    check_by_python(study_schema, good_studies(), true);
}

TEST_CASE("alarm: a study with a fault is invalid, and the reader refuses it", "[alarm]") {
    for (const auto& [name, document] : wrong_studies()) {
        INFO(name);
        CHECK_THROWS_AS(studies::study_from_text(document.dump(), "sample", ""), InputError);
    }
    check_by_valijson(study_schema, wrong_studies(), false);
    check_by_python(study_schema, wrong_studies(), false);
}
