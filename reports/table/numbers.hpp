#pragma once
// The table of a study whose runs give numbers and no errors: a row a run.
#include "reports/table/model.hpp"

namespace ordo::reports {

/// Swept values, numbers with the printed ones beside them, and what a run says of itself in the notes.
Table number_table(const studies::Result& result);

/// Whether all that the study measures is numbers.
bool gives_numbers(const studies::Study& study);

}  // namespace ordo::reports
