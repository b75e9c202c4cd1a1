#pragma once
// What a line is made of: uniform cells, and between each two of them a front.
#include <array>

#include "solvers/media/line.hpp"

namespace ordo::solvers::rrm {

/// Density, velocity, pressure, temperature: what the error metric watches.
using Watched = std::array<double, 4>;
inline Watched watched_of(const Flow& f) { return {f.rho, f.v, f.p, f.T}; }

/// A piece of the line in one state. Its undisturbed core lies between the fronts on its two sides.
struct Cell {
    Contents q;        ///< of a unit of length
    Flow f;            ///< what follows from them
    int left = -1;     ///< front on that side; -1 where the cell goes on without end; of an unused cell the next one
    int right = -1;    ///< the same
    double width = 0;  ///< when it was put back [m]
};

/// What comes in from a length w of a cell that pushes with the impulse `push` meanwhile.
inline Contents swept(const Cell& c, double w, double push) {
    return {w * c.q.mass, w * c.q.momentum + push, w * c.q.energy + push * c.f.v};
}

/// What came into a front from one side: contents; and for the metric the length that was swept and the first two
/// moments over it of the watched fields, relative to the front's base.
struct Side {
    Contents content;
    double width = 0;
    Watched sum{};
    Watched square{};

    /// Nothing came in. Member by member, for that is faster than one clearing of all.
    void clear() {
        content = {};
        width = 0;
        sum = {};
        square = {};
    }
};

/// A disturbed interval [x_l, x_r] between two cells, as it was at time t. Its edges run at S_l and S_r into cells that
/// are still uniform, so the balance laws over it are exact and linear in time, whatever happens inside.
struct alignas(64) Front {  // a processor's cache line
    enum class Kind {
        fresh,  ///< born at t without width or contents: l and r hold nothing yet
        open,   ///< it has a past: l and r hold what came in until t
        kept,   ///< a wave of no width that two states with the right jump send along: nothing is disturbed
        unused  ///< a free slot: `left` is the next one
    };
    Kind kind = Kind::fresh;
    bool tagged = false;                           ///< carries a contact, and keeps the contents of both sides apart
    bool wraps = false;                            ///< its right cell is the first one of a periodic line
    LineEnd::Kind end = LineEnd::Kind::reservoir;  ///< other than reservoir: it lies at an end of the line
    int left = -1;                                 ///< cells
    int right = -1;
    double t, x_l, x_r, S_l, S_r;
    double t_chop;    ///< when it will have changed as much as it may
    double t_vanish;  ///< when its right cell will have no core left
    double x_0, t_0;  ///< where and when the contact was born
    double x_c, v_c;  ///< where it is at t, and how fast
    Watched base;
    Side l, r;  ///< where nothing is tagged, l holds what came from both sides

    /// Most are: nothing is kept apart, and no end is near.
    bool plain() const { return !tagged && end == LineEnd::Kind::reservoir; }
    double width() const { return x_r - x_l; }
    Contents content() const { return tagged ? l.content + r.content : l.content; }
};

}  // namespace ordo::solvers::rrm
