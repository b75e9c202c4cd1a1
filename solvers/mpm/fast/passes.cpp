// What a kernel is given to go over: the blocks that are swept, the nodes that they touch.
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "solvers/mpm/fast/fast.hpp"

namespace ordo::solvers::mpm::fast {

namespace {

/// Blocks that are swept before those who left them are seated, while both are still in a near cache.
constexpr long piece = 64;

}  // namespace

/// job(first, last, hand) over equal parts of `count` pieces, a part a thread.
template <int dim>
template <class Job>
void FastMpm<dim>::over(long count, const Job& job) {
    if (!team_ || sections_.size() == 1) return job(0, count, hands_.front());
    const long members = team_->members();
    const auto part = [&](int member) {
        job(count * member / members, count * (member + 1) / members, hands_[static_cast<std::size_t>(member)]);
    };
    team_->run(std::ref(part));
}

/// Nodes from sums to v, a or both. Held ones stand, by an impulse that takes all their force.
template <int dim>
void FastMpm<dim>::solve(Makes what, double kick, bool ends_m) {
    const bool forces = what != Makes::v;
    for (const auto& [node, axis] : held_) {
        const auto c = static_cast<std::size_t>(axis);
        if (forces) impulse_[axis] -= kick * (at(f_[c], node) - damping_ * at(p_[c], node));
        if (forces) at(f_[c], node) = 0;
        at(p_[c], node) = 0;
    }
    if (forces) impulse_ += kick * load_;
    NodePass<dim> pass{};
    pass.first = runs_.data();
    pass.count = static_cast<long>(runs_.size());
    pass.m = m_.front().at;
    pass.kick = kick;
    pass.damping = damping_;
    pass.takes_p = what == Makes::v || what == Makes::both;
    pass.takes_f = forces;
    pass.adds = what == Makes::both || what == Makes::a_added;
    pass.ends_m = ends_m;
    for (std::size_t c = 0; c < dim; ++c) {
        pass.p[c] = p_[c].front().at;
        pass.f[c] = f_[c].front().at;
        pass.v[c] = v_[c].front().at;
        pass.a[c] = a_[c].front().at;
    }
    over(pass.count, [&](long first, long last, Hand<dim>&) {
        NodePass<dim> part = pass;
        part.first += first;
        part.count = last - first;
        kernels_.nodes(part);
    });
}

template <int dim>
Sweep<dim> FastMpm<dim>::sweep_of(Pass pass, double kick, double dt) {
    Sweep<dim> s{};
    s.stride = slots_.rows() * lanes;
    s.blocks = slots_.blocks().data();
    s.m = m_.front().at;
    const bool two = pass == Pass::follow_two;
    for (int axis = 0; axis < dim; ++axis) {
        const auto c = static_cast<std::size_t>(axis);
        s.row[c] = slots_.row_of_nodes(axis);
        s.v[c] = v_[c].front().at;
        s.u[c] = two ? u_[c].front().at : nullptr;
        s.a[c] = a_[c].front().at;
        s.p[c] = p_[c].front().at;
        s.f[c] = f_[c].front().at;
        s.ends[c] = ends_[c].data();
        s.cells[c] = static_cast<long>(ends_[c].size() / 4);
        s.lower[c] = grid_.lower[axis];
    }
    s.h = grid_.h;
    s.per_h = per_h_;
    s.kick = kick;
    s.dt = dt;
    s.lambda = C_.lambda;
    s.mu = C_.mu;
    s.rate = rate_;
    s.mesh = static_cast<Mesh>(options_.strain_mesh);
    s.volume_updated = options_.volume_updated;
    s.keeps_F = slots_.rows() > Row<dim>::F;
    s.b = b_.empty() ? nullptr : b_.front().data();
    return s;
}

/// All even sections, then all odd ones: nodes that two share take the even one's gift first, whoever sweeps them.
template <int dim>
void FastMpm<dim>::sweep(Pass pass, double kick, double dt) {
    const Sweep<dim> s = sweep_of(pass, kick, dt);
    const bool moves = pass != Pass::begin && pass != Pass::kick && pass != Pass::first && pass != Pass::load;
    if (moves && !total_) on_face_ = false;
    if (moves || pass == Pass::begin) joined_ = 0;
    if (sections_.size() > 1) {
        for (auto& section : sections_) slots_.stock(section.pool, static_cast<int>((section.end - section.begin) / 8));
    }
    for (const long odd : {0, 1}) {
        over((static_cast<long>(sections_.size()) + 1 - odd) / 2, [&](long first, long last, Hand<dim>& hand) {
            for (long k = first; k < last; ++k)
                sweep_section(s, pass, sections_[static_cast<std::size_t>(2 * k + odd)], hand);
        });
    }
    Told<dim> all;
    for (auto& section : sections_) hear(section, pass, all);
    if (!all.finite) throw Diverged("the positions of the particles are not finite");
    if (all.inverted != Told<dim>::none)
        throw Diverged("particle " + std::to_string(all.inverted) + " is turned inside out");
}

template <int dim>
void FastMpm<dim>::sweep_section(Sweep<dim> s, Pass pass, Section<dim>& section, Hand<dim>& hand) {
    hand.of = this;
    hand.section = &section;
    s.settle_for = &hand;
    for (long k = section.begin; k < section.end; k += piece) {
        s.slots = slots_.data();
        s.next = slots_.next();
        s.id = slots_.ids();
        s.order = order_.data() + k;
        s.count = std::min(piece, section.end - k);
        kernels_.sweep[static_cast<int>(pass)](s);
        if (hand.turns.empty() && hand.waiting.empty()) continue;
        seat_travellers(hand, pass, k + piece < section.end ? s.order[piece] : section.last + 1);
    }
    for (int c = 0; c < dim; ++c) {
        for (int lane = 0; lane < lanes; ++lane) {
            section.told.load[c] += s.load[c][lane];
            section.told.finite = section.told.finite && std::isfinite(s.travelled[c][lane]);
        }
    }
}

template class FastMpm<1>;
template class FastMpm<2>;
template class FastMpm<3>;

}  // namespace ordo::solvers::mpm::fast
