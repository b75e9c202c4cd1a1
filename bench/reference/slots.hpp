#pragma once
// The floor: particles in fixed slots of their cells, which they do not leave. A vector holds the same slot of as many
// cells as it has lanes, one in each of equal strips across the last axis: nothing is gathered, and no two lanes meet
// at a node. Particles go to the grid of step n + 1 as they come from that of step n. Included once an instruction set.
#include "bench/reference/stencil.hpp"

namespace ordo::bench {

/// Where a run's vectors lie, and its numbers. Rows are cells of a strip along the last axis.
struct SlotRun {
    double* slots;  ///< [row][...][cell of axis 0][slot]: x, v, sigma, V, m, each `lanes` values
    double* nodes;  ///< [row][...][node of axis 0]: m, momentum, force, each `lanes` values
    double* next;   ///< the same for the next step
    int cells[3];   ///< of one strip; those beyond dim are 1
    double h, dt, lambda, mu;
};

template <class V, int dim, int degree>
struct Slots {
    static constexpr int lanes = sizeof(V) / sizeof(double);
    static constexpr int per_axis = degree + 1;
    static constexpr int nodes = power(per_axis, dim);
    static constexpr int components = dim * (dim + 1) / 2;

    struct Slot {
        V x[dim], v[dim], sigma[components], volume, m;
    };
    struct Node {
        V m, v[dim], a[dim];  ///< v and a hold momentum and force while they are being gathered
    };
    struct Stencil {
        V w[dim][per_axis], slope[dim][per_axis];
    };

    /// One step: from the sums in `nodes` to those in `next`, whose strips are still to be joined at their borders.
    /// `back` false: particles to `next` only.
    template <bool back>
    static void step(const SlotRun& given) {
        const SlotRun run = given;
        const double inv_h = 1 / run.h;
        const int wide = run.cells[0] + degree;
        const int slab = dim == 1 ? 1 : dim == 2 ? wide : wide * (run.cells[1] + degree);
        const int rows = run.cells[dim - 1];
        auto* slot = reinterpret_cast<Slot*>(run.slots);
        auto* old = reinterpret_cast<Node*>(run.nodes);
        auto* next = reinterpret_cast<Node*>(run.next);
        V strip;
        for (int lane = 0; lane < lanes; ++lane) strip[lane] = lane * rows;
        if (back) accelerate(old, degree * slab, run.dt);
        for (int i = 0; i < degree * slab; ++i) next[i] = Node{};
        for (int row = 0; row < rows; ++row) {
            Node* ahead = old + (row + degree) * slab;
            if (back) accelerate(ahead, slab, run.dt);
            for (int i = 0; i < slab; ++i) next[(row + degree) * slab + i] = Node{};
            for (int cy = 0; cy < (dim == 3 ? run.cells[1] : 1); ++cy) {
                for (int cx = 0; cx < (dim == 1 ? 1 : run.cells[0]); ++cx) {
                    const int node = row * slab + cy * wide + cx;
                    V corner[dim];
                    if constexpr (dim > 1) corner[0] = V{} + cx;
                    if constexpr (dim > 2) corner[1] = V{} + cy;
                    corner[dim - 1] = strip + row;
                    slot = visit_cell<back>(run, inv_h, slot, corner, old + node, next + node, wide, slab);
                }
            }
        }
    }

private:
    /// All slots of a cell, with the sums of its nodes at hand.
    template <bool back>
    [[gnu::always_inline]] static Slot* visit_cell(const SlotRun& run, double inv_h, Slot* slot, const V (&corner)[dim],
                                                   const Node* old, Node* next, int wide, int slab) {
        Node sum[nodes];
        each_offset(
            wide, slab, [&](int k, int offset) __attribute__((always_inline)) { sum[k] = next[offset]; });
        for (int k = 0; k < power(2, dim); ++k, ++slot) {
            Slot now = *slot;
            if (back) {
                from_grid(run, inv_h, now, corner, old, wide, slab);
                *slot = now;
            }
            to_grid(inv_h, now, corner, sum);
        }
        each_offset(
            wide, slab, [&](int k, int offset) __attribute__((always_inline)) { next[offset] = sum[k]; });
        return slot;
    }

    static void accelerate(Node* node, int count, double dt) {
        for (int i = 0; i < count; ++i) {
            const V inverse = 1.0 / node[i].m;
            for (int a = 0; a < dim; ++a) {
                node[i].a[a] *= inverse;
                node[i].v[a] = node[i].v[a] * inverse + dt * node[i].a[a];
            }
        }
    }

    /// The first term begins the sum: adding it to zero is an operation that no compiler may leave out.
    [[gnu::always_inline]] static void add(V& sum, V term, int k) { sum = k == 0 ? term : sum + term; }

    [[gnu::always_inline]] static void meet(double inv_h, const Slot& slot, const V (&corner)[dim], Stencil& s) {
        for (int a = 0; a < dim; ++a) splines<V, degree>(slot.x[a] * inv_h - corner[a], inv_h, s.w[a], s.slope[a]);
    }

    /// visit(k, offset) for each node k of a cell.
    template <class Visit>
    [[gnu::always_inline]] static void each_offset(int wide, int slab, Visit&& visit) {
        const int stride[3]{1, dim == 2 ? slab : wide, slab};
#pragma GCC unroll 9
        for (int k = 0; k < nodes; ++k) {
            int offset = k % per_axis;
            if constexpr (dim > 1) offset += k / per_axis % per_axis * stride[1];
            if constexpr (dim > 2) offset += k / (per_axis * per_axis) * stride[2];
            visit(k, offset);
        }
    }

    /// Function k of the cell and its gradient.
    [[gnu::always_inline]] static V weight(const Stencil& s, int k, V (&grad)[dim]) {
        const int k0 = k % per_axis;
        const int k1 = k / per_axis % per_axis;
        const int k2 = k / (per_axis * per_axis);
        V w = s.w[0][k0];
        grad[0] = s.slope[0][k0];
        if constexpr (dim > 1) {
            grad[0] *= s.w[1][k1];
            grad[1] = w * s.slope[1][k1];
            w *= s.w[1][k1];
        }
        if constexpr (dim > 2) {
            grad[0] *= s.w[2][k2];
            grad[1] *= s.w[2][k2];
            grad[2] = w * s.slope[2][k2];
            w *= s.w[2][k2];
        }
        return w;
    }

    [[gnu::always_inline]] static void from_grid(const SlotRun& run, double inv_h, Slot& slot, const V (&corner)[dim],
                                                 const Node* node, int wide, int slab) {
        Stencil s;
        meet(inv_h, slot, corner, s);
        V dv[dim], dx[dim], L[dim][dim];
        each_offset(
            wide, slab, [&](int k, int offset) __attribute__((always_inline)) {
                V grad[dim];
                const V w = weight(s, k, grad);
                for (int a = 0; a < dim; ++a) {
                    add(dv[a], w * node[offset].a[a], k);
                    add(dx[a], w * node[offset].v[a], k);
                    for (int b = 0; b < dim; ++b) add(L[a][b], grad[b] * node[offset].v[a], k);
                }
            });
        V trace;
        for (int a = 0; a < dim; ++a) {
            slot.v[a] += run.dt * dv[a];
            slot.x[a] += run.dt * dx[a];
            add(trace, run.dt * L[a][a], a);
        }
        slot.volume *= 1.0 + trace;
        const double mu = run.dt * run.mu;
        for (int a = 0, k = 0; a < dim; ++a) {
            for (int b = 0; b <= a; ++b, ++k) {
                slot.sigma[k] += mu * (L[a][b] + L[b][a]);
                if (a == b) slot.sigma[k] += run.lambda * trace;
            }
        }
    }

    [[gnu::always_inline]] static void to_grid(double inv_h, const Slot& slot, const V (&corner)[dim],
                                               Node (&sum)[nodes]) {
        Stencil s;
        meet(inv_h, slot, corner, s);
        V p[dim], P[dim][dim];
        for (int a = 0, k = 0; a < dim; ++a) {
            p[a] = slot.m * slot.v[a];
            for (int b = 0; b <= a; ++b, ++k) P[a][b] = P[b][a] = slot.volume * slot.sigma[k];
        }
#pragma GCC unroll 9
        for (int k = 0; k < nodes; ++k) {
            V grad[dim];
            const V w = weight(s, k, grad);
            sum[k].m += w * slot.m;
            for (int a = 0; a < dim; ++a) {
                sum[k].v[a] += w * p[a];
                for (int b = 0; b < dim; ++b) sum[k].a[a] -= P[a][b] * grad[b];
            }
        }
    }
};

/// The steps of one instruction set: [dim - 1][degree - 1], null where there is none.
struct SlotSteps {
    const char* name;
    int lanes;
    void (*begin[3][2])(const SlotRun&);
    void (*step[3][2])(const SlotRun&);
};

template <class V>
SlotSteps slot_steps(const char* name) {
    return {name,
            sizeof(V) / sizeof(double),
            {{Slots<V, 1, 1>::template step<false>, Slots<V, 1, 2>::template step<false>},
             {Slots<V, 2, 1>::template step<false>, Slots<V, 2, 2>::template step<false>},
             {Slots<V, 3, 1>::template step<false>, nullptr}},
            {{Slots<V, 1, 1>::template step<true>, Slots<V, 1, 2>::template step<true>},
             {Slots<V, 2, 1>::template step<true>, Slots<V, 2, 2>::template step<true>},
             {Slots<V, 3, 1>::template step<true>, nullptr}}};
}

SlotSteps slots_avx512();
SlotSteps slots_avx2();
SlotSteps slots_baseline();

}  // namespace ordo::bench
