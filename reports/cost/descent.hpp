#pragma once
// Work-precision curves: error against what it cost, as measured and between measurements, never beyond them.
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace ordo::reports {

/// What a run cost and the error it left: thread time [s] or counted work. NaN where it has none.
struct CostPoint {
    double cost = std::numeric_limits<double>::quiet_NaN();
    double error = std::numeric_limits<double>::quiet_NaN();
};

/// It can be ranked: a finite cost above zero, and a finite error; an error of zero is below all others.
bool placed(const CostPoint& point);

/// Places in `points` of those that no other point beats (cheaper and no worse, or better and no dearer), in rising
/// cost. Of equal points the first one; points without a place are never on the front.
std::vector<std::size_t> pareto_front(std::span<const CostPoint> points);

/// The least error that a method had for at most so much cost: falls with the cost, a power law between two runs of
/// neighbouring cost (a straight line in logarithms), flat where a dearer run is no better. Where a run without an
/// error lies between two (one that blew up), and to an error of zero, it falls at once at the dearer one.
struct Descent {
    /// In rising cost and falling error; two of one cost are a fall, two of one error a flat piece.
    std::vector<CostPoint> vertices;

    bool empty() const { return vertices.empty(); }
};

/// `points` in the order of refinement, coarse to fine.
Descent descent_of(std::span<const CostPoint> points);

/// How a cost is known: between two runs; it is that of the cheapest run, so that less may do; not reached.
enum class Reached { between, at_most, never };

struct CostToError {
    Reached reached = Reached::never;
    double cost = std::numeric_limits<double>::quiet_NaN();
};

/// The least cost at which the error is at most `error`. Exact for points on a power law.
CostToError cost_to(const Descent& descent, double error);

/// Where two descents cross, at costs that both were measured for: dearer than `at.cost`, the other one has the smaller
/// error.
struct Crossover {
    CostPoint at;
    bool first_leads = false;  ///< the first of both has the smaller error from here on
};
std::vector<Crossover> crossovers(const Descent& first, const Descent& second);

/// The least error of the descent for at most `cost`; infinite below its cheapest run, constant beyond its dearest.
double error_for(const Descent& descent, double cost);

}  // namespace ordo::reports
