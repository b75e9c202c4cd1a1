#pragma once
// The Sedov-Taylor blast: energy released at a point, on a line or in a plane of a cold ideal gas.
#include "oracles/blasts/energy_integrals.hpp"
#include "oracles/blasts/similarity.hpp"
#include "oracles/oracle.hpp"

namespace ordo::oracles {

/// What is given.
struct Sedov {
    enum class Geometry { planar = 1, cylindrical = 2, spherical = 3 };

    Geometry geometry = Geometry::spherical;  ///< j = 1, 2, 3
    double gamma = 1.4;                       ///< ratio of the specific heats, > 1
    double omega = 0;                         ///< the gas ahead has the density rho0 r^-omega, omega < j
    double energy = 0.851072;                 ///< released at t = 0 [J/m^(3 - j)]; planar: into one side
    double rho0 = 1;                          ///< [kg/m^(3 - omega)]
};

/// The self-similar flow that the release drives, for every gamma > 1 and omega < j: standard, singular and vacuum.
///
///   r_shock(t) = (energy t^2 / (alpha rho0))^(1/n),   n = j + 2 - omega,   speed U = 2 r_shock / (n t)
///   behind it: u2 = 2 U / (gamma + 1),  rho2 = rho0 r_shock^-omega (gamma + 1) / (gamma - 1),
///              p2 = 2 rho0 r_shock^-omega U^2 / (gamma + 1)
///   inside:    u = u2 f(lambda), rho = rho2 g(lambda), p = p2 h(lambda), lambda = r / r_shock  (Similarity)
///
/// r        distance from the centre, axis or plane in space, r >= 0 [m]      t   time, t > 0 [s]
/// At the shock the state ahead of it holds. In a vacuum core density and pressure are 0, velocity and energy NaN; at
/// r = 0 a density or energy that grows without limit is NaN.
/// accurate alpha 1e-14; fields 1e-13 times their condition numbers  (gate: tests/oracles/sedov)
/// source   [Sedov1959], [KammTimmes2007]; the form without singular exponents: similarity.hpp
class SedovBlast {
public:
    struct State {
        double velocity, density, pressure, energy;  ///< [m/s], [kg/m^3], [Pa], specific internal [J/kg]
    };
    struct Front {
        double r, speed, core;  ///< of the shock [m], [m/s]; radius of the vacuum core [m]
        State behind;
    };

    /// Throws InputError where theory has no such blast.
    explicit SedovBlast(const Sedov& given);

    const Sedov& given() const { return given_; }
    const Similarity& profiles() const { return profiles_; }
    const EnergyIntegrals& integrals() const { return integrals_; }  ///< J1, J2, alpha

    Front front(double t) const;
    State at(double r, double t) const { return at(r, front(t)); }
    State at(double r, const Front& front) const;
    double mass(double r, double t) const;  ///< between 0 and r [kg/m^(3 - j)]; planar: of one side

private:
    double swept_mass(double r) const;

    Sedov given_;
    int j_;
    Similarity profiles_;
    EnergyIntegrals integrals_;
    double r_of_one_;  ///< r_shock at t = 1 s
};

Oracle sedov();

}  // namespace ordo::oracles
