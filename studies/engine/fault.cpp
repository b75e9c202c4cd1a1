#include "studies/engine/fault.hpp"

#include <array>

namespace ordo::studies {

std::string text_of(Fault fault) {
    static const std::array names{"",
                                  "error_is_nan",
                                  "error_is_infinite",
                                  "error_is_negative",
                                  "error_is_zero",
                                  "point_missing",
                                  "point_repeated",
                                  "off_plan",
                                  "fewer_levels",
                                  "run_failed",
                                  "run_diverged",
                                  "order_too_low",
                                  "order_too_high",
                                  "order_uncertain",
                                  "pre_asymptotic",
                                  "at_floor",
                                  "stalled",
                                  "diverges",
                                  "error_too_large",
                                  "value_off",
                                  "published_differs",
                                  "expects_nothing",
                                  "no_such_series",
                                  "nothing_measured",
                                  "no_baseline",
                                  "study_differs",
                                  "runs_changed",
                                  "error_changed",
                                  "order_changed",
                                  "work_changed",
                                  "time_changed"};
    static_assert(names.size() == static_cast<std::size_t>(Fault::time_changed) + 1);
    return names.at(static_cast<std::size_t>(fault));
}

}  // namespace ordo::studies
