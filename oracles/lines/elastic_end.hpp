#pragma once
// A uniform elastic bar whose end a wall pushes, pulls or stops, or whose end is let go.
#include "oracles/oracle.hpp"
#include "oracles/riemann/elastic_star.hpp"

namespace ordo::oracles::elastic {

/// The bar fills x > x0 at t = 0 and has the state `bar`. One wave runs into it from its end; behind that the material
/// moves with the end, at V for a wall, or at the one velocity whose wave takes the stress to zero for a free end. In
/// the end's mirror the bar has the velocity 2 V - v: both together are a Riemann problem whose contact is the end.
///
/// source [Toro2009, section 6.3] for the mirror; equations [Walker2017]
inline State mirror_image(const State& bar, double V) { return {bar.lambda, 2 * V - bar.v, bar.T}; }

/// The velocity of a free end: behind a shock where the bar was stretched, else behind a rarefaction [m/s].
template <class M>
double released_velocity(const M& material, const State& bar) {
    WaveCurve<M> curve(material, {stretch(bar.lambda), bar.T});
    return bar.v + curve.wave(-curve.pressure(), 0).push;
}

}  // namespace ordo::oracles::elastic

namespace ordo::oracles {

Oracle elastic_end();

}  // namespace ordo::oracles
