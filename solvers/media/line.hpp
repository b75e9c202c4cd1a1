#pragma once
// A gas or an elastic line made of uniform pieces: the problem of gas tubes, bars that collide, and blasts.
#include <array>
#include <vector>

#include "solvers/media/medium.hpp"

namespace ordo::solvers {

/// What is beyond an end of the line.
struct LineEnd {
    enum class Kind {
        reservoir,   ///< the end piece goes on without end
        wall,        ///< a rigid wall that moves with `velocity`; at rest it reflects
        free,        ///< nothing: no pressure acts on the end, which moves with the material
        prescribed,  ///< at the end's place, which stands still, `outside` is held
        periodic     ///< the other end; both ends have this kind
    };
    Kind kind = Kind::reservoir;
    double velocity = 0;    ///< of a wall [m/s]
    Contents outside = {};  ///< of a prescribed end
};

/// `pieces` [n] of uniform contents between `edges` [n + 1], rising [m]. The line is observed over [edges.front(),
/// edges.back()], or between its walls and free ends where they have moved.
struct LineScene {
    Medium medium;
    std::vector<double> edges;
    std::vector<Contents> pieces;
    std::array<LineEnd, 2> ends{};  ///< [0 left, 1 right]
};

}  // namespace ordo::solvers
