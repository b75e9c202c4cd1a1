#pragma once
// One finished run as a file of the cache.
#include <string>

#include "studies/engine/result.hpp"

namespace ordo::reports {

/// What the run follows from (as JSON: the build, and the run's description), and its figures.
struct KeptRun {
    std::string build;
    std::string description;
    studies::Run run;  ///< status, reason, figures and seconds; the rest is the asker's
};

/// JSON text in which every number, infinities and NaN too, reads back as the same double.
std::string text_of(const KeptRun& entry);

/// The entry of that text. Throws InputError on anything else.
KeptRun kept_run_from(const std::string& text, const std::string& where);

}  // namespace ordo::reports
