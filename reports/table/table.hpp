#pragma once
// Tables of errors and orders, from a report.
#include <string>

#include "reports/report.hpp"

namespace ordo::reports {

enum class TableFormat { text, markdown, latex, csv };

/// One table for each quantity: a row for each refined value, and for each series the error, the order to the row above
/// and, where the study has published values, the printed one with a mark of agreement; then fits and verdicts.
/// CSV is tidy instead: one row a run and quantity.
std::string table(const Report& report, TableFormat format);

}  // namespace ordo::reports
