#pragma once
// Splines of the cells of several lanes at once, and sums over the nodes that they touch. Included by kernels alone:
// every function here is a template over the instruction set, so that none is shared between sets.
#include "solvers/mpm/fast/sweep.hpp"

namespace ordo::solvers::mpm::fast {

/// Values and slopes (times h) of the degree + 1 splines of a cell along one axis.
template <class Isa, int degree>
struct Along {
    typename Isa::V N[degree + 1];
    typename Isa::V S[degree + 1];
};

/// How quadratic splines are clamped: 1 / (1 + before) and `before`, 1 / (1 + after) and `after`, where `before` and
/// `after` are 1 within the grid and 0 in its first and last cell.
template <class Isa>
struct Ends {
    typename Isa::V per_before, before, per_after, after;
};

template <class Isa, int dim, int axis>
[[gnu::always_inline]] inline Ends<Isa> ends_of(const Sweep<dim>& s, long cell) {
    const double* at = s.ends[axis] + cell;
    const long n = s.cells[axis];
    if constexpr (axis == 0) return {Isa::load(at), Isa::load(at + n), Isa::load(at + 2 * n), Isa::load(at + 3 * n)};
    else return {Isa::all(at[0]), Isa::all(at[n]), Isa::all(at[2 * n]), Isa::all(at[3 * n])};
}

/// The recursion of [DeBoor2001] written out; sums of products that are not negative, so that small values keep their
/// digits.
template <class Isa, int degree>
[[gnu::always_inline]] inline void fill(Along<Isa, degree>& s, typename Isa::V xi, const Ends<Isa>& ends) {
    using V = typename Isa::V;
    const V one = Isa::all(1);
    const V rest = one - xi;
    if constexpr (degree == 1) {
        s.N[0] = rest;
        s.N[1] = xi;
        s.S[0] = -one;
        s.S[1] = one;
    } else {
        const V left = rest * ends.per_before;
        const V right = xi * ends.per_after;
        s.N[0] = rest * left;
        s.N[1] = (xi + ends.before) * left + (rest + ends.after) * right;
        s.N[2] = xi * right;
        s.S[0] = -(left + left);
        s.S[2] = right + right;
        s.S[1] = (left + left) - (right + right);
    }
}

/// sum_i S_i f_i over the nodes that a cell touches; `node` is the first of them.
template <int axis, class Isa, int dim, int degree>
[[gnu::always_inline]] inline typename Isa::V value(const Along<Isa, degree>* s, const double* node,
                                                    const Sweep<dim>& g) {
    using V = typename Isa::V;
    V sum;
#pragma GCC unroll 4
    for (int k = 0; k <= degree; ++k) {
        V part;
        if constexpr (axis == 0) part = Isa::load(node + k);
        else part = value<axis - 1>(s, node + k * g.row[axis], g);
        if (k == 0) sum = s[axis].N[0] * part;
        else sum += s[axis].N[k] * part;
    }
    return sum;
}

/// The same, and its gradient times h.
template <int axis, class Isa, int dim, int degree>
[[gnu::always_inline]] inline typename Isa::V value_and_gradient(const Along<Isa, degree>* s, const double* node,
                                                                 const Sweep<dim>& g, typename Isa::V* gradient) {
    using V = typename Isa::V;
    V sum;
#pragma GCC unroll 4
    for (int k = 0; k <= degree; ++k) {
        V part;
        V slope[axis + 1];
        if constexpr (axis == 0) part = Isa::load(node + k);
        else part = value_and_gradient<axis - 1>(s, node + k * g.row[axis], g, slope);
        if (k == 0) {
            sum = s[axis].N[0] * part;
#pragma GCC unroll 2
            for (int i = 0; i < axis; ++i) gradient[i] = s[axis].N[0] * slope[i];
            gradient[axis] = s[axis].S[0] * part;
        } else {
            sum += s[axis].N[k] * part;
#pragma GCC unroll 2
            for (int i = 0; i < axis; ++i) gradient[i] += s[axis].N[k] * slope[i];
            gradient[axis] += s[axis].S[k] * part;
        }
    }
    return sum;
}

/// sum_i[k] += S_k q for the nodes k of a cell, axis 0 fastest, and with it their momentum.
template <int axis, bool mass, bool momentum, class Isa, int dim, int degree>
[[gnu::always_inline]] inline void add_mass(const Along<Isa, degree>* s, typename Isa::V q,
                                            const typename Isa::V (&v)[dim], typename Isa::V* m,
                                            typename Isa::V (*p)[dim], int index) {
#pragma GCC unroll 4
    for (int k = 0; k <= degree; ++k) {
        const typename Isa::V share = s[axis].N[k] * q;
        const int at = index * (degree + 1) + k;
        if constexpr (axis == 0) {
            if constexpr (mass) m[at] += share;
            if constexpr (momentum) {
#pragma GCC unroll 3
                for (int c = 0; c < dim; ++c) p[at][c] += share * v[c];
            }
        } else {
            add_mass<axis - 1, mass, momentum, Isa, dim, degree>(s, share, v, m, p, at);
        }
    }
}

/// f[k][c] += S_k q + t . (h grad S_k); without q where `with_q` is false.
template <int axis, bool with_q, class Isa, int dim, int degree>
[[gnu::always_inline]] inline void add_force(const Along<Isa, degree>* s, typename Isa::V q, const typename Isa::V* t,
                                             typename Isa::V (*f)[dim], int c, int index) {
    using V = typename Isa::V;
#pragma GCC unroll 4
    for (int k = 0; k <= degree; ++k) {
        V share = s[axis].S[k] * t[axis];
        if constexpr (with_q) share += s[axis].N[k] * q;
        const int at = index * (degree + 1) + k;
        if constexpr (axis == 0) {
            f[at][c] += share;
        } else {
            V less[axis];
#pragma GCC unroll 2
            for (int i = 0; i < axis; ++i) less[i] = s[axis].N[k] * t[i];
            add_force<axis - 1, true, Isa, dim, degree>(s, share, less, f, c, at);
        }
    }
}

}  // namespace ordo::solvers::mpm::fast
