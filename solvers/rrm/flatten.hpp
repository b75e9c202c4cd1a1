#pragma once
// Flatten: what an interval becomes.
#include "core/text.hpp"
#include "solvers/rrm/line.hpp"
#include "solvers/solver.hpp"

namespace ordo::solvers::rrm {

[[noreturn]] inline void refuse(const Flow& f, double x, double t) {
    throw Diverged("at t = " + shortest(t) + " s, x = " + shortest(x) +
                   " m a chop-out leaves no physical state: density " + shortest(f.rho) + ", pressure " +
                   shortest(f.p));
}

/// A front's contents spread over its width. Throws Diverged where that is no matter that waves can run through.
template <class M>
inline State Line<M>::flat(const Front& f) const {
    const Contents total = f.end == LineEnd::Kind::wall ? f.content() + owed_by_wall(f) : f.content();
    const Contents q = (1 / f.width()) * total;
    const Flow flow = medium_.flow(q);
    if (!flow.physical()) refuse(flow, f.x_l, f.t);
    return {q, flow};
}

/// Two cells on both sides of a contact, which share a velocity and pass on the impulse that brings them to it; one
/// where that cannot be.
template <class M>
typename Line<M>::Flattened Line<M>::flattened(const Front& f) const {
    if (f.tagged && f.x_c > f.x_l && f.x_c < f.x_r) {
        const double v = f.content().momentum / f.content().mass;
        const Contents& from_l = f.l.content;
        const Contents& from_r = f.r.content;  // the impulse is the same from both sides, and so are its digits then
        const double impulse = 0.5 * ((from_l.mass * v - from_l.momentum) - (from_r.mass * v - from_r.momentum));
        const double work = impulse * (f.x_c - f.x_0) / (f.t - f.t_0);
        const Contents l = (1 / (f.x_c - f.x_l)) * Contents{from_l.mass, from_l.mass * v, from_l.energy + work};
        const Contents r = (1 / (f.x_r - f.x_c)) * Contents{from_r.mass, from_r.mass * v, from_r.energy - work};
        const Flow fl = medium_.flow(l);
        const Flow fr = medium_.flow(r);
        if (fl.physical() && fr.physical()) return {2, f.x_c, {{{l, fl}, {r, fr}}}};
    }
    return {1, 0, {{flat(f), {}}}};
}

/// The same as cells at the end of a row.
template <class M>
inline void Line<M>::add_flattened(Row& row, const Front& f) {
    if (!f.plain()) return add_flattened_special(row, f);
    row.borders[at(row.n)] = f.x_l;
    row.cells[at(row.n)] = add_cell(flat(f), f.width());
    row.borders[at(++row.n)] = f.x_r;
}

/// The same of a front that carries a contact or lies at an end.
template <class M>
[[gnu::noinline]] void Line<M>::add_flattened_special(Row& row, const Front& f) {
    const auto add = [&](const State& state, double from, double to, bool tagged) {
        row.borders[at(row.n)] = from;
        row.tags[at(row.n)] = tagged;
        row.cells[at(row.n)] = add_cell(state, to - from);
        row.borders[at(++row.n)] = to;
        row.tags[at(row.n)] = false;
    };
    if (f.end == LineEnd::Kind::wall) received_ += owed_by_wall(f);
    const Flattened put = flattened(f);
    if (put.count == 1) return add(put.states[0], f.x_l, f.x_r, false);
    const Flow& l = put.states[0].f;
    const Flow& r = put.states[1].f;
    add(put.states[0], f.x_l, put.x, false);
    add(put.states[1], put.x, f.x_r, !(l.rho == r.rho && l.p == r.p && l.T == r.T));
}

}  // namespace ordo::solvers::rrm
