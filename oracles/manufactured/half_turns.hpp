#pragma once
// Sine and cosine of an angle in half turns: exactly 0 where they should be.
#include <boost/math/special_functions/cos_pi.hpp>
#include <boost/math/special_functions/sin_pi.hpp>

namespace ordo::oracles {

/// In double all along: the default would go through long double at three times the cost for the last half ulp.
using InDouble = boost::math::policies::policy<boost::math::policies::promote_double<false>>;

inline double sin_pi(double x) { return boost::math::sin_pi(x, InDouble()); }
inline double cos_pi(double x) { return boost::math::cos_pi(x, InDouble()); }

}  // namespace ordo::oracles
