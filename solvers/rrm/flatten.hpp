#pragma once
// Flatten: what an interval becomes.
#include "core/text.hpp"
#include "solvers/rrm/line.hpp"
#include "solvers/solver.hpp"

namespace ordo::solvers::rrm {

/// Contents spread over a width. Throws Diverged where that is no matter that waves can run through.
template <class M>
State Line<M>::flat(const Contents& total, double width, double x, double t) const {
    const Contents q = (1 / width) * total;
    const Flow f = medium_.flow(q);
    if (!f.physical())
        throw Diverged("at t = " + shortest(t) + " s, x = " + shortest(x) +
                       " m a chop-out leaves no physical state: density " + shortest(f.rho) + ", pressure " +
                       shortest(f.p));
    return {q, f};
}

/// One cell; or two on both sides of a contact, which share a velocity and pass on the impulse that brings them to it.
template <class M>
typename Line<M>::Flattened Line<M>::flattened(const Front& f) const {
    if (f.tagged && f.x_c > f.x_l && f.x_c < f.x_r) {
        const double v = f.content().momentum / f.content().mass;
        const double impulse = f.l.content.mass * v - f.l.content.momentum;
        const double work = impulse * (f.x_c - f.x_0) / (f.t - f.t_0);
        const Contents l =
            (1 / (f.x_c - f.x_l)) * Contents{f.l.content.mass, f.l.content.mass * v, f.l.content.energy + work};
        const Contents r =
            (1 / (f.x_r - f.x_c)) * Contents{f.r.content.mass, f.r.content.mass * v, f.r.content.energy - work};
        const Flow fl = medium_.flow(l);
        const Flow fr = medium_.flow(r);
        if (fl.physical() && fr.physical()) return {2, f.x_c, {{{l, fl}, {r, fr}}}};
    }
    return {1, 0, {{flat(f.content() + owed_by_wall(f), f.width(), f.x_l, f.t), {}}}};
}

/// The same as cells at the end of a row.
template <class M>
void Line<M>::add_flattened(Row& row, const Front& f) {
    received_ += owed_by_wall(f);
    const Flattened put = flattened(f);
    const auto add = [&](const State& state, double from, double to, bool tagged) {
        row.borders[at(row.n)] = from;
        row.tags[at(row.n)] = tagged;
        row.cells[at(row.n)] = add_cell(state, to - from);
        row.borders[at(++row.n)] = to;
        row.tags[at(row.n)] = false;
    };
    if (put.count == 1) return add(put.states[0], f.x_l, f.x_r, false);
    const Flow& l = put.states[0].f;
    const Flow& r = put.states[1].f;
    add(put.states[0], f.x_l, put.x, false);
    add(put.states[1], put.x, f.x_r, !(l.rho == r.rho && l.p == r.p && l.T == r.T));
}

}  // namespace ordo::solvers::rrm
