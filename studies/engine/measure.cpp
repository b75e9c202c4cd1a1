#include "studies/engine/measure.hpp"

#include <stdexcept>

#include "studies/engine/norm.hpp"

namespace ordo::studies {
namespace {

std::vector<double> exact_values(const oracles::Exact::Entry& entry, const solvers::Snapshot& shot,
                                 oracles::Coordinates coordinates, int components) {
    const auto dim = static_cast<std::size_t>(shot.dim);
    const auto width = static_cast<std::size_t>(components);
    const std::span<const double> points(coordinates == oracles::Coordinates::material ? shot.X : shot.x);
    std::vector<double> values(shot.points() * width);
    for (std::size_t i = 0; i < shot.points(); ++i) {
        entry.evaluate(points.subspan(i * dim, dim), shot.t, std::span(values).subspan(i * width, width));
    }
    return values;
}

}  // namespace

std::vector<RunFigure> errors_against_exact(const std::vector<Quantity>& quantities, const solvers::Snapshot& shot,
                                            const oracles::Exact& exact) {
    std::vector<RunFigure> errors;
    for (const auto& quantity : quantities) {
        if (quantity.against != Against::exact) continue;
        const Field& found = shot.field(quantity.field);
        const auto* entry = exact.find(quantity.field);
        if (entry == nullptr) throw std::logic_error("the exact solution has no field '" + quantity.field + "'");
        const auto values = exact_values(*entry, shot, exact.coordinates, found.components);
        errors.push_back(
            {quantity.key(), error_norm(quantity.norm, found.values, values, shot.weights, found.components)});
    }
    return errors;
}

double error_against(const Quantity& quantity, const solvers::Snapshot& shot, const solvers::Snapshot& reference) {
    const Field& found = shot.field(quantity.field);
    const Field& best = reference.field(quantity.field);
    return error_norm(quantity.norm, found.values, best.values, reference.weights, found.components);
}

}  // namespace ordo::studies
