#pragma once
// A user's own table of numbers: CSV or columns apart by blanks, with a head line of names or without.
#include <string>
#include <vector>

namespace ordo::app {

struct NumberTable {
    std::vector<std::string> names;  ///< empty where the table has no head
    std::vector<std::vector<double>> rows;

    /// The column of that name, or, in a table without a head, the one at `place`. Throws InputError with the nearest.
    std::vector<double> column(const std::string& name, std::size_t place, const std::string& where) const;
    bool has(const std::string& name) const;
    std::size_t columns() const;
};

/// Lines that are empty or begin with '#' are skipped. Cells are separated by commas where the line has one, else by
/// blanks; quotes around one are dropped. The first line is a head if none of its cells is a number. "nan" and "inf"
/// are numbers: what they mean is for the fit to say. Throws InputError, with the line, on a cell that is no number, a
/// row of another length, and a table without rows.
NumberTable number_table(const std::string& text, const std::string& where);

}  // namespace ordo::app
