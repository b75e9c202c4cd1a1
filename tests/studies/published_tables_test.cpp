// Published tables beyond A1 and B1, through the whole engine; fine meshes are left to `ordo run`.
#include <string>
#include <vector>

#include "studies/engine/engine.hpp"
#include "studies/engine/judge.hpp"
#include "studies/reader/study_reader.hpp"
#include "tests/catch.hpp"

using namespace ordo::studies;

namespace {

Result run_study(const std::string& name, const std::vector<std::string>& changes) {
    std::vector<Setting> settings;
    for (const auto& change : changes) settings.push_back(setting_from(change));
    const Study study = read_study(std::string(ORDO_SOURCE_DIR) + "/studies/" + name + ".json", settings);
    return judged(study, run_all(study, {.jobs = 2, .progress = {}}));
}

int agreeing(const Result& result) {
    int count = 0;
    for (const auto& match : result.published) count += match.agrees;
    return count;
}

}  // namespace

TEST_CASE("published tables: whole studies pass, every value met", "[published]") {
    const auto [study, values] = GENERATE(table<std::string, int>({
        {"wobbes_tielen_2015/oedometer", 30},
        {"wobbes_tielen_2015/oedometer_log_law", 10},
        {"wobbes_tielen_2015/oedometer_half_kick", 3},
        {"wobbes_tielen_2015/oedometer_consistent_law", 3},
        {"wobbes_tielen_2015/vibrating_bar_fem", 6},
        {"bspline_baselines/vibrating_bar_fixed", 24},
        {"bspline_baselines/bar_mms_small", 36},
        {"bspline_baselines/bar_mms_large", 54},
        {"bspline_baselines/gauss_total_p1", 6},
        {"bspline_baselines/gauss_total_p2", 6},
        {"bspline_baselines/gauss_total_p3", 6},
        {"bspline_baselines/gauss_total_p4", 6},
    }));
    INFO(study);
    const Result result = run_study(study, {});
    CHECK(agreeing(result) == values);
    CHECK(result.published.size() == static_cast<std::size_t>(values));
    CHECK(result.verdict == Verdict::pass);
}

TEST_CASE("published tables: seven digits up to 64 cells of the longer ones", "[published]") {
    const auto [study, values] = GENERATE(table<std::string, int>({
        {"nguyen_2023/mpm_without_body_force_small", 6},
        {"nguyen_2023/mpm_without_body_force_large", 6},
        {"nguyen_2023/mpm_large", 24},
        {"nguyen_2023/mpm_small", 3},
        {"nguyen_2023/tlmpm_small", 6},
        {"nguyen_2023/tlmpm_large", 6},
        {"nguyen_2023/impm_small", 6},
        {"nguyen_2023/impm_large", 6},
    }));
    INFO(study);
    CHECK(agreeing(run_study(study, {"sweep.cells=2,4,8,16,32,64"})) == values);
}

TEST_CASE("published tables: studies without printed digits keep their orders", "[convergence]") {
    const auto study =
        GENERATE(as<std::string>{}, "wobbes_tielen_2015/bar_traction", "wobbes_tielen_2015/oedometer_fem",
                 "wobbes_tielen_2015/oedometer_fem_fine", "wobbes_tielen_2015/bar_traction_mass_defect",
                 "capabilities/uniform_strain", "capabilities/free_flight_3d", "records/oedometer_static");
    INFO(study);
    CHECK(run_study(study, {}).verdict == Verdict::pass);
}

TEST_CASE("published tables: their digits hang on every choice that the studies name", "[alarm]") {
    const auto [study, cells, setting] = GENERATE(table<std::string, std::string, std::string>({
        {"nguyen_2023/tlmpm_large", "4,8,16", "solvers.0.frame=updated"},
        {"nguyen_2023/tlmpm_large", "4,8,16", "solvers.0.position_update=remapped"},
        {"nguyen_2023/tlmpm_large", "4,8,16", "solvers.0.body_force=particles"},
        {"nguyen_2023/mpm_without_body_force_large", "4,8,16", "solvers.0.body_force=particles"},
        {"nguyen_2023/mpm_without_body_force_large", "4,8,16", "solvers.0.stress_update=musl"},
        {"nguyen_2023/impm_large", "4,8,16", "solvers.0.reconstruction=none"},
        {"nguyen_2023/impm_large", "4,8,16", "solvers.0.body_force=nodes"},
        {"bspline_baselines/gauss_total_p2", "4,8,16", "solvers.0.mass=lumped"},
        {"bspline_baselines/gauss_total_p2", "4,8,16", "solvers.0.placement=cell_centred"},
        {"bspline_baselines/gauss_total_p2", "4,8,16", "solvers.0.time=leapfrog"},
        {"bspline_baselines/gauss_total_p2", "4,8,16", "solvers.0.basis=cubic"},
        {"wobbes_tielen_2015/oedometer", "16,24,32", "scene.terms=8"},
        {"wobbes_tielen_2015/oedometer", "16,24,32", "scene.g=9.8"},
        {"wobbes_tielen_2015/oedometer", "16,24,32", "solvers.0.time=leapfrog"},
        {"wobbes_tielen_2015/oedometer", "16,24,32", "solvers.0.volume=fixed"},
    }));
    CAPTURE(study, setting);
    const Result result = run_study(study, {"sweep.cells=" + cells, setting});
    CHECK(agreeing(result) <= 2);  // of 3, or of 9
    CHECK(result.verdict == Verdict::fail);
}

TEST_CASE("published tables: a printed quantity that is not measured is refused", "[alarm]") {
    CHECK_THROWS_WITH(run_study("nguyen_2023/tlmpm_large", {"measure.over=final"}),
                      ContainsSubstring("displacement.l2.undeformed"));
}
