// What a kernel is given to go over: the blocks that are swept, the nodes that they touch.
#include <algorithm>
#include <cmath>
#include <string>

#include "solvers/mpm/fast/fast.hpp"

namespace ordo::solvers::mpm::fast {

namespace {

/// Blocks that are swept before those who left them are seated, while both are still in a near cache.
constexpr std::size_t piece = 64;

}  // namespace

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
    kernels_.nodes(pass);
}

template <int dim>
void FastMpm<dim>::sweep(Pass pass, double kick, double dt) {
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
    s.settle_for = this;
    const bool moves = pass != Pass::begin && pass != Pass::kick && pass != Pass::first && pass != Pass::load;
    if (moves && !total_) on_face_ = false;
    for (std::size_t k = 0; k < order_.size(); k += piece) {
        s.slots = slots_.data();
        s.next = slots_.next();
        s.id = slots_.ids();
        s.order = order_.data() + k;
        s.count = static_cast<long>(std::min(piece, order_.size() - k));
        kernels_.sweep[static_cast<int>(pass)](s);
        const bool last = k + piece >= order_.size();
        if (!turns_.empty() || !waiting_.empty())
            seat_travellers(pass, last ? static_cast<int>(near_.size()) : order_[k + piece]);
    }
    for (int c = 0; c < dim; ++c) {
        for (int lane = 0; lane < lanes; ++lane) {
            load_[c] += s.load[c][lane];
            finite_ = finite_ && std::isfinite(s.travelled[c][lane]);
        }
    }
    if (!finite_) throw Diverged("the positions of the particles are not finite");
    if (inverted_ < static_cast<long>(X_.size()))
        throw Diverged("particle " + std::to_string(inverted_) + " is turned inside out");
}

template class FastMpm<1>;
template class FastMpm<2>;
template class FastMpm<3>;

}  // namespace ordo::solvers::mpm::fast
