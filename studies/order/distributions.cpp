#include "studies/order/distributions.hpp"

#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

namespace ordo::studies {

using boost::math::complement;
using boost::math::fisher_f;
using boost::math::students_t;

double student_quantile(double freedom, double probability) { return quantile(students_t(freedom), probability); }

double student_bound(double freedom, double tail) { return quantile(complement(students_t(freedom), tail)); }

double student_chance(double freedom, double t) { return 2 * cdf(complement(students_t(freedom), std::abs(t))); }

double fisher_quantile(double above, double below, double probability) {
    return quantile(fisher_f(above, below), probability);
}

double fisher_chance(double above, double below, double f) { return cdf(complement(fisher_f(above, below), f)); }

}  // namespace ordo::studies
