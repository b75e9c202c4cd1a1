#pragma once
// Reports for tests, made by really running small studies: three short runs of the bar each.
#include <map>
#include <string>

#include "reports/report.hpp"
#include "studies/reader/json_input.hpp"

namespace ordo::samples {

using studies::Json;

/// A study of 4, 8 and 16 cells whose order 2 holds, as a document that a test may change.
Json study();

/// The report of that study, its runs really run; the wall times in it are made up and always the same.
reports::Report report_of(const Json& study);

/// The same with runs of one's own in place of those that were run.
reports::Report report_of(const Json& study, std::vector<studies::Run> runs);

/// A report of every kind by name: "ok", "two points", "reference", "diverged", "nan", "published", "nothing expected",
/// "two solvers".
std::map<std::string, reports::Report> reports_of_every_kind();

}  // namespace ordo::samples
