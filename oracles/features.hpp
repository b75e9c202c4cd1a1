#pragma once
// From the waves of an exact solution to what is not smooth in each of its fields.
#include "oracles/oracle.hpp"

namespace ordo::oracles {

/// A wave with the states on its sides, and how far it has room.
struct WaveSides {
    Wave wave;
    double before = 0;                          ///< last edge of the wave to the left, -inf where there is none [m]
    double after = 0;                           ///< first edge of the wave to the right
    std::vector<double> left = {}, right = {};  ///< rows of the solution beside it, 1e-9 of its room away
    std::vector<double> middle = {};            ///< and between its edges

    /// Whether a field differs across it, or within it, by more than 1e-9 of `size`.
    bool changes(std::size_t offset, double size) const;
    bool to_vacuum(bool on_right) const;  ///< fields have no value on that side
};

/// All waves of a solution at time t; none where it does not tell them.
std::vector<WaveSides> sides_of_waves(const Exact& exact, double t);

/// Largest size of a field beside any wave.
double size_beside(const std::vector<WaveSides>& waves, std::size_t offset);

/// `features` of a solution on a line whose fields are analytic between its waves. Shocks and contacts make those
/// fields jump, and fans give those a corner at both edges, that change across them: pressure at a contact does not.
/// The edge of a vacuum is singular in every field.
///
/// exact      with its sample, fields and waves; copied
/// acoustic   what its shocks are: linear where the law is
Exact::Features features_of_waves(const Exact& exact, Feature::Kind acoustic = Feature::Kind::shock);

/// The same and, where there is one, a singular place x = 0.
Exact::Features with_singular_centre(Exact::Features features, bool singular);

/// Where any field is not smooth at time t, rising [m]; none where the solution does not tell.
std::vector<double> places_of_features(const Exact& exact, double t);

/// "shock", "contact", "linear", "fan_corner" or "singular".
std::string text_of(Feature::Kind kind);

}  // namespace ordo::oracles
