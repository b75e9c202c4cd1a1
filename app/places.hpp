#pragma once
// Where an exact solution is asked for: points from the command line or a file, and cells.
#include <string>
#include <vector>

#include "app/command.hpp"

namespace ordo::app {

struct Places {
    int dim = 1;
    std::vector<double> x;  ///< n x dim coordinates of points; or, for cells, their n + 1 edges [m]
    bool cells = false;

    std::size_t count() const { return cells ? x.size() - 1 : x.size() / static_cast<std::size_t>(dim); }
    /// Coordinate of each place along an axis; of a cell its centre.
    std::vector<double> coordinate(int axis) const;
    /// Where a place stands along a straight line of points: x in 1D, else the distance from the first one.
    std::vector<double> along() const;
};

/// The options --x, --grid, --points and --cells of `command`.
void declare_places(po::options_description& options);

/// What exactly one of these options says. Throws InputError.
Places places_from(const po::variables_map& options, int dim, const std::string& command);

/// Whether any of them is given.
bool asks_for_places(const po::variables_map& options);

/// FROM:TO:N as N numbers, both ends included. Throws InputError.
std::vector<double> line_of(const std::string& text, const std::string& where);

/// `text` as a finite number; `where` opens the message of an InputError.
double number_of(const std::string& text, const std::string& where);

}  // namespace ordo::app
