// The one table from a fault to what to look at next. The switch has no default, so that a new fault asks for its line.
#include "reports/gate/outcome.hpp"

namespace ordo::reports {

std::string advice(studies::Fault fault) {
    using enum studies::Fault;
    switch (fault) {
        case none: return "";
        case error_is_nan:
            return "run that resolution alone with 'ordo solve' and look for the first field that is not finite";
        case error_is_infinite: return "look for a division by zero or an overflow in that run with 'ordo solve'";
        case error_is_negative: return "a norm cannot be negative: look at what wrote the error";
        case error_is_zero:
            return "an exact answer has no order: expect 'exact_within', or see whether it compares with itself";
        case point_missing: return "run the study anew; where runs are made elsewhere, see which never came back";
        case point_repeated: return "see what put the run there twice: a merged report, or a value twice in the sweep";
        case off_plan:
            return "see what moved the end of that run, its mesh width or its step: the study planned another";
        case fewer_levels: return "add levels to the sweep, or see in the table why points were left out of the fit";
        case run_failed:
            return "the run's reason stands in the report's table; a larger timeout_s may be what it needs";
        case run_diverged:
            return "reduce dt or the Courant number; if blowing up is the expected answer: \"allow\": [\"diverged\"]";
        case order_too_low:
            return "look at the neighbour orders in 'ordo table' and the plot: one bad level, or all of them";
        case order_too_high:
            return "suspect the measure first: the wrong norm, too coarse levels, or another error that cancels";
        case order_uncertain:
            return "add levels, or leave out the coarse ones with 'where': the interval is wider than the band";
        case pre_asymptotic: return "refine further: the neighbour orders still change";
        case at_floor:
            return "the errors have met round-off, tolerance or the error in time: use coarser levels or a smaller dt";
        case stalled: return "the error no longer falls: look for an error that the sweep does not refine";
        case diverges: return "the error grows under refinement: look at the plot for where it turns";
        case error_too_large:
            return "compare with the table of an older report; 'ordo accept' tells what an accepted one had";
        case value_off:
            return "see in the table which runs are off; a limit moves with the scheme, the places of particles and "
                   "the ends";
        case published_differs: return "'ordo table' marks the printed values that differ with '!'";
        case expects_nothing: return "write what should come out into the study's 'expect'";
        case no_such_series: return "the expectation's 'where', 'of', 'solver' or 'against' admits no run of the sweep";
        case nothing_measured: return "the report holds no run: see whether the study ran at all";
        case no_baseline: return "make one, with the reason: ordo accept REPORT --because TEXT --into DIR";
        case study_differs: return "run the accepted study, or accept the new one with the reason why it changed";
        case runs_changed:
            return "runs came, went or end otherwise than when they were accepted: see the report's table";
        case error_changed: return "find the revision with 'ordo history'; a wanted change is accepted with its reason";
        case order_changed:
            return "look at the errors of that series first: an order changes where they, or the fit, do";
        case work_changed:
            return "the solver takes other steps than before: see what changed in it, not in its accuracy";
        case time_changed: return "repeat it on a quiet machine; faster counts too, since work may have been left out";
    }
    return "";
}

}  // namespace ordo::reports
