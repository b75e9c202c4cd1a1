#pragma once
// A study: the question, as plain data. study_reader.hpp makes one from a file.
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/parameter.hpp"

namespace ordo::studies {

/// A scene by name, with all its values.
struct SceneChoice {
    std::string name;
    Values values;
};

/// A solver by name, with all its options. `label` tells it from the study's other solvers: "mpm usl".
struct SolverChoice {
    std::string name;
    Values options;
    std::string label;
};

/// One swept number: cells, ppc, dt, courant or whatever the solvers declare as resolution.
struct Axis {
    std::string name;
    std::vector<double> values;
};

/// Along which line the resolution is refined: h alone, dt alone, both together, or every pair of them.
enum class Path { space, time, joint, grid };

struct Sweep {
    std::vector<Axis> axes;
    Path path = Path::space;
};

/// How the end is reached: exactly at t; where t += dt first reaches it, as many papers loop; or after n steps of dt.
enum class Until { exact, accumulated, steps };
/// What an error is measured against: the exact solution, or the run with the smallest dt of the same series. Against
/// itself: no error but the norm of the field found, which is extrapolated, as where there is no exact solution.
enum class Against { exact, finest, itself };
/// Over points, or over cells where a snapshot has them: rms to linf. Where the waves of a line are off their places:
/// shock, contact, fan_edge. l1_fans is l1 over the middle half of every fan, away from its corners; l1_near and
/// l1_away are the parts of l1 near the waves, points or cells alike, and away from them. value: no error but a number
/// that has a name of its own, which a run may lack.
enum class Norm { rms, l1, l2, linf, l1_fans, shock, contact, fan_edge, l1_near, l1_away, value };

/// One error figure that every run is asked for. `maximum` is over the ends of all steps instead of the last one.
struct Quantity {
    std::string field;
    Norm norm = Norm::rms;
    Against against = Against::exact;
    bool maximum = false;
    bool undeformed = false;  ///< integrals are over the undeformed body instead of the body now
    double near = 0;          ///< how far from a wave l1_near ends and l1_away begins [m]; 0 for other norms

    std::string key()
        const;  ///< "displacement.rms", "velocity.l2.undeformed.max", "displacement.rms@finest", "...@itself"
    bool operator==(const Quantity&) const = default;
};

/// How the stability of a scheme is asked for; what for is in the quantities of norm `value`.
struct Stability {
    double crossings = 1000;  ///< length of a run: cells that a wave crosses, whatever the step
    double from = 0.1;        ///< bracket of Courant numbers
    double to = 4;
    double tolerance = 1e-3;  ///< of a Courant number
    double growth = 1000;     ///< of the norm, over its largest at the lower end of the bracket, that is too much
    bool as_scene = false;    ///< the scene's own motion and loads; else a body at rest with noise of 1e-9 c
};

struct Measure {
    std::optional<Stability> stability = {};  ///< then `at` is not asked for
    double at = 0;                            ///< time [s]; number of steps where until is `steps`
    Until until = Until::exact;
    std::vector<std::string> fields;
    std::vector<Quantity> quantities;  ///< fields x norms x against
    /// What orders are fitted against: abscissae of the sweep's path ("h", "dt"), and one over a counter of work:
    /// "1/cells_alive". Empty: the path's own.
    std::vector<std::string> orders_against = {};
};

/// "cells <= 32": one condition on a swept number.
struct Condition {
    std::string axis;
    std::string op;  ///< one of < <= = >= >
    double value = 0;

    bool holds(double found) const;
};

/// A claim that the gate holds the runs to, with its source.
struct Expectation {
    enum class Kind { order, error_at_most, exact_within, value, agreement };

    Kind kind = Kind::order;
    double value = 0;                     ///< the order, the value, or the bound in the field's unit
    double within = 0;                    ///< half-width of the band around an order, a value or another quantity
    std::string other = {};               ///< quantity that an agreement is with
    std::string theory = {};              ///< where the order is the expected one, what it follows from; else empty
    std::string may_exceed = {};          ///< why an order above the band passes too; empty: it does not
    int levels = 0;                       ///< an order needs at least so many in its fit; 0: as many as any fit
    std::string against = {};             ///< abscissa of an order: "h", "1/chop_outs"; empty: those of the path
    std::vector<Condition> where;         ///< which runs it speaks of; empty: all
    std::vector<std::string> quantities;  ///< keys it speaks of; empty: all
    std::vector<std::string> solvers;     ///< labels it speaks of; empty: all
    std::string source;                   ///< key of docs/references.bib, or a sentence
};

/// A value as a paper prints it, at its place in the sweep.
struct PublishedValue {
    std::map<std::string, double> axes;
    std::string printed;
};

/// How to hold runs to printed values: by every printed digit, by a relative band, or not at all (then `because`).
enum class Compare { digits, band, none };

struct Published {
    std::string id;
    std::string title;
    std::string source;
    std::string solver;    ///< label of the solver it is about; empty where the study has one solver
    std::string quantity;  ///< key
    Compare compare = Compare::digits;
    double band = 0;
    std::string because;
    std::vector<PublishedValue> values;
};

struct Study {
    std::string name;
    std::string about;
    std::vector<std::string> source;
    SceneChoice scene;
    std::vector<SolverChoice> solvers;
    Sweep sweep;
    Measure measure;
    std::vector<Expectation> expect;
    std::vector<Published> published;
    bool diverged_allowed = false;
    bool time_out_allowed = false;
    bool stops_when_decided = false;  ///< a level that decided.hpp says need not be run is skipped
    std::optional<double> timeout_s;  ///< of each run
    std::string document;  ///< the whole question as JSON, published values included: reads back as this study
};

/// The axis that refines h for this solver: "cells" for a mesh.
std::string width_axis(const SolverChoice& solver);

/// The abscissae along which the path refines: "h", "dt" or both.
std::vector<std::string> own_abscissae(Path path);

/// "1/cells_alive" is one over what a run counts; "" for an abscissa that is none such, else the counter's name.
std::string counter_of(const std::string& abscissa);

/// Names of the norms, in the order of their enumeration.
const std::vector<std::string>& norm_names();

/// Needs cells and the waves of the exact solution: l1_fans, and the places.
bool is_about_waves(Norm norm);

/// l1_near or l1_away: needs the waves of the exact solution, and how far from them `near` ends.
bool is_part(Norm norm);

/// No error: nothing is fitted to it, and a run may lack it.
bool is_value(Norm norm);

/// shock, contact or fan_edge: an error that is a distance.
bool is_place(Norm norm);

using ordo::text_of;
std::string text_of(Norm norm);
std::string text_of(const std::vector<Condition>& where);
/// "order 2 +- 0.1", "expected order 0.667 +- 0.1 (contact, l1, formal order 2)"
std::string text_of_order(const Expectation& expectation);
std::string text_of(Path path);
std::string text_of(Until until);
std::string text_of(Compare compare);

}  // namespace ordo::studies
