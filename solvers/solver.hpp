#pragma once
// What a solver is and what it returns.
#include <functional>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/field.hpp"
#include "core/parameter.hpp"
#include "solvers/scene.hpp"

namespace ordo::solvers {

/// Positions, weights and fields of n points at one time; a value.
struct Snapshot {
    double t = 0;  ///< [s]
    int dim = 1;
    std::vector<double> X;                        ///< where each point was in the undeformed body, n x dim [m]
    std::vector<double> x;                        ///< where it is now, n x dim [m]
    std::vector<double> weights;                  ///< volume that each point stands for now, n [m^dim]
    std::vector<double> weights_undeformed = {};  ///< and in the undeformed body; empty where no body deforms
    std::vector<Field> fields;                    ///< the fields that were asked for
    /// Where the points are cells side by side on a line: their n + 1 rising borders [m]. Field values are then means
    /// over the cells, `x` their middles. Empty elsewhere.
    std::vector<double> edges = {};
    /// Rise of each field across each cell, in the order of `fields`; empty where cells are uniform.
    std::vector<Field> slopes = {};

    std::size_t points() const { return weights.size(); }
    const Field& field(const std::string& name) const;  ///< throws std::logic_error when it was not asked for
};

/// One counted or measured number with its name: "particle_steps", "mass".
struct Figure {
    std::string name;
    double value = 0;
};

/// Work that a run did not have to do: what, and its share of the whole.
struct Skipped {
    std::string what;
    double share = 0;
};

/// Thrown by a simulation that cannot go on: a result, not a fault of the program.
struct Diverged : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Asked between steps; a run stops by throwing Interrupted when it answers true.
using Interrupt = std::function<bool()>;
struct Interrupted : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A running solution. Owns its state; not copied, never shared between threads.
class Simulation {
public:
    virtual ~Simulation() = default;
    /// On to exactly t [s], in equal steps not longer than the planned one. Throws Diverged or Interrupted.
    virtual void advance_to(double t, const Interrupt& interrupt) = 0;
    virtual Snapshot snapshot() const = 0;
    virtual std::vector<Figure> work() const = 0;   ///< counted work so far: the same on every machine
    virtual std::vector<Figure> drift() const = 0;  ///< relative defects of the conserved quantities so far
    virtual std::vector<Skipped> skipped() const { return {}; }
    /// Processor time so far of threads beside the caller's, up to their last piece of work [s].
    virtual double helper_seconds() const { return 0; }
};

/// What a start will do, known before it runs: mesh width [m], or whatever else Solver::width says that it refines;
/// largest time step [s]; number of points.
struct Plan {
    double h = 0;
    double dt = 0;
    double points = 0;
};

/// What a method promises, published with its source; tests hold it to this.
struct Claim {
    double order_in_space = 0;
    double order_in_time = 0;
    std::vector<std::string> conserves;
    std::string provided;       ///< under which condition
    std::string source;         ///< key of docs/references.bib
    double order_of_waves = 0;  ///< of the speed of waves, which smears what is not smooth; 0: order_in_space
    bool rings = false;  ///< errors of the waves' speed run out as oscillations: no limiter or upwinding damps them
    std::vector<std::string> fields = {};  ///< those that the orders are of; empty: all
    /// What it moves as it is, without smearing it over cells: "shock", "contact", "linear", "fan_corner".
    std::vector<std::string> sharp = {};
    std::vector<std::string> steep = {};  ///< what it keeps a few cells wide, however far it goes: shocks always
};

/// A method of solution, by name: its declared options and resolution, its claim, and the way to start it.
struct Solver {
    std::string name;
    std::string about;
    std::vector<std::string> source;         ///< keys of docs/references.bib
    std::vector<Parameter> options;          ///< how it discretises
    std::vector<Parameter> resolution;       ///< how finely: the axes that a sweep may use
    std::string width_axis = "cells";        ///< the axis of its resolution that refines Plan::h
    std::string width = "mesh width h [m]";  ///< what h is, in the words of a plot's axis
    std::vector<std::string> fields;         ///< names of the fields that its snapshots can hold
    /// Of a solid body: the one that a step carries on beside the velocity, positions aside: "strain" or "displacement".
    /// Empty where that is not all.
    std::string carries{};
    /// Those of them that a problem has; empty where every problem has all.
    std::function<std::vector<std::string>(const Scene&)> fields_in{};
    std::function<Claim(const Values& options)> claim;
    std::function<bool(const Scene&)> accepts;  ///< whether it can solve problems of this kind
    /// Throws InputError on a scene or on values that do not go together; cheap.
    std::function<Plan(const Scene&, const Values& options, const Values& resolution)> plan;
    /// `fields` are those that snapshots will hold; what is not asked for is not computed.
    std::function<std::unique_ptr<Simulation>(const Scene&, const Values& options, const Values& resolution,
                                              std::span<const std::string> fields)>
        start;
};

/// Number of equal steps not longer than dt that end at `duration`; a quotient within 1e-9 of a whole number is whole.
long steps_to(double duration, double dt);

/// step(t, dt) from `now` to exactly `end` in equal steps not longer than `longest`; `now` follows. Throws Interrupted.
template <class Step>
void in_equal_steps(double& now, double end, double longest, const Interrupt& interrupt, Step&& step) {
    const double start = now;
    const long count = steps_to(end - start, longest);
    const double dt = (end - start) / static_cast<double>(count);
    for (long k = 0; k < count; ++k) {
        if (interrupt()) throw Interrupted("interrupted");
        step(now, dt);
        now = k + 1 == count ? end : start + static_cast<double>(k + 1) * dt;
    }
}

/// The declared choice of a time step: dt, or courant = dt * wave speed / h.
std::vector<Parameter> step_parameters();

/// The step that was chosen [s]. Throws InputError unless exactly one of dt and courant is given.
double step_from(const Values& values, double h, double wave_speed, const std::string& solver);

/// All solvers, one line each in registry.cpp, in the order listed there.
const std::vector<Solver>& all_solvers();

/// The solver of that name. Throws InputError with the nearest name.
const Solver& solver_named(const std::string& name, const std::string& where);

}  // namespace ordo::solvers
