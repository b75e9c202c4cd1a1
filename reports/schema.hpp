#pragma once
// JSON Schema (draft-07) of a study, written from what scenes, solvers and oracles declare.
#include <string>

namespace ordo::reports {

/// The same text as reports/schema/study-1.json; a test holds the file to it. The schema of a report is that folder's
/// report-1.json.
std::string study_schema();

}  // namespace ordo::reports
