#pragma once
// A report: the answer with where it came from. Everything shown or gated is made from it.
#include <limits>
#include <string>
#include <vector>

#include "reports/files.hpp"
#include "studies/engine/result.hpp"

namespace ordo::reports {

/// Facts that change from machine to machine or from hour to hour; no host, user or path among them.
struct Provenance {
    std::string time_utc;
    std::string ordo_version;
    std::string revision;  ///< of the sources, "-dirty" where they were changed; "unknown" outside a checkout
    std::string compiler;
    std::string flags;
    std::string build_type;
    std::vector<std::string> libraries;  ///< "Boost 1.74", "Eigen 3.4.0", ...
    std::string cpu;
    int cores = 0;
    std::string os;
    int jobs = 0;
    double seconds = 0;  ///< wall time of all runs together [s]
    /// Time of the reference kernel [s], the smaller of before and after the runs; NaN where it was not measured.
    double kernel_seconds = std::numeric_limits<double>::quiet_NaN();
};

struct Report {
    studies::Result result;
    Provenance provenance;
};

inline constexpr const char* report_schema = "ordo-report-1";

/// Provenance of this program on this machine, now.
Provenance provenance_here(int jobs, double seconds);

/// JSON text with stable key order; round-trips every finite number, NaN and infinities as null beside a status.
std::string to_json(const Report& report);

/// The report of that text. Fits and verdicts are made again from its runs and its study, never read.
/// Throws InputError on anything that is not a report of this schema.
Report report_from_json(const std::string& text, const std::string& where);

/// The report in that file. Throws InputError as above.
Report read_report(const std::string& path);

}  // namespace ordo::reports
