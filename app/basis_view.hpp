#pragma once
// What `ordo basis` shows: pictures of solvers/mpm/basis/basis_picture.hpp as columns and as a figure.
#include <string>
#include <vector>

#include "app/columns.hpp"
#include "reports/plot/panels.hpp"
#include "solvers/mpm/basis/particle_basis.hpp"

namespace ordo::app {

enum class Show { grid, interpolated, particle, reproduction, errors };

/// One basis and one state of the body.
struct Shown {
    std::string basis;
    solvers::mpm::Picture picture;
};

using Mappings = std::vector<solvers::mpm::Mapping>;

/// The rows of all pictures one after the other, under one head. Empty (NaN) where a basis has fewer nodes than
/// another, and where there is no field.
std::vector<Column> columns_of(Show show, const std::vector<Shown>& all, const Mappings& mappings);

/// A panel a picture, kind and option; a line of panels a picture. Errors are a table and have none.
reports::FunctionFigure figure_of(const std::vector<Show>& shows, const std::vector<Shown>& all,
                                  const Mappings& mappings);

}  // namespace ordo::app
