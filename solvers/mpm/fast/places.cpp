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

/// The cell of x and its place there, as kernels find it; false `beside` a face and beyond the grid.
template <int dim>
bool FastMpm<dim>::stands_within(const Vec<dim>& x, Cell<dim>& cell, Vec<dim>& xi) const {
    bool within = true;
    for (int axis = 0; axis < dim; ++axis) {
        const double r = (x[axis] - grid_.lower[axis]) * per_h_;
        if (!(r > 0 && r < grid_.cells[axis])) return false;
        cell[axis] = static_cast<int>(r);
        xi[axis] = r - cell[axis];
        within = within && xi[axis] >= beside && xi[axis] <= 1 - beside;
    }
    return within;
}

template <int dim>
void FastMpm<dim>::settle(Hand<dim>& hand, Block& block, int slot, int lane, unsigned out, unsigned inverted,
                          double* xi, double* keep) {
    Told<dim>& told = hand.section->told;
    for (unsigned left = out | inverted; left != 0; left &= left - 1) {
        const int l = std::countr_zero(left);
        const Seat seat{slot, lane + l};
        if (slots_.id(seat) == slots_.nobody) continue;
        const long p = slots_.id(seat) - 1;
        if ((inverted >> l & 1) != 0) told.inverted = std::min(told.inverted, p);
        if ((out >> l & 1) == 0) continue;
        const Vec<dim> x = where(seat);
        Cell<dim> before;
        for (int axis = 0; axis < dim; ++axis) before[axis] = block.cell[axis] + (axis == 0 ? seat.lane : 0);
        Cell<dim> cell;
        Vec<dim> local;
        const bool within = stands_within(x, cell, local);
        if (!within) {
            told.finite = told.finite && x.allFinite();
            cell = before;
            if (!grid_.locate(x, cell, local)) told.lost = std::min(told.lost, p);
            for (int axis = 0; axis < dim; ++axis) local[axis] = place(x[axis], cell[axis], axis);
        }
        const bool stays = cell == before;
        for (int axis = 0; axis < dim; ++axis) xi[axis * lanes + l] = stays ? local[axis] : 0.5;
        if (stays) {
            block.near = true;
            told.on_face = told.on_face || on_face(seat);
        } else {
            keep[l] = 0;
            send(hand, seat, cell, local, !within);
        }
    }
}

/// Turns go by blocks, ranks and lanes, the order in which the widest set of instructions meets the particles.
template <int dim>
void FastMpm<dim>::send(Hand<dim>& hand, Seat from, const Cell<dim>& to, const Vec<dim>& xi, bool near) {
    auto& turns = hand.turns;
    const Turn turn{slots_.block_of(from.slot), slots_.rank(from.slot) * lanes + from.lane, hand.leaving.size()};
    auto& who = hand.leaving.emplace_back();
    slots_.take_out(from, who);
    who.to = to;
    who.block = slots_.block_at(to);
    who.xi = xi;
    who.near = near;
    who.far = (to - slots_.cell(from)).cwiseAbs().maxCoeff() > 2 * grid_.degree;
    turns.push_back(turn);
    for (std::size_t k = turns.size() - 1; k > 0; --k) {
        if (turns[k - 1].block != turn.block || turns[k - 1].place < turn.place) break;
        std::swap(turns[k - 1], turns[k]);
    }
}

template <int dim>
void settle(const Sweep<dim>& sweep, Block& block, int slot, int lane, unsigned out, unsigned inverted, double* xi,
            double* keep) {
    auto& hand = *static_cast<Hand<dim>*>(sweep.settle_for);
    hand.of->settle(hand, block, slot, lane, out, inverted, xi, keep);
}

/// Those who come to blocks before `ahead`, which will not be swept again; the others wait. Gaps that nobody has taken
/// are closed.
template <int dim>
void FastMpm<dim>::seat_travellers(Hand<dim>& hand, Pass pass, int ahead) {
    Section<dim>& section = *hand.section;
    Pool& pool = pool_of(section);
    auto& leaving = hand.leaving;
    auto& waiting = hand.waiting;
    auto& turns = hand.turns;
    const auto comes_later = [&](const Traveller<dim>& who) { return who.block >= ahead && who.block <= section.last; };
    const auto let_in = [&](const Traveller<dim>& who) {
        const bool here = who.block >= section.first && who.block <= section.last;
        if (!here || !seat(who, pass, section.told, pool)) section.later.push_back(who);
    };
    std::size_t later = 0;
    for (const auto& who : waiting) {
        if (comes_later(who)) waiting[later++] = who;
        else let_in(who);
    }
    waiting.resize(later);
    for (const Turn& turn : turns) {
        const auto& who = leaving[turn.who];
        if (comes_later(who)) waiting.push_back(who);
        else let_in(who);
    }
    section.told.crossings += static_cast<long>(turns.size());
    for (std::size_t k = 0; k < turns.size(); ++k) {
        const Seat gap = leaving[turns[k].who].from;
        if (slots_.id(gap) == slots_.nobody) slots_.close(gap);
        if (k + 1 == turns.size() || turns[k].block != turns[k + 1].block) slots_.trim(turns[k].block, pool);
    }
    leaving.clear();
    turns.clear();
}

/// False where the pool has no slot for it.
template <int dim>
bool FastMpm<dim>::seat(const Traveller<dim>& who, Pass pass, Told<dim>& told, Pool& pool) {
    Block& entered = slots_.blocks()[static_cast<std::size_t>(who.block)];
    const bool was_empty = entered.first < 0;
    const Seat seat = slots_.put_in(who, pool);
    if (seat.slot < 0) return false;
    told.missed = told.missed || (!entered.swept && !was_empty) || (who.far && !everywhere_ && !entered.awake);
    told.dirty = told.dirty || !entered.swept || !entered.awake;
    entered.swept = entered.awake = true;
    if (who.near) {
        entered.near = true;
        told.on_face = told.on_face || on_face(seat);
    }
    if (grid_.degree == 2) share_out<2>(who, pass);
    else share_out<1>(who, pass);
    return true;
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
void FastMpm<dim>::share_out(const Traveller<dim>& who, Pass pass) {
    using R = Row<dim>;
    Along<One, degree> splines[dim];
    long first = 0;
    for (std::size_t axis = 0; axis < dim; ++axis) {
        const int along = who.to[static_cast<int>(axis)];
        first += along * slots_.row_of_nodes(static_cast<int>(axis));
        Ends<One> ends{};
        if constexpr (degree > 1) {
            const double* at = ends_[axis].data() + along;
            const std::size_t n = ends_[axis].size() / 4;
            ends = {at[0], at[n], at[2 * n], at[3 * n]};
        }
        fill<One, degree>(splines[axis], who.xi[static_cast<int>(axis)], ends);
    }
    Sums<One, dim, degree> sums{};
    double v[dim];
    for (int c = 0; c < dim; ++c) v[c] = who.row[R::v + c];
    add_mass<dim - 1, true, true, One, dim, degree>(splines, who.row[R::m], v, sums.m, sums.p, 0);
    const double share = -who.row[R::volume] * per_h_;
    for (int c = 0; c < dim; ++c) {
        double t[dim];
        for (int i = 0; i < dim; ++i) t[i] = share * who.row[R::sigma + (i == c ? i : dim + i + c - 1)];
        add_force<dim - 1, false, One, dim, degree>(splines, 0.0, t, sums.f, c, 0);
    }
    double* m = m_.front().at;
    for (int k = 0; k < Sums<One, dim, degree>::nodes; ++k) {
        const int j = k / (degree + 1);
        const long node = first + k % (degree + 1) + j % (degree + 1) * slots_.row_of_nodes(1) +
                          j / (degree + 1) * slots_.row_of_nodes(2);
        m[node] += sums.m[k];
        for (std::size_t c = 0; c < dim; ++c) {
            if (pass != Pass::follow) p_[c].front().at[node] += sums.p[k][c];
            if (pass != Pass::kick_move) f_[c].front().at[node] += sums.f[k][c];
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
