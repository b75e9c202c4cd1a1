#pragma once
// A table model as text, Markdown or LaTeX, and rows of CSV. Each escapes for its own format.
#include <string>
#include <vector>

#include "reports/table/model.hpp"
#include "reports/table/table.hpp"

namespace ordo::reports {

/// The model as text, Markdown or LaTeX, without a line of verdict where it has none. CSV is tidy instead, each table
/// its own: std::logic_error.
std::string written(const TableModel& model, TableFormat format);

/// One row of CSV after RFC 4180, with its line end.
std::string csv_row(std::vector<std::string> cells);

}  // namespace ordo::reports
