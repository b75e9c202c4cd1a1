#include "studies/engine/study.hpp"

#include "core/text.hpp"
#include "solvers/solver.hpp"

namespace ordo::studies {

std::string text_of(Norm norm) {
    switch (norm) {
        case Norm::rms: return "rms";
        case Norm::l1: return "l1";
        case Norm::l2: return "l2";
        case Norm::linf: break;
    }
    return "linf";
}

std::string text_of(Path path) {
    switch (path) {
        case Path::space: return "space";
        case Path::time: return "time";
        case Path::joint: return "joint";
        case Path::grid: break;
    }
    return "grid";
}

std::string text_of(Until until) {
    return until == Until::exact ? "exact" : until == Until::accumulated ? "accumulated" : "steps";
}

std::string text_of(Compare compare) {
    return compare == Compare::digits ? "digits" : compare == Compare::band ? "band" : "none";
}

std::string Quantity::key() const {
    return field + "." + text_of(norm) + (undeformed ? ".undeformed" : "") + (maximum ? ".max" : "") +
           (against == Against::finest ? "@finest" : "");
}

bool Condition::holds(double found) const {
    if (op == "<") return found < value;
    if (op == "<=") return found <= value;
    if (op == "=") return found == value;
    if (op == ">=") return found >= value;
    return found > value;
}

std::string text_of(const std::vector<Condition>& where) {
    std::vector<std::string> parts;
    for (const auto& condition : where)
        parts.push_back(condition.axis + " " + condition.op + " " + shortest(condition.value));
    return joined(parts);
}

std::string width_axis(const std::vector<SolverChoice>& solvers) {
    return solvers.empty() ? "" : solvers::solver_named(solvers.front().name, "").width_axis;
}

}  // namespace ordo::studies
