#pragma once
// Student's t and Fisher's F, the two distributions of the fits, in one place: their headers are slow to compile.

namespace ordo::studies {

/// Value of t that a deviate of so many degrees of freedom stays below with this probability.
double student_quantile(double freedom, double probability);

/// The value that it exceeds with this probability; exact where the probability is tiny.
double student_bound(double freedom, double tail);

/// Probability that |t| or more comes by chance.
double student_chance(double freedom, double t);

/// Value of F with (above, below) degrees of freedom that is not exceeded with this probability.
double fisher_quantile(double above, double below, double probability);

/// Probability that F or more comes by chance.
double fisher_chance(double above, double below, double f);

}  // namespace ordo::studies
