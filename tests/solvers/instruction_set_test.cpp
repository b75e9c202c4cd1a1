// The loops of a run made of other instructions give the same bits.
#include "tests/app/process.hpp"
#include "tests/catch.hpp"

using namespace ordo;
using outside::Folder;
using outside::Words;

namespace {

/// A run of the fixed grid, 17 digits a number.
outside::Outcome solved(const std::string& scene, const std::string& order, const std::string& set) {
    const Folder folder;
    auto setting = folder.here();
    setting.environment.emplace_back("ORDO_SIMD", set);
    return outside::run(outside::command({"solve", scene, "--solver", "godunov", "--t", "0.3", "--set",
                                          "resolution.cells=203", "--set", "solver.order=" + order}),
                        setting);
}

}  // namespace

TEST_CASE("cli: the bits of a run are the same with each set of instructions", "[cli]") {
    const auto scene = GENERATE(std::string("gas_riemann"), std::string("nonlinear_elastic_riemann"));
    const auto order = GENERATE(std::string("first"), std::string("second"));
    const auto baseline = solved(scene, order, "baseline");
    REQUIRE(baseline.code == 0);
    CHECK(baseline.out.size() > 10'000);
    if (__builtin_cpu_supports("avx2")) CHECK(solved(scene, order, "avx2").out == baseline.out);
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq"))
        CHECK(solved(scene, order, "avx512").out == baseline.out);
}

TEST_CASE("cli: an unknown set of instructions is refused with those there are", "[cli]") {
    const auto outcome = solved("gas_riemann", "second", "sse9");
    CHECK(outcome.code == 2);
    CHECK(outcome.err.find("'sse9' is no set of instructions (there are baseline, avx2, avx512)") != std::string::npos);
}
