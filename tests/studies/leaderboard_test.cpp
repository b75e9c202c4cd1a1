// The leaderboard compares like with like.
#include <filesystem>
#include <map>

#include "studies/reader/json_input.hpp"
#include "studies/reader/study_reader.hpp"
#include "tests/catch.hpp"

using namespace ordo;
using namespace ordo::studies;

TEST_CASE("leaderboard: one label is one method, in all of its studies", "[unit]") {
    std::map<std::string, std::string> seen;
    int count = 0;
    for (const auto& file : std::filesystem::directory_iterator(ORDO_SOURCE_DIR "/studies/leaderboard")) {
        if (file.path().extension() != ".json") continue;
        ++count;
        const Study study = read_study(file.path().string(), {});
        CHECK(study.timeout_s);
        CHECK(study.diverged_allowed);
        CHECK(study.time_out_allowed);
        CHECK(study.measure.quantities.size() == 1);
        const Json document = Json::parse(study.document);
        for (const auto& solver : document.at("solvers")) {
            INFO(file.path() << ": " << solver);
            const auto [known, fresh] = seen.emplace(solver.at("label"), solver.dump());
            CHECK(known->second == solver.dump());
        }
    }
    CHECK(count == 9);
    CHECK(seen.size() == 16);
}
