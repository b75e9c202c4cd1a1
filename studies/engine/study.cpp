#include "studies/engine/study.hpp"

#include <fmt/format.h>

#include "core/text.hpp"
#include "solvers/solver.hpp"

namespace ordo::studies {

const std::vector<std::string>& norm_names() {
    static const std::vector<std::string> names{"rms",   "l1",      "l2",       "linf",    "l1_fans",
                                                "shock", "contact", "fan_edge", "l1_near", "l1_away"};
    return names;
}

std::string text_of(Norm norm) { return is_value(norm) ? "value" : norm_names().at(static_cast<std::size_t>(norm)); }

bool is_part(Norm norm) { return norm == Norm::l1_near || norm == Norm::l1_away; }

bool is_about_waves(Norm norm) { return norm == Norm::l1_fans || is_place(norm); }

bool is_value(Norm norm) { return norm == Norm::value; }

bool is_place(Norm norm) { return norm == Norm::shock || norm == Norm::contact || norm == Norm::fan_edge; }

std::string text_of_order(const Expectation& expectation) {
    const bool expected = !expectation.theory.empty();
    const std::string order =
        expected ? fmt::format("expected order {:.3g}", expectation.value) : fmt::format("order {}", expectation.value);
    return order + fmt::format(" +- {}", expectation.within) + (expected ? " (" + expectation.theory + ")" : "");
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
    if (is_value(norm)) return field;
    return field + "." + text_of(norm) + (undeformed ? ".undeformed" : "") + (maximum ? ".max" : "") +
           (against == Against::finest   ? "@finest"
            : against == Against::itself ? "@itself"
                                         : "");
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

std::string width_axis(const SolverChoice& solver) { return solvers::solver_named(solver.name, "").width_axis; }

std::vector<std::string> own_abscissae(Path path) {
    switch (path) {
        case Path::space:
        case Path::joint: return {"h"};
        case Path::time: return {"dt"};
        case Path::grid: break;
    }
    return {"h", "dt"};
}

std::string counter_of(const std::string& abscissa) { return abscissa.starts_with("1/") ? abscissa.substr(2) : ""; }

}  // namespace ordo::studies
