#pragma once
// What several tests of the command begin with.
#include "tests/app/process.hpp"
#include "tests/catch.hpp"
#include "tests/reports/samples.hpp"

namespace ordo::outside {

/// Writes the sample study to "s.json", and its report under these settings, "scene.E=50", to "r.json".
inline void make_report(const Folder& folder, const Words& settings = {}) {
    folder.write("s.json", samples::study().dump());
    Words words{"run", "s.json", "-o", "r.json"};
    for (const auto& setting : settings) words.insert(words.end(), {"--set", setting});
    folder.ordo(words);
    REQUIRE(folder.has("r.json"));
}

/// Changes one error of the report "r.json" by a factor.
inline void scale_error(const Folder& folder, double factor) {
    auto report = samples::Json::parse(folder.read("r.json"));
    auto& error = report["runs"][1]["errors"]["displacement.rms"];
    error = error.get<double>() * factor;
    folder.write("r.json", report.dump());
}

/// Writes the report "r.json" as another build would have it to "twin.json": every error off by a part in
/// 10^9, up and down in turns.
inline void make_twin(const Folder& folder) {
    auto report = samples::Json::parse(folder.read("r.json"));
    double factor = 1 - 1e-9;
    for (auto& run : report["runs"]) {
        for (auto& error : run["errors"]) error = error.get<double>() * factor;
        factor = 2 - factor;
    }
    report["provenance"]["flags"] = "-O3 -march=x86-64-v3 -ffp-contract=fast";
    folder.write("twin.json", report.dump());
}

/// Makes paths of the source folder hold in a folder where a test may write.
inline void link_studies(const Folder& folder) {
    namespace fs = std::filesystem;
    fs::create_directory_symlink(fs::path(ORDO_SOURCE_DIR) / "studies", folder.path() / "studies");
}

}  // namespace ordo::outside
