#pragma once
// What can be wrong with an answer, by name: gates, CI output and the mutation suite speak of faults by these names.
#include <string>

namespace ordo::studies {

enum class Fault {
    none,
    error_is_nan,
    error_is_infinite,
    error_is_negative,
    error_is_zero,   ///< in an order fit, or under error_at_most: exactness is an expectation of its own
    point_missing,   ///< a planned run is not there
    point_repeated,  ///< a run is there twice, or without being planned
    off_plan,        ///< a run was compared at another time, mesh width or step than planned
    fewer_levels,    ///< an order from fewer levels than were asked for
    run_failed,      ///< threw, or passed its time
    run_diverged,    ///< blew up, and the study does not allow it
    order_too_low,
    order_too_high,   ///< unless the expectation declares that it may be
    order_uncertain,  ///< the interval is neither inside the band nor outside
    pre_asymptotic,
    at_floor,
    stalled,
    diverges,
    error_too_large,
    value_off,  ///< a number that is no error is outside its band
    published_differs,
    expects_nothing,   ///< the study holds its runs to nothing
    no_such_series,    ///< an expectation that no series can show
    nothing_measured,  ///< no run at all
    no_baseline,
    study_differs,  ///< the baseline answers another question
    runs_changed,
    error_changed,
    order_changed,
    work_changed,
    time_changed,
};

/// "error_is_nan"; "" for none.
std::string text_of(Fault fault);

}  // namespace ordo::studies
