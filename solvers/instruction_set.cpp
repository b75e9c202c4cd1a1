#include "solvers/instruction_set.hpp"

#include <cstdlib>
#include <string>

#include "core/error.hpp"

namespace ordo::solvers {

bool has(InstructionSet set) {
    switch (set) {
        case InstructionSet::avx512:
            return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
                   __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw");
        case InstructionSet::avx2: return __builtin_cpu_supports("avx2");
        case InstructionSet::baseline: break;
    }
    return true;
}

InstructionSet instruction_set() {
    using enum InstructionSet;
    const char* word = std::getenv("ORDO_SIMD");
    if (word == nullptr) return has(avx512) ? avx512 : has(avx2) ? avx2 : baseline;
    const std::string name = word;
    const InstructionSet set = name == "avx512" ? avx512 : name == "avx2" ? avx2 : baseline;
    if (set == baseline && name != "baseline")
        throw InputError("ORDO_SIMD", "'" + name + "' is no set of instructions (there are baseline, avx2, avx512)");
    if (!has(set)) throw InputError("ORDO_SIMD", "this machine has no " + name + " (nearest: baseline)");
    return set;
}

}  // namespace ordo::solvers
