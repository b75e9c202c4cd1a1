#pragma once
// One slot of particles, as many lanes at once as an instruction set has: gather from the nodes, update, scatter to
// sums. Included by kernels alone.
#include "solvers/mpm/fast/along.hpp"
#include "solvers/mpm/fast/material.hpp"

namespace ordo::solvers::mpm::fast {

constexpr int power(int base, int exponent) { return exponent == 0 ? 1 : base * power(base, exponent - 1); }

/// What a pass does.
template <Pass pass>
struct Does {
    enum : bool {
        kick = pass == Pass::last || pass == Pass::kick || pass == Pass::kick_move,
        move = pass == Pass::last || pass == Pass::follow || pass == Pass::follow_two || pass == Pass::kick_move,
        by_u = pass == Pass::follow_two,
        strain = pass == Pass::last || pass == Pass::follow || pass == Pass::follow_two || pass == Pass::first,
        gather = kick || move || strain,
        mass = pass == Pass::begin || pass == Pass::last || pass == Pass::follow || pass == Pass::follow_two ||
               pass == Pass::kick_move,
        momentum = (mass && pass != Pass::follow) || pass == Pass::kick,
        force = pass == Pass::begin || strain,
        load = pass == Pass::load,
    };
};

/// Sums over the particles of some lanes for each node of their cells, axis 0 fastest.
template <class Isa, int dim, int degree>
struct Sums {
    static constexpr int nodes = power(degree + 1, dim);
    typename Isa::V m[nodes];
    typename Isa::V p[nodes][dim];
    typename Isa::V f[nodes][dim];
};

/// Lanes `lane` to `lane + width` of the slots of one block.
template <class Isa, int dim, int degree, bool total, Pass pass>
struct Lanes {
    using V = typename Isa::V;
    using R = Row<dim>;
    using D = Does<pass>;
    using Functions = Along<Isa, degree>;

    Sweep<dim>& s;
    Block& block;
    const int lane;
    const bool near;  ///< a particle may stand beside a face
    Ends<Isa> ends[dim];
    V cell[dim];

    [[gnu::always_inline]] Lanes(Sweep<dim>& sweep, Block& of, int from, bool beside_face)
        : s(sweep), block(of), lane(from), near(beside_face) {
        cell[0] = Isa::all(of.cell[0] + from) + Isa::count();
        if constexpr (degree > 1) ends[0] = ends_of<Isa, dim, 0>(s, of.cell[0] + from);
        if constexpr (dim > 1) {
            cell[1] = Isa::all(of.cell[1]);
            if constexpr (degree > 1) ends[1] = ends_of<Isa, dim, 1>(s, of.cell[1]);
        }
        if constexpr (dim > 2) {
            cell[2] = Isa::all(of.cell[2]);
            if constexpr (degree > 1) ends[2] = ends_of<Isa, dim, 2>(s, of.cell[2]);
        }
    }

    [[gnu::always_inline]] void slot(int number, Sums<Isa, dim, degree>& sums) const {
        double* const at = s.slots + number * s.stride + lane;
        V x[dim], xi[dim], v[dim];
        V m = Isa::load(at + R::m * lanes);
        V volume = Isa::load(at + R::volume * lanes);
        Matrix<Isa, dim> sigma;
        Functions functions[dim];
        if constexpr (!total || D::move) load(at + R::x * lanes, x);
        if constexpr (D::kick || D::momentum) load(at + R::v * lanes, v);
        if constexpr (D::force) load_symmetric(at + R::sigma * lanes, sigma);
        old_place(at, x, xi);
        fill(functions, xi);
        if constexpr (D::gather) {
            const double* const v_node[3] = {s.v[0] + block.node + lane, dim > 1 ? s.v[dim > 1] + block.node + lane : 0,
                                             dim > 2 ? s.v[dim > 2 ? 2 : 0] + block.node + lane : 0};
            V moved[dim];
            Matrix<Isa, dim> dL;
            const V dt = Isa::where_positive(m, Isa::all(s.dt));  // what is no particle stays as it is
            if constexpr (D::kick) kick(functions, Isa::where_positive(m, Isa::all(s.kick)), v);
            if constexpr (D::strain || D::move) {
#pragma GCC unroll 3
                for (int c = 0; c < dim; ++c) {
                    if constexpr (D::strain) {
                        V slope[dim];
                        moved[c] = value_and_gradient<dim - 1>(functions, v_node[c], s, slope);
#pragma GCC unroll 3
                        for (int i = 0; i < dim; ++i) dL.at[c][i] = (dt * Isa::all(s.per_h)) * slope[i];
                    } else {
                        moved[c] = value<dim - 1>(functions, v_node[c], s);
                    }
                    if constexpr (D::by_u) moved[c] = value<dim - 1>(functions, s.u[c] + block.node + lane, s);
                    if constexpr (D::move) x[c] += dt * moved[c];
                }
            }
            unsigned inverted = 0;
            if constexpr (D::strain) inverted = strain(at, dL, sigma, volume);
            if constexpr (D::kick) store(at + R::v * lanes, v);
            if constexpr (D::move) store(at + R::x * lanes, x);
            new_place(number, inverted, x, xi, m, volume);
            if constexpr (!total && D::move) fill(functions, xi);
        }
        scatter(number, at, functions, m, volume, v, sigma, sums);
    }

private:
    [[gnu::always_inline]] static void load(const double* at, V (&to)[dim]) {
#pragma GCC unroll 3
        for (int c = 0; c < dim; ++c) to[c] = Isa::load(at + c * lanes);
    }
    [[gnu::always_inline]] static void store(double* at, const V (&from)[dim]) {
#pragma GCC unroll 3
        for (int c = 0; c < dim; ++c) Isa::store(at + c * lanes, from[c]);
    }
    [[gnu::always_inline]] static void load_symmetric(const double* at, Matrix<Isa, dim>& to) {
#pragma GCC unroll 3
        for (int i = 0; i < dim; ++i) {
            to.at[i][i] = Isa::load(at + i * lanes);
#pragma GCC unroll 3
            for (int j = i + 1; j < dim; ++j) to.at[i][j] = to.at[j][i] = Isa::load(at + (dim + i + j - 1) * lanes);
        }
    }
    [[gnu::always_inline]] static void store_symmetric(double* at, const Matrix<Isa, dim>& from) {
#pragma GCC unroll 3
        for (int i = 0; i < dim; ++i) {
            Isa::store(at + i * lanes, from.at[i][i]);
#pragma GCC unroll 3
            for (int j = i + 1; j < dim; ++j) Isa::store(at + (dim + i + j - 1) * lanes, from.at[i][j]);
        }
    }
    [[gnu::always_inline]] static void load_matrix(const double* at, Matrix<Isa, dim>& to) {
#pragma GCC unroll 9
        for (int k = 0; k < dim * dim; ++k) to.at[k % dim][k / dim] = Isa::load(at + k * lanes);
    }
    [[gnu::always_inline]] static void store_matrix(double* at, const Matrix<Isa, dim>& from) {
#pragma GCC unroll 9
        for (int k = 0; k < dim * dim; ++k) Isa::store(at + k * lanes, from.at[k % dim][k / dim]);
    }

    /// By a product with 1 / h, or by the quotient beside a face; the same wherever it is asked for.
    [[gnu::always_inline]] void old_place(const double* at, const V (&x)[dim], V (&xi)[dim]) const {
        if constexpr (total) {
            load(at + R::xi * lanes, xi);
        } else {
#pragma GCC unroll 3
            for (int c = 0; c < dim; ++c) {
                const V r = x[c] - Isa::all(s.lower[c]);
                xi[c] = r * Isa::all(s.per_h) - cell[c];
                if (near) xi[c] = Isa::where_within(xi[c], beside, 1 - beside, r / Isa::all(s.h) - cell[c]);
            }
        }
    }

    [[gnu::always_inline]] void new_place(int number, unsigned inverted, const V (&x)[dim], V (&xi)[dim], V& m,
                                          V& volume) const {
        unsigned out = 0;
        if constexpr (!total && D::move) {
#pragma GCC unroll 3
            for (int c = 0; c < dim; ++c) {
                xi[c] = (x[c] - Isa::all(s.lower[c])) * Isa::all(s.per_h) - cell[c];
                out |= Isa::not_within(xi[c], beside, 1 - beside);
            }
        }
        if constexpr (total && D::move) {
#pragma GCC unroll 3
            for (int c = 0; c < dim; ++c) {
                double* sum = s.travelled[c] + lane;
                Isa::store(sum, Isa::load(sum) + x[c]);
            }
        }
        if (out | inverted) [[unlikely]] {
            double place[dim * lanes];
            double keep[Isa::width];
#pragma GCC unroll 3
            for (int c = 0; c < dim; ++c) Isa::store(place + c * lanes, xi[c]);
            Isa::store(keep, Isa::all(1));
            settle<dim>(s, block, number, lane, out, inverted, place, keep);
            load(place, xi);
            m *= Isa::load(keep);
            volume *= Isa::load(keep);
        }
    }

    [[gnu::always_inline]] void fill(Functions (&functions)[dim], const V (&xi)[dim]) const {
#pragma GCC unroll 3
        for (int c = 0; c < dim; ++c) fast::fill<Isa, degree>(functions[c], xi[c], ends[c]);
    }

    [[gnu::always_inline]] void kick(const Functions (&functions)[dim], V dt, V (&v)[dim]) const {
#pragma GCC unroll 3
        for (int c = 0; c < dim; ++c) v[c] += dt * value<dim - 1>(functions, s.a[c] + block.node + lane, s);
    }

    /// F, sigma and volume after dL; bits of the lanes that are turned inside out.
    [[gnu::always_inline]] unsigned strain(double* at, Matrix<Isa, dim> dL, Matrix<Isa, dim>& sigma, V& volume) const {
        if (total || s.keeps_F) {
            Matrix<Isa, dim> F;
            load_matrix(at + R::F * lanes, F);
            Matrix<Isa, dim> next = total ? dL : product<Isa, dim>(dL, F);
#pragma GCC unroll 9
            for (int k = 0; k < dim * dim; ++k) next.at[k / dim][k % dim] += F.at[k / dim][k % dim];
            store_matrix(at + R::F * lanes, next);
            if constexpr (total) dL = divided<Isa, dim>(dL, F);
        }
        const Matrix<Isa, dim> grown = one_plus<Isa, dim>(1, dL);
        const V growth = determinant<Isa, dim>(grown, cofactors<Isa, dim>(grown));
        if (s.mesh == Mesh::moved) dL = divided<Isa, dim>(dL, grown);
        if (s.mesh == Mesh::midpoint) dL = divided<Isa, dim>(dL, one_plus<Isa, dim>(0.5, dL));
        sigma = stressed<Isa, dim>(s, sigma, dL);
        store_symmetric(at + R::sigma * lanes, sigma);
        if constexpr (!total) {
            if (s.volume_updated) {
                volume *= s.mesh == Mesh::moved ? Isa::all(1) + trace<Isa, dim>(dL) : growth;
                Isa::store(at + R::volume * lanes, volume);
            }
        }
        return Isa::not_above_zero(growth);
    }

    [[gnu::always_inline]] void scatter(int number, const double* at, const Functions (&functions)[dim], V m, V volume,
                                        const V (&v)[dim], const Matrix<Isa, dim>& sigma,
                                        Sums<Isa, dim, degree>& sums) const {
        constexpr bool mass = D::mass && (!total || pass == Pass::begin);
        if constexpr (D::mass || D::momentum)
            add_mass<dim - 1, mass, D::momentum, Isa, dim, degree>(functions, m, v, sums.m, sums.p, 0);
        if constexpr (D::force) {
            Matrix<Isa, dim> pull = sigma;
            if constexpr (total && dim > 1) {
                Matrix<Isa, dim> F;
                load_matrix(at + R::F * lanes, F);
                pull = product<Isa, dim>(sigma, cofactors<Isa, dim>(F));
            }
            const V share = -volume * Isa::all(s.per_h);
#pragma GCC unroll 3
            for (int c = 0; c < dim; ++c) {
                V t[dim];
#pragma GCC unroll 3
                for (int i = 0; i < dim; ++i) t[i] = share * pull.at[c][i];
                add_force<dim - 1, false, Isa, dim, degree>(functions, share, t, sums.f, c, 0);
            }
        }
        if constexpr (D::load) {
            V b[dim];
#pragma GCC unroll 3
            for (int c = 0; c < dim; ++c) {
                double of[Isa::width];
                for (int l = 0; l < Isa::width; ++l) of[l] = s.b[s.id[number * lanes + lane + l] * dim + c];
                b[c] = Isa::load(of);
                const V pull = m * b[c];
                double* total_load = s.load[c] + lane;
                Isa::store(total_load, Isa::load(total_load) + pull);
            }
            add_mass<dim - 1, false, true, Isa, dim, degree>(functions, m, b, sums.m, sums.f, 0);
        }
    }
};

}  // namespace ordo::solvers::mpm::fast
