#pragma once
// Von Mises plasticity where the strain moves to and fro on one line: what uniaxial strain and simple shear share.
#include <string>
#include <vector>

#include "oracles/oracle.hpp"

namespace ordo::oracles {

/// A strain that grows at a constant rate, for ever or as a triangle wave between two peaks.
struct StrainPath {
    enum class Kind { monotonic, cycle };

    Kind kind = Kind::monotonic;
    double rate = 1;     ///< d strain / dt up to the first reversal, of either sign [1/s]
    double peak = 0.01;  ///< of the wave, > 0 [-]

    /// A stretch between two reversals: the strain leaves a peak and goes `direction`.
    struct Leg {
        double reversals;  ///< before it
        double direction;  ///< +1 or -1
        double travelled;  ///< strain since the last reversal, or since t = 0 [-]
    };
    Leg leg(double t) const;
    double strain(double t) const;  ///< 1 ulp of the strain travelled since t = 0
    double last_time() const;       ///< beyond it a double t no longer tells the place on the path [s]
};

/// Von Mises' law with linear isotropic hardening on such a path, in one scalar: the equivalent stress q with a sign.
///
///   dq = k d strain - 3 G sign(q) dp,   |q| <= Y0 + H p,   dp >= 0,   dp (|q| - Y0 - H p) = 0
///
/// k        elastic slope of q: 2 G in uniaxial strain, sqrt(3) G in simple shear [Pa]
///
/// A leg is elastic over 2 (Y0 + H p) / k, then plastic with dp = k |d strain| / (3 G + H). A whole leg between two
/// peaks adds (1 - h) times what the one before added, h = 2 H / (3 G + H): a geometric sum, whatever the number.
/// Where H >= 3 G, all legs after the second are elastic.
struct ScalarJ2 {
    double k;
    double G;   ///< shear modulus [Pa]
    double Y0;  ///< initial yield stress in tension [Pa]
    double H;   ///< hardening modulus dY / dp, >= 0 [Pa]
    StrainPath path;

    struct State {
        double strain;  ///< [-]
        double q;       ///< von Mises stress with a sign [Pa]
        double p;       ///< equivalent plastic strain, accumulated [-]
    };
    State at(double t) const;
    double plastic_work(double p) const;  ///< integral of (Y0 + H p) dp [J/m^3]

private:
    double plastic_strain_after(double reversals) const;
};

/// Elastic constants, Y0, H and the path, declared; and the path read.
std::vector<Parameter> j2_parameters();
StrainPath strain_path(const Values& values);

/// What an explanation says of them.
std::string strain_path_text();

}  // namespace ordo::oracles
