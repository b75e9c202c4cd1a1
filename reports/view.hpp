#pragma once
// What a table and a figure show: one quantity along one abscissa, and the words for it.
#include <string>
#include <vector>

#include "reports/report.hpp"

namespace ordo::reports {

/// One quantity along one abscissa. The pointers lead into the report, which must outlive the view.
struct View {
    studies::Quantity quantity;
    std::string abscissa;  ///< "h", "dt" or "1/chop_outs"
    std::string shown;     ///< the axis or counter that a reader knows the abscissa by
    std::vector<const studies::Series*> series;
};

/// All views of a report, quantity by quantity.
std::vector<View> views_of(const studies::Result& result);

/// Run with that id; std::logic_error when there is none, since a series names runs of its own result.
const studies::Run& run_of(const studies::Result& result, int id);

/// It blew up, threw, passed its time or was skipped: it has no error to show.
bool stopped(const studies::Run& run);

/// The fits of this quantity along this series.
std::vector<const studies::SeriesFit*> fits_along(const studies::Result& result, const View& view,
                                                  const studies::Series& series);

/// "RMS error of displacement", "error of the place of the shocks in density"
std::string error_words(const studies::Quantity& quantity);

/// " [m]" after `error_words`; an integral norm has its power of the length in it: " [m * m^dim]"; a
/// place is in m. "" where unknown.
std::string unit_words(const studies::Quantity& quantity);

/// "cells_alive" as "cells alive".
std::string spoken(std::string name);

/// "at t = 0.499 s", from the runs that reached their end.
std::string time_words(const studies::Result& result, const studies::Quantity& quantity);

/// `value` with so many decimals, and no minus sign before a zero.
std::string decimal(double value, int decimals);

/// "1.992 [1.98, 2.00]"; "1.992 [no interval]" for two points.
std::string order_words(const studies::OrderFit& fit);

/// Characters of UTF-8 text: its bytes without the continuing ones.
std::size_t width_of(const std::string& text);

/// The first `most` characters of UTF-8 text, and "..." where there are more.
std::string clipped(const std::string& text, std::size_t most);

}  // namespace ordo::reports
