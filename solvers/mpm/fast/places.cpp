// Where particles are: who has left a cell, who stands on a face.
#include <algorithm>
#include <bit>
#include <cmath>

#include "solvers/mpm/fast/fast.hpp"
#include "solvers/mpm/fast/slot.hpp"

namespace ordo::solvers::mpm::fast {

template <int dim>
long FastMpm<dim>::padded(int node) const {
    long at = 0;
    for (int axis = 0; axis < dim; ++axis) {
        const int along = node / grid_.stride[axis] % static_cast<int>(grid_.place[axis].size());
        at += along * slots_.row_of_nodes(axis);
    }
    return at;
}

template <int dim>
Vec<dim> FastMpm<dim>::where(Seat seat) const {
    Vec<dim> x;
    for (int axis = 0; axis < dim; ++axis) x[axis] = slots_.at(seat, Row<dim>::x + axis);
    return x;
}

template <int dim>
double FastMpm<dim>::place(double x, int cell, int axis) const {
    const double r = x - grid_.lower[axis];
    const double xi = r * per_h_ - cell;
    return xi >= beside && xi <= 1 - beside ? xi : r / grid_.h - cell;
}

template <int dim>
double FastMpm<dim>::place(Seat seat, int axis) const {
    if (total_) return slots_.at(seat, Row<dim>::xi + axis);
    return place(slots_.at(seat, Row<dim>::x + axis), slots_.cell(seat)[axis], axis);
}

template <int dim>
bool FastMpm<dim>::on_face(Seat seat) const {
    for (int axis = 0; axis < dim; ++axis) {
        const double xi = place(seat, axis);
        if (xi == 0 || xi == 1) return true;
    }
    return false;
}

template <int dim>
void FastMpm<dim>::settle(Block& block, int slot, int lane, unsigned out, unsigned inverted, double* xi, double* keep) {
    for (unsigned left = out | inverted; left != 0; left &= left - 1) {
        const int l = std::countr_zero(left);
        const Seat seat{slot, lane + l};
        if (slots_.id(seat) == slots_.nobody) continue;
        const long p = slots_.id(seat) - 1;
        if ((inverted >> l & 1) != 0) inverted_ = std::min(inverted_, p);
        if ((out >> l & 1) == 0) continue;
        const Vec<dim> x = where(seat);
        finite_ = finite_ && x.allFinite();
        const Cell<dim> before = slots_.cell(seat);
        Cell<dim> cell = before;
        Vec<dim> local;
        if (!grid_.locate(x, cell, local)) lost_ = std::min(lost_, p);
        const bool stays = cell == before;
        for (int axis = 0; axis < dim; ++axis) xi[axis * lanes + l] = stays ? place(x[axis], cell[axis], axis) : 0.5;
        if (stays) {
            block.near = true;
            on_face_ = on_face_ || on_face(seat);
        } else {
            keep[l] = 0;
            enter_leaver({seat, cell});
        }
    }
}

/// In the order of blocks, ranks and lanes, in which the widest set of instructions meets them.
template <int dim>
void FastMpm<dim>::enter_leaver(const Leaver& leaver) {
    const auto order = [&](Seat s) { return slots_.rank(s.slot) * lanes + s.lane; };
    const int block = slots_.block_of(leaver.from.slot);
    leavers_.push_back(leaver);
    for (std::size_t k = leavers_.size() - 1; k > 0; --k) {
        const Seat before = leavers_[k - 1].from;
        if (slots_.block_of(before.slot) != block || order(before) < order(leaver.from)) break;
        std::swap(leavers_[k - 1], leavers_[k]);
    }
}

template <int dim>
void settle(const Sweep<dim>& sweep, Block& block, int slot, int lane, unsigned out, unsigned inverted, double* xi,
            double* keep) {
    static_cast<FastMpm<dim>*>(sweep.settle_for)->settle(block, slot, lane, out, inverted, xi, keep);
}

/// From the last to the first, so that a seat that is filled up is filled by one that stays.
template <int dim>
void FastMpm<dim>::move_leavers(Pass pass) {
    const bool quadratic = grid_.degree == 2;
    crossings_ += static_cast<long>(leavers_.size());
    for (; !leavers_.empty(); leavers_.pop_back()) {
        const auto [from, cell] = leavers_.back();
        Block& entered = slots_.blocks()[static_cast<std::size_t>(slots_.block_at(cell))];
        missed_ = missed_ || (!entered.swept && entered.first >= 0);
        dirty_ = dirty_ || !entered.swept || !entered.awake;
        entered.awake = true;
        const Seat seat = slots_.move(from, cell);
        Vec<dim> xi;
        for (int axis = 0; axis < dim; ++axis) xi[axis] = place(slots_.at(seat, Row<dim>::x + axis), cell[axis], axis);
        if (!(xi.minCoeff() >= beside && xi.maxCoeff() <= 1 - beside)) {
            entered.near = true;
            on_face_ = on_face_ || on_face(seat);
        }
        if (quadratic) share_out<2>(seat, cell, xi, pass);
        else share_out<1>(seat, cell, xi, pass);
    }
}

namespace {

/// One lane alone.
struct One {
    using V = double;
    static double all(double x) { return x; }
};

}  // namespace

/// What a particle that came after the sweep gives to the nodes.
template <int dim>
template <int degree>
void FastMpm<dim>::share_out(Seat seat, const Cell<dim>& cell, const Vec<dim>& xi, Pass pass) {
    using R = Row<dim>;
    Along<One, degree> splines[dim];
    for (std::size_t axis = 0; axis < dim; ++axis) {
        Ends<One> ends{};
        if constexpr (degree > 1) {
            const double* at = ends_[axis].data() + cell[static_cast<int>(axis)];
            const std::size_t n = ends_[axis].size() / 4;
            ends = {at[0], at[n], at[2 * n], at[3 * n]};
        }
        fill<One, degree>(splines[axis], xi[static_cast<int>(axis)], ends);
    }
    Sums<One, dim, degree> sums{};
    double v[dim];
    for (int c = 0; c < dim; ++c) v[c] = slots_.at(seat, R::v + c);
    add_mass<dim - 1, true, true, One, dim, degree>(splines, slots_.at(seat, R::m), v, sums.m, sums.p, 0);
    const double share = -slots_.at(seat, R::volume) * per_h_;
    for (int c = 0; c < dim; ++c) {
        double t[dim];
        for (int i = 0; i < dim; ++i) t[i] = share * slots_.at(seat, R::sigma + (i == c ? i : dim + i + c - 1));
        add_force<dim - 1, false, One, dim, degree>(splines, 0.0, t, sums.f, c, 0);
    }
    long first = 0;
    for (int axis = 0; axis < dim; ++axis) first += cell[axis] * slots_.row_of_nodes(axis);
    for (int k = 0; k < Sums<One, dim, degree>::nodes; ++k) {
        const int j = k / (degree + 1);
        const long node = first + k % (degree + 1) + j % (degree + 1) * slots_.row_of_nodes(1) +
                          j / (degree + 1) * slots_.row_of_nodes(2);
        at(m_, node) += sums.m[k];
        for (std::size_t c = 0; c < dim; ++c) {
            if (pass != Pass::follow) at(p_[c], node) += sums.p[k][c];
            if (pass != Pass::kick_move) at(f_[c], node) += sums.f[k][c];
        }
    }
}

/// visit(node) for the nodes that a particle touches.
template <int dim>
template <class Visit>
void FastMpm<dim>::each_touched(Seat seat, Visit&& visit) const {
    const Cell<dim> cell = slots_.cell(seat);
    const int count = grid_.degree + 1;
    for (int k = 0; k < power(count, dim); ++k) {
        long node = 0;
        for (int axis = 0, rest = k; axis < dim; ++axis, rest /= count)
            node += (cell[axis] + rest % count) * slots_.row_of_nodes(axis);
        visit(node);
    }
}

template <int dim>
bool FastMpm<dim>::find_touches() {
    touches_.clear();
    slots_.each([&](Seat seat) {
        if (!on_face(seat)) return;
        each_touched(seat, [&](long node) {
            if (!(at(m_, node) > 0)) touches_.push_back({node, seat});
        });
    });
    std::ranges::stable_sort(touches_, {}, &Touch::node);
    return !touches_.empty();
}

/// A node without mass moves as the particles that touch it, so that none of them sees a jump.
template <int dim>
void FastMpm<dim>::lend_velocity() {
    for (std::size_t first = 0, last = 0; first < touches_.size(); first = last) {
        const long node = touches_[first].node;
        Vec<dim> sum = Vec<dim>::Zero();
        for (last = first; last < touches_.size() && touches_[last].node == node; ++last) {
            for (int c = 0; c < dim; ++c) sum[c] += slots_.at(touches_[last].by, Row<dim>::v + c);
        }
        for (int c = 0; c < dim; ++c)
            at(v_[static_cast<std::size_t>(c)], node) = sum[c] / static_cast<double>(last - first);
    }
    for (const auto& [node, axis] : held_) {
        const auto touched = std::ranges::equal_range(touches_, node, {}, &Touch::node);
        if (!touched.empty()) at(v_[static_cast<std::size_t>(axis)], node) = 0;
    }
}

template class FastMpm<1>;
template class FastMpm<2>;
template class FastMpm<3>;
template void settle(const Sweep<1>&, Block&, int, int, unsigned, unsigned, double*, double*);
template void settle(const Sweep<2>&, Block&, int, int, unsigned, unsigned, double*, double*);
template void settle(const Sweep<3>&, Block&, int, int, unsigned, unsigned, double*, double*);

}  // namespace ordo::solvers::mpm::fast
