#pragma once
// Without an exact solution: what the values of several grids say of the limit h -> 0, and of their own uncertainty.
#include <limits>
#include <string>
#include <vector>

#include "studies/order/convergence.hpp"
#include "studies/order/order_fit.hpp"

namespace ordo::studies {

/// The value that one grid gives.
struct GridValue {
    double h = 0;
    double value = 0;
};

/// How three values follow each other: to a limit, to and fro, away from it, or not at all.
enum class Behaviour { monotone, oscillatory, divergent, equal };
std::string text_of(Behaviour behaviour);

/// What one method makes of the grids; NaN where it says nothing, and then the reason.
struct Extrapolation {
    std::string method;   ///< "Richardson", "GCI", "Eca-Hoekstra", "finest level"
    std::string assumes;  ///< what must hold for its numbers to mean anything
    Convergence verdict = Convergence::inconclusive;
    std::string reason = {};
    std::string model = {};  ///< "h^p", "h", "h^2" or "h + h^2"; empty where nothing was fitted
    double order = std::numeric_limits<double>::quiet_NaN();
    double limit = std::numeric_limits<double>::quiet_NaN();        ///< extrapolated to h = 0
    double uncertainty = std::numeric_limits<double>::quiet_NaN();  ///< half-width around the finest value
    double safety = std::numeric_limits<double>::quiet_NaN();       ///< factor in the uncertainty
};

/// Three values by falling h.
struct Triple {
    GridValue coarse, medium, fine;

    Behaviour behaviour() const;
    /// p of value = limit + C h^p through the three, for any ratios: the root of
    /// (coarse - medium) / (medium - fine) = (h_c^p - h_m^p) / (h_m^p - h_f^p); NaN unless they are monotone or
    /// diverge.
    double order() const;
};

/// Grid convergence index of the finer of two grids, as a fraction of its value: safety |1 - f2/f1| / (r^p - 1).
double gci(GridValue fine, GridValue coarse, double order, double safety);

/// The value at h = 0 of value = limit + C h^p.
double richardson(GridValue fine, GridValue coarse, double order);

/// The four methods on these grids, in any order; each says what it assumes, and why where it has no answer.
///
/// Richardson    limit and order from the three finest grids; with two, the limit of the `formal` order
/// GCI           |fine| GCI as uncertainty: factor 1.25 where three grids show an order in [0.5, formal + 0.1] (2.1
///               without a formal order), else 3; two grids take the formal order and 3                 [Celik2008]
/// Eca-Hoekstra  four grids or more: least squares of limit + C h^p, weighted by 1/h or not, whichever scatters less;
///               below p = 0.5 the best of h, h^2 and h + h^2; factor 1.25 where 0.5 <= p < 2.1 and the scatter is
///               below the data range (max - min)/(n - 1), else 3 and more         after [EcaHoekstra2014]
/// finest level  order of the differences from the finest grid, taken as the truth
///
/// formal   order of the method; NaN where it is unknown
std::vector<Extrapolation> extrapolations(std::vector<GridValue> grids,
                                          double formal = std::numeric_limits<double>::quiet_NaN());

/// The order of value = limit + C h^p by least squares, as a fit with 95 % Student interval (n - 3 degrees of freedom;
/// infinite for three grids); refused, by name, where the values do not follow such a law. `coefficient` is |C|.
FitOutcome fit_order_of_values(std::vector<GridValue> grids);

}  // namespace ordo::studies
