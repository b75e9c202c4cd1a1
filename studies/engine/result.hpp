#pragma once
// What came of a study: plain values only. Reports, tables, plots and gates are made from this and nothing else.
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "studies/engine/fault.hpp"
#include "studies/engine/study.hpp"
#include "studies/order/order_fit.hpp"

namespace ordo::studies {

/// ok; reference: it ran and others are compared with it; diverged: it blew up, which is a result;
/// failed: it threw; timed_out: it passed the study's timeout_s; skipped: coarser runs of its line decided.
enum class Status { ok, reference, diverged, failed, timed_out, skipped };
std::string text_of(Status status);

/// Where a run's figures come from: made here, kept from an earlier time, or those of an equal run.
enum class Origin { made, cached, shared };

/// One named number of a run.
struct RunFigure {
    std::string name;
    double value = 0;

    bool operator==(const RunFigure&) const = default;
};

/// Repetitions of a run that a median of times is of.
struct Repeats {
    int number = 1;
    double spread =
        std::numeric_limits<double>::quiet_NaN();  ///< median absolute deviation over the median; NaN for one
};

/// One solver at one resolution.
struct Run {
    int id = 0;
    std::string solver;           ///< label of the solver in the study
    std::vector<RunFigure> axes;  ///< as swept: cells, ppc, dt
    double h = 0;                 ///< mesh width [m]
    double dt = 0;                ///< step that was really taken [s]
    double t = 0;                 ///< time of comparison [s]
    Status status = Status::ok;
    std::string reason;             ///< why it stopped, where it did
    std::vector<RunFigure> errors;  ///< by quantity key; NaN where a run has none
    std::vector<RunFigure> drift;
    std::vector<RunFigure> work;
    std::vector<RunFigure> skipped;  ///< work that it did not have to do, and its share of the whole
    double seconds = 0;              ///< thread time of the solver, without measuring; volatile, belongs to provenance
    std::optional<Repeats> repeats = {};  ///< where `seconds` is the median of a run that was timed by itself
    Origin origin = Origin::made;         ///< likewise

    double axis(const std::string& name) const;  ///< swept value, or h, or dt (as taken); NaN when it has none
    /// The same, or what it counted, or one over either: "delta", "chop_outs", "1/ppc"; NaN when it has none.
    double at(const std::string& name) const;
    double error(const std::string& key) const;  ///< NaN when it has none
};

/// Runs that differ in the refined resolution only, coarse to fine.
struct Series {
    std::string label;      ///< "ppc = 4", "mpm usl, dt = 0.001"; "mpm" where nothing else differs
    std::string abscissa;   ///< "h", "dt" or "1/chop_outs"
    std::string shown;      ///< what a reader knows the abscissa by: "cells", "dt" or "chop_outs"
    std::vector<int> runs;  ///< ids
};

/// A run that a fit did not use, and why.
struct LeftOut {
    int run = 0;
    std::string why;
};

/// The order of one quantity along one series, over the runs that `where` admits.
struct SeriesFit {
    std::string series;
    std::string quantity;
    std::string where;
    std::vector<int> used;
    std::vector<LeftOut> left_out;
    FitOutcome outcome;
    std::string abscissa = "h";  ///< of the series
};

enum class Verdict { pass, fail, inconclusive };
std::string text_of(Verdict verdict);

/// One expectation met by one series (or run), and what was found.
struct Check {
    std::string claim;    ///< "order 2 +- 0.1 where cells <= 32"
    std::string subject;  ///< series and quantity, or the published table's id
    std::string source;
    Verdict verdict = Verdict::inconclusive;
    std::string found;          ///< "1.992 [1.98, 2.00], 4 points"
    Fault fault = Fault::none;  ///< why it does not pass
};

/// One printed value beside ours.
struct PublishedMatch {
    std::string table;  ///< id of the published table
    int run = -1;       ///< -1: no run at that place
    std::string printed;
    double ours = 0;
    std::string ours_as_printed;  ///< ours with as many digits
    bool agrees = false;
    bool judged = true;  ///< false where the study compares nothing, and says why
};

/// The answer.
struct Result {
    Study study;
    std::vector<Run> runs;
    std::vector<Series> series;
    std::vector<SeriesFit> fits;
    std::vector<Check> checks;
    std::vector<PublishedMatch> published;
    Verdict verdict = Verdict::inconclusive;
};

}  // namespace ordo::studies
