#pragma once
// Columns of numbers with 17 digits and of names, as CSV or JSON.
#include <string>
#include <vector>

namespace ordo::app {

struct Column {
    std::string name;
    std::vector<double> values;
    std::vector<std::string> words = {};  ///< in place of values: names of letters, digits and _
};

/// "csv": a head line of names, then one line a row, empty where there is no value (NaN); "json": an array of objects,
/// NaN and infinities as null. Throws InputError with the nearest format on any other word.
std::string columns_as(const std::string& format, const std::vector<Column>& columns, const std::string& where);

/// Names of the components of a field in dim dimensions: "stress" in 1D, "stress_xx", "stress_xy", ... in 2D.
std::vector<std::string> component_names(const std::string& field, int components, int dim);

}  // namespace ordo::app
