#include "oracles/blasts/energy_integrals.hpp"

#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/exp_sinh.hpp>

namespace ordo::oracles {

EnergyIntegrals energy_integrals(const Similarity& profiles, int j, double gamma, double omega) {
    // Numbers so large that the integrand overflows give NaN, which the caller refuses, instead of an exception.
    using namespace boost::math::policies;
    boost::math::quadrature::exp_sinh<double, policy<evaluation_error<ignore_error>>> quadrature;
    constexpr double tolerance = 1e-13;  // of the last refinement's change, which squares what is left
    const auto integral = [&](double Similarity::Shell::*part) {
        // In units of the slowest decay, whose scale q has from 1 to 1 / (gamma - 1).
        const double unit = 1 / profiles.decay();
        return unit * quadrature.integrate([&](double x) { return profiles.shell(unit * x).*part; }, tolerance);
    };
    const double n = j + 2 - omega;
    const double J1 = 16 / ((gamma - 1) * (gamma + 1) * n * n) * integral(&Similarity::Shell::kinetic);
    const double J2 = 8 / ((gamma + 1) * n * n) * integral(&Similarity::Shell::pressure);
    if (j == 1) return {J1, J2, J1 / 2 + J2 / (gamma - 1)};
    return {J1, J2, (j - 1) * boost::math::constants::pi<double>() * (J1 + 2 * J2 / (gamma - 1))};
}

}  // namespace ordo::oracles
