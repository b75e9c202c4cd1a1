#pragma once
// The fields of a line by name, for every solver that keeps contents.
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "solvers/media/medium.hpp"
#include "solvers/solver.hpp"

namespace ordo::solvers {

/// What a gas or an elastic line can be asked for; energy is internal and a unit of mass, the others as conventions.
enum class LineField {
    density,       ///< rho [kg/m]
    velocity,      ///< v [m/s]
    pressure,      ///< p, of a gas [Pa]
    stress,        ///< -p, of an elastic line [Pa]
    strain,        ///< rho0 / rho - 1, of an elastic line [-]
    temperature,   ///< T, of an elastic line [K]
    energy,        ///< internal [J/kg]
    momentum,      ///< rho v [kg/s]
    total_energy,  ///< kinetic and internal [J/m]
};

/// Their names, in the order of the enumerators.
const std::vector<std::string>& line_field_names();

/// The names that a line's medium has; throws std::logic_error where the scene is no line.
std::vector<std::string> line_fields_in(const Scene& scene);

/// The fields of those names. Throws InputError for a name that is none, or that the medium does not have.
std::vector<LineField> line_fields(const Medium& medium, std::span<const std::string> names);

/// The value of a field where a unit of length holds q > 0 and flows as f; f = medium.flow(q).
template <class M>
double value_of(const M& medium, LineField field, const Contents& q, const Flow& f) {
    switch (field) {
        case LineField::density: return q.mass;
        case LineField::velocity: return f.v;
        case LineField::pressure: return f.p;
        case LineField::stress: return -f.p;
        case LineField::temperature: return f.T;
        case LineField::energy: return (q.energy - 0.5 * q.momentum * f.v) / q.mass;
        case LineField::momentum: return q.momentum;
        case LineField::total_energy: return q.energy;
        case LineField::strain: break;
    }
    if constexpr (M::has_temperature) return medium.rho0 / q.mass - 1;
    else return 0;
}

/// `values` of the named field in n cells with mean contents cell(i).
template <class Cell>
Field field_of_cells(const Medium& medium, LineField field, std::size_t n, Cell cell) {
    Field found{line_field_names()[static_cast<std::size_t>(field)], 1, std::vector<double>(n)};
    std::visit(
        [&](const auto& kind) {
            for (std::size_t i = 0; i < n; ++i) {
                const Contents q = cell(i);
                found.values[i] = value_of(kind, field, q, kind.flow(q));
            }
        },
        medium);
    return found;
}

/// Cells side by side between n + 1 rising edges, with mean contents mean(i), as a snapshot of uniform cells.
template <class Mean>
Snapshot snapshot_of_cells(double t, std::vector<double> edges, const Medium& medium, std::span<const LineField> fields,
                           Mean mean) {
    const std::size_t n = edges.size() - 1;
    Snapshot shot{.t = t, .dim = 1, .X = {}, .x = {}, .weights = {}, .fields = {}};
    for (std::size_t i = 0; i < n; ++i) {
        shot.x.push_back(0.5 * (edges[i] + edges[i + 1]));
        shot.weights.push_back(edges[i + 1] - edges[i]);
    }
    shot.X = shot.x;
    shot.edges = std::move(edges);
    for (const LineField field : fields) shot.fields.push_back(field_of_cells(medium, field, n, mean));
    return shot;
}

/// Rises of fields from the left to the right end of n cells, whose contents there are left(i) and right(i).
template <class Left, class Right>
std::vector<Field> rises_over_cells(const Medium& medium, std::span<const LineField> fields, std::size_t n, Left left,
                                    Right right) {
    std::vector<Field> rises;
    for (const LineField field : fields) {
        const Field from = field_of_cells(medium, field, n, left);
        rises.push_back(field_of_cells(medium, field, n, right));
        for (std::size_t i = 0; i < n; ++i) rises.back().values[i] -= from.values[i];
    }
    return rises;
}

}  // namespace ordo::solvers
