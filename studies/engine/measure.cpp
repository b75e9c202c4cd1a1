#include "studies/engine/measure.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "oracles/features.hpp"
#include "studies/engine/cell_errors.hpp"
#include "studies/engine/cell_parts.hpp"
#include "studies/engine/norm.hpp"
#include "studies/engine/wave_places.hpp"

namespace ordo::studies {
namespace {

const std::vector<double>& weights_of(const Quantity& quantity, const solvers::Snapshot& shot) {
    if (!quantity.undeformed) return shot.weights;
    if (shot.weights_undeformed.empty()) throw std::logic_error("the solver knows no undeformed body");
    return shot.weights_undeformed;
}

std::size_t offset_of(const oracles::Exact& exact, const std::string& field) {
    const auto offset = exact.offset(field);
    if (!offset) throw std::logic_error("the exact solution has no field '" + field + "'");
    return *offset;
}

/// A snapshot against the exact solution at its points.
class AtPoints {
public:
    AtPoints(const solvers::Snapshot& shot, const oracles::Exact& exact)
        : shot_(shot), exact_(exact), rows_(shot.points() * exact.width()) {
        exact.sample(positions(), shot.t, rows_);
    }

    double error(const Quantity& quantity) const {
        const Field& found = shot_.field(quantity.field);
        std::vector<double> values;
        values.reserve(found.values.size());
        const std::size_t width = exact_.width();
        for (std::size_t row = offset_of(exact_, quantity.field); row < rows_.size(); row += width) {
            const auto begin = rows_.begin() + static_cast<std::ptrdiff_t>(row);
            values.insert(values.end(), begin, begin + found.components);
        }
        if (!is_part(quantity.norm))
            return error_norm(quantity.norm, found.values, values, weights_of(quantity, shot_), found.components);
        return error_norm(Norm::l1, found.values, values, weights_of_part(quantity), found.components);
    }

private:
    const std::vector<double>& positions() const {
        return exact_.coordinates == oracles::Coordinates::material ? shot_.X : shot_.x;
    }

    /// 0 for the points of the other part.
    std::vector<double> weights_of_part(const Quantity& quantity) const {
        const auto places = oracles::places_of_features(exact_, shot_.t);
        auto weights = weights_of(quantity, shot_);
        for (std::size_t i = 0; i < weights.size(); ++i) {
            const bool near = is_near(positions()[i], places, quantity.near);
            if (near != (quantity.norm == Norm::l1_near)) weights[i] = 0;
        }
        return weights;
    }

    const solvers::Snapshot& shot_;
    const oracles::Exact& exact_;
    std::vector<double> rows_;  ///< points x exact.width()
};

/// A field of a snapshot of cells, beside the exact solution.
CellField cell_field(const Field& means, const solvers::Snapshot& shot, const oracles::Exact& exact) {
    const std::size_t cells = shot.points();
    CellField field{{shot.edges, means.values}, offset_of(exact, means.name)};
    const auto rises = std::ranges::find(shot.slopes, means.name, &Field::name);
    if (rises != shot.slopes.end()) field.found.rises = rises->values;
    const bool one_each = means.components == 1 && means.values.size() == cells && shot.edges.size() == cells + 1 &&
                          (field.found.rises.empty() || field.found.rises.size() == cells);
    if (!one_each || cells == 0) throw std::logic_error("the field '" + means.name + "' is no scalar on cells");
    return field;
}

/// A snapshot of cells against the exact solution all over them.
class OverCells {
public:
    OverCells(const solvers::Snapshot& shot, const oracles::Exact& exact, double near) : shot_(shot), exact_(exact) {
        for (const auto& means : shot.fields) fields_.push_back(cell_field(means, shot, exact));
        errors_ = cell_errors(fields_, exact, shot.t, near);
    }

    double error(const Quantity& quantity) const {
        const auto found = std::ranges::find(shot_.fields, quantity.field, &Field::name);
        const auto k = static_cast<std::size_t>(found - shot_.fields.begin());
        switch (quantity.norm) {
            case Norm::l1: return errors_.at(k).l1;
            case Norm::l2: return errors_.at(k).l2;
            case Norm::l1_fans: return errors_.at(k).l1_fans;
            case Norm::l1_near: return errors_.at(k).l1_near;
            case Norm::l1_away: return errors_.at(k).l1_away;
            default: break;
        }
        const auto& [profile, offset] = fields_.at(k);
        return place_error(profile, marks_of(quantity.norm, exact_, offset, shot_.t));
    }

private:
    const solvers::Snapshot& shot_;
    const oracles::Exact& exact_;
    std::vector<CellField> fields_;  ///< in the order of the snapshot's
    std::vector<CellErrors> errors_;
};

/// rms and linf are taken at points, the middles of cells too; the other norms over cells where there are any.
bool is_over_cells(Norm norm, const solvers::Snapshot& shot) {
    if (is_about_waves(norm)) return true;
    return !shot.edges.empty() && (norm == Norm::l1 || norm == Norm::l2 || is_part(norm));
}

/// Norm of the field itself, at the points.
double norm_of(const Quantity& quantity, const solvers::Snapshot& shot) {
    const Field& found = shot.field(quantity.field);
    const std::vector<double> zero(found.values.size());
    return error_norm(quantity.norm, found.values, zero, weights_of(quantity, shot), found.components);
}

}  // namespace

std::vector<RunFigure> errors_against_exact(const std::vector<Quantity>& quantities, const solvers::Snapshot& shot,
                                            const oracles::Exact& exact) {
    std::vector<RunFigure> errors;
    std::optional<AtPoints> points;
    std::optional<OverCells> cells;
    double near = 0;
    for (const auto& quantity : quantities) near = std::max(near, quantity.near);
    for (const auto& quantity : quantities) {
        if (quantity.against == Against::finest) continue;
        if (quantity.against == Against::itself) {
            errors.push_back({quantity.key(), norm_of(quantity, shot)});
            continue;
        }
        if (is_over_cells(quantity.norm, shot)) {
            if (!cells) cells.emplace(shot, exact, near);
            errors.push_back({quantity.key(), cells->error(quantity)});
        } else {
            if (!points) points.emplace(shot, exact);
            errors.push_back({quantity.key(), points->error(quantity)});
        }
    }
    return errors;
}

double error_against(const Quantity& quantity, const solvers::Snapshot& shot, const solvers::Snapshot& reference) {
    const Field& found = shot.field(quantity.field);
    const Field& best = reference.field(quantity.field);
    return error_norm(quantity.norm, found.values, best.values, weights_of(quantity, reference), found.components);
}

}  // namespace ordo::studies
