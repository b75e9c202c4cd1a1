#pragma once
// The sweep over the blocks and the pass over the nodes. Included by the source of each instruction set alone.
#include "solvers/mpm/fast/slot.hpp"

namespace ordo::solvers::mpm::fast {

/// What lanes have given to nodes that lie in the lanes after them.
template <class Isa, int dim, int degree>
struct Carry {
    static constexpr int rows = power(degree + 1, dim - 1);
    typename Isa::V field[1 + 2 * dim][rows][degree];
};

/// Node n takes what cell n gives to its first node, n - 1 to its second, ...: a fixed order, however many lanes there
/// are.
template <class Isa, int degree>
[[gnu::always_inline]] inline void add_to_nodes(double* node, const typename Isa::V* const (&sums)[degree + 1],
                                                typename Isa::V* carry) {
    typename Isa::V sum = *sums[0];
    typename Isa::V before = Isa::template shifted<1>(carry[0], *sums[1]);
    if constexpr (degree == 2) before += Isa::template shifted<2>(carry[1], *sums[2]);
    Isa::store(node, Isa::load(node) + (sum + before));
#pragma GCC unroll 2
    for (int k = 0; k < degree; ++k) carry[k] = *sums[k + 1];
}

/// The place of field `number` at the first node of a row: mass, momentum, force.
template <int dim>
[[gnu::always_inline]] inline double* field_at(const Sweep<dim>& s, int number, int row, int degree, long node) {
    double* base = number == 0 ? s.m : number <= dim ? s.p[number - 1] : s.f[number - 1 - dim];
    long at = node;
    if constexpr (dim > 1) at += row % (degree + 1) * s.row[1];
    if constexpr (dim > 2) at += row / (degree + 1) * s.row[2];
    return base + at;
}

template <class Isa, int dim, int degree, bool total, Pass pass>
struct Sweeper {
    using V = typename Isa::V;
    using D = Does<pass>;

    [[gnu::always_inline]] static bool gives(int field) {
        if (field == 0) return D::mass && (!total || pass == Pass::begin);
        return field <= dim ? bool(D::momentum) : D::force || D::load;
    }

    /// The last lanes' gifts beyond a block that no other follows.
    static void flush(const Sweep<dim>& s, long node, Carry<Isa, dim, degree>& carry) {
        const V zero = Isa::all(0);
        const V* sums[degree + 1];
        for (int k = 0; k <= degree; ++k) sums[k] = &zero;
        for (int field = 0; field < 1 + 2 * dim; ++field) {
            if (!gives(field)) continue;
            for (int row = 0; row < Carry<Isa, dim, degree>::rows; ++row)
                add_to_nodes<Isa, degree>(field_at<dim>(s, field, row, degree, node), sums, carry.field[field][row]);
        }
    }

    [[gnu::always_inline]] static void give(const Sweep<dim>& s, long node, const Sums<Isa, dim, degree>& sums,
                                            Carry<Isa, dim, degree>& carry) {
#pragma GCC unroll 7
        for (int field = 0; field < 1 + 2 * dim; ++field) {
            if (!gives(field)) continue;
#pragma GCC unroll 9
            for (int row = 0; row < Carry<Isa, dim, degree>::rows; ++row) {
                const V* of[degree + 1];
#pragma GCC unroll 3
                for (int k = 0; k <= degree; ++k) {
                    const int at = row * (degree + 1) + k;
                    if (field == 0) of[k] = &sums.m[at];
                    else if (field <= dim) of[k] = &sums.p[at][field > 0 && field <= dim ? field - 1 : 0];
                    else of[k] = &sums.f[at][field > dim ? field - 1 - dim : 0];
                }
                add_to_nodes<Isa, degree>(field_at<dim>(s, field, row, degree, node), of, carry.field[field][row]);
            }
        }
    }

    static void run(Sweep<dim>& s) {
        Carry<Isa, dim, degree> carry = {};
        long next = -1;  // node after the block before
        for (long k = 0; k < s.count; ++k) {
            Block& block = s.blocks[s.order[k]];
            if (block.node != next && next >= 0) flush(s, next, carry);
            next = block.node + lanes;
            const bool near = block.near;
            if (D::move) block.near = false;
            for (int lane = 0; lane < lanes; lane += Isa::width) {
                const Lanes<Isa, dim, degree, total, pass> of(s, block, lane, near);
                Sums<Isa, dim, degree> sums = {};
                for (int slot = block.first; slot >= 0; slot = s.next[slot]) of.slot(slot, sums);
                give(s, block.node + lane, sums, carry);
            }
        }
        if (next >= 0) flush(s, next, carry);
    }
};

template <class Isa, int dim>
void over_nodes(const NodePass<dim>& pass) {
    using V = typename Isa::V;
    const V zero = Isa::all(0);
    const V kick = Isa::all(pass.kick);
    const V damping = Isa::all(pass.damping);
    for (long k = 0; k < pass.count; ++k) {
        for (int lane = 0; lane < lanes; lane += Isa::width) {
            const long i = pass.first[k] + lane;
            const V m = Isa::load(pass.m + i);
            const V per_m = Isa::where_positive(m, Isa::all(1) / m);
#pragma GCC unroll 3
            for (int c = 0; c < dim; ++c) {
                const V p = Isa::load(pass.p[c] + i);
                V v = pass.takes_p ? p * per_m : Isa::load(pass.v[c] + i);
                if (pass.takes_f) {
                    V f = Isa::load(pass.f[c] + i);
                    if (pass.damping != 0) f -= damping * p;
                    const V a = f * per_m;
                    Isa::store(pass.a[c] + i, a);
                    Isa::store(pass.f[c] + i, zero);
                    if (pass.adds) v += kick * a;
                }
                Isa::store(pass.v[c] + i, v);
                if (pass.takes_p || pass.takes_f) Isa::store(pass.p[c] + i, zero);
            }
            if (pass.ends_m) Isa::store(pass.m + i, zero);
        }
    }
}

template <class Isa, int dim, int degree, bool total, int pass = 0>
void list(Kernels<dim>& kernels) {
    if constexpr (pass < static_cast<int>(Pass::count)) {
        kernels.sweep[pass] = &Sweeper<Isa, dim, degree, total, static_cast<Pass>(pass)>::run;
        list<Isa, dim, degree, total, pass + 1>(kernels);
    }
}

/// The kernels of one instruction set for one run.
template <class Isa, int dim>
Kernels<dim> kernels_of(int degree, bool total) {
    Kernels<dim> kernels = {};
    if (degree == 1 && !total) list<Isa, dim, 1, false>(kernels);
    if (degree == 1 && total) list<Isa, dim, 1, true>(kernels);
    if constexpr (dim < 3) {  // 27 nodes in every lane would be many kernels for few runs
        if (degree == 2 && !total) list<Isa, dim, 2, false>(kernels);
        if (degree == 2 && total) list<Isa, dim, 2, true>(kernels);
    }
    kernels.nodes = &over_nodes<Isa, dim>;
    return kernels;
}

}  // namespace ordo::solvers::mpm::fast
