// One kernel an instruction set, the same bits with each.
#include "solvers/mpm/fast/instruction_sets.hpp"

#include <cstdlib>
#include <map>

#include "solvers/instruction_set.hpp"
#include "tests/solvers/mpm/fast/twins.hpp"

using namespace ordo;
using namespace ordo::solvers;
using namespace ordo::solvers::mpm;
using namespace ordo::solvers::mpm::test;

TEMPLATE_TEST_CASE_SIG("fast: the same bits with each set of instructions", "[property]", ((int dim), dim), 1, 2, 3) {
    std::vector<std::string> sets{"baseline"};
    if (has(InstructionSet::avx2)) sets.emplace_back("avx2");
    if (has(InstructionSet::avx512)) sets.emplace_back("avx512");
    for (const auto& scheme : schemes) {
        for (const std::string basis : {"linear", "quadratic"}) {
            INFO(name_of(scheme) << basis);
            Given options = scheme;
            options["basis"] = basis;
            options["margin"] = 1.0;
            std::map<std::string, std::vector<double>> bits;
            for (const auto& set : sets) {
                setenv("ORDO_SIMD", set.c_str(), 1);
                bits[set] = numbers(run(loaded<dim>(thrown<dim>(0.3, laws[0]), false), options, "fast", small, 0.06));
            }
            unsetenv("ORDO_SIMD");
            CHECK(bits["baseline"].size() > 4);
            for (const auto& set : sets) CHECK(bits[set] == bits["baseline"]);
        }
    }
}

TEST_CASE("fast: the same bits where many particles cross in a step", "[property]") {
    const auto flying = [](const Vec<2>& X, double) {
        return Vec<2>(9 + std::sin(40 * X[1]), 5 - std::cos(30 * X[0]));
    };
    const auto scene = box<2>(Vec<2>::Ones(), Face::free, pointwise<2>(flying));
    std::map<std::string, std::vector<double>> bits;
    for (const std::string set : {"baseline", "avx2", "avx512"}) {
        if (set == "avx2" && !has(InstructionSet::avx2)) continue;
        if (set == "avx512" && !has(InstructionSet::avx512)) continue;
        setenv("ORDO_SIMD", set.c_str(), 1);
        const Given options{{"stress_update", "musl"}, {"margin", 1.5}};
        const Ended ended = run(scene, options, "fast", {{"cells", 12.0}, {"ppc", 3.0}, {"dt", 0.005}}, 0.03);
        CHECK(figure(ended.work, "cell_crossings") > 500);
        bits[set] = numbers(ended);
        CHECK(bits[set].size() > 4);
        CHECK(bits[set] == bits["baseline"]);
    }
    unsetenv("ORDO_SIMD");
}

TEST_CASE("fast: an unknown set of instructions is refused", "[unit]") {
    setenv("ORDO_SIMD", "sse9", 1);
    CHECK_THROWS_WITH(instruction_set(), ContainsSubstring("sse9") && ContainsSubstring("avx2"));
    unsetenv("ORDO_SIMD");
    CHECK_NOTHROW(instruction_set());
}
