#pragma once
// Where a field on cells has the waves of an exact solution.
#include <string>
#include <vector>

#include "oracles/oracle.hpp"
#include "studies/engine/profile.hpp"
#include "studies/engine/study.hpp"

namespace ordo::studies {

/// A level that a field passes at one place of a wave, and how far around it a profile is looked for it.
struct WaveMark {
    double x = 0;  ///< in the exact solution [m]
    double level = 0;
    double from = 0;  ///< half-way to the wave on the left, -inf where there is none [m]
    double to = 0;    ///< and on the right
};

/// The marks of all waves of one kind at time t: of a shock or a contact the middle between the states on its sides; of
/// a fan's edge what the field is 5 % of the fan's width inside, looked for in that half of the fan. Waves that the
/// field does not feel (1e-9 of its largest value beside any wave) have none.
///
/// kind     Norm::shock, contact or fan_edge       offset   of the field in the solution's rows
std::vector<WaveMark> marks_of(Norm kind, const oracles::Exact& exact, std::size_t offset, double t);

/// Why this norm about waves has nothing to measure in this field at time t; "" where it has.
std::string why_nothing_of(Norm kind, const oracles::Exact& exact, const std::string& field, double t);

/// Largest distance of the profile's crossings from the marks between its ends [m]; NaN where the profile passes one of
/// the levels nowhere near, and where it has no mark.
double place_error(const Profile& found, const std::vector<WaveMark>& marks);

}  // namespace ordo::studies
