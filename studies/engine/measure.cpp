#include "studies/engine/measure.hpp"

#include <algorithm>
#include <stdexcept>

#include "studies/engine/norm.hpp"

namespace ordo::studies {
namespace {

/// The exact solution's fields at the snapshot's points.
struct ExactValues {
    const oracles::Exact& exact;
    std::vector<double> rows;  ///< points x exact.width()

    ExactValues(const oracles::Exact& truth, const solvers::Snapshot& shot)
        : exact(truth), rows(shot.points() * truth.width()) {
        exact.sample(exact.coordinates == oracles::Coordinates::material ? shot.X : shot.x, shot.t, rows);
    }

    std::vector<double> field(const std::string& name, int components) const {
        const auto offset = exact.offset(name);
        if (!offset) throw std::logic_error("the exact solution has no field '" + name + "'");
        std::vector<double> values;
        for (std::size_t row = *offset; row < rows.size(); row += exact.width()) {
            const auto begin = rows.begin() + static_cast<std::ptrdiff_t>(row);
            values.insert(values.end(), begin, begin + components);
        }
        return values;
    }
};

const std::vector<double>& weights_of(const Quantity& quantity, const solvers::Snapshot& shot) {
    if (!quantity.undeformed) return shot.weights;
    if (shot.weights_undeformed.empty()) throw std::logic_error("the solver knows no undeformed body");
    return shot.weights_undeformed;
}

}  // namespace

std::vector<RunFigure> errors_against_exact(const std::vector<Quantity>& quantities, const solvers::Snapshot& shot,
                                            const oracles::Exact& exact) {
    std::vector<RunFigure> errors;
    if (std::ranges::none_of(quantities, [](const Quantity& q) { return q.against == Against::exact; })) return errors;
    const ExactValues truth(exact, shot);
    for (const auto& quantity : quantities) {
        if (quantity.against != Against::exact) continue;
        const Field& found = shot.field(quantity.field);
        const auto values = truth.field(quantity.field, found.components);
        errors.push_back({quantity.key(), error_norm(quantity.norm, found.values, values, weights_of(quantity, shot),
                                                     found.components)});
    }
    return errors;
}

double error_against(const Quantity& quantity, const solvers::Snapshot& shot, const solvers::Snapshot& reference) {
    const Field& found = shot.field(quantity.field);
    const Field& best = reference.field(quantity.field);
    return error_norm(quantity.norm, found.values, best.values, weights_of(quantity, reference), found.components);
}

}  // namespace ordo::studies
