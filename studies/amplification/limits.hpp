#pragma once
// The largest stable Courant number, by runs, by the matrix of one step and in closed form.
#include <functional>
#include <optional>
#include <string>

#include "studies/amplification/growth.hpp"
#include "studies/amplification/one_step.hpp"
#include "studies/engine/study.hpp"

namespace ordo::studies {

/// A limit between two Courant numbers that were tried. Both are infinite where everything in the bracket is stable.
struct Limit {
    double stable = 0;    ///< the largest that is stable, with all tried below it
    double unstable = 0;  ///< the smallest tried above it, which is not

    double value() const { return 0.5 * (stable + unstable); }
};

/// The first change from stable to unstable: up in steps of 10 % from the lower end of the bracket, then halved until
/// both lie within the tolerance. 0 to `from` where not even the lower end is stable.
Limit first_limit(const std::function<bool(double courant)>& is_stable, const Stability& asked);

/// Spectral radius of one step: of the waves on a periodic body of equal cells, else of the whole body.
double radius(const OneStep& step, const Scheme& scheme, double courant);

/// Beyond 1 by more than round-off and the differences behind the matrix may make of a defective pair.
constexpr double radius_of_stable = 1 + 1e-6;

Limit limit_by_matrix(const Scheme& scheme, const Stability& asked);

/// What a step does to a wave as long as a periodic body: numerical over exact speed, and the factor on its amplitude.
/// Throws InputError for a body that is not periodic or has unequal cells.
struct Wave {
    double speed = 1;
    double gain = 1;
};
Wave longest_wave(const Scheme& scheme, double courant);

/// The smallest closed form for these particles shifted in their cells, by up to 0.49 of what each stands for: what a
/// body meets that moves through its grid. Nothing where none is known, or where they never move in their cells.
std::optional<double> limit_while_crossing(const Scheme& scheme);

/// What grows fastest at this Courant number: "the saw-tooth mode", "a wave of about 3.2 cells".
std::string growing_mode(const Scheme& scheme, double courant);

/// Of a body with ends, where the closed form is of a bar without: that one. Nothing where none is known of these
/// choices.
std::optional<double> limit_by_theory(const Scheme& scheme);

}  // namespace ordo::studies
