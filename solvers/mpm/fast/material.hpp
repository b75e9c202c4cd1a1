#pragma once
// Deformation and stress of the particles of several lanes at once: strain_particles and the laws in increments of the
// readable kernel. Included by kernels alone.
#include "solvers/mpm/fast/sweep.hpp"

namespace ordo::solvers::mpm::fast {

template <class Isa, int dim>
struct Matrix {
    typename Isa::V at[dim][dim];
};

template <class Isa, int dim>
[[gnu::always_inline]] inline Matrix<Isa, dim> product(const Matrix<Isa, dim>& a, const Matrix<Isa, dim>& b) {
    Matrix<Isa, dim> c;
#pragma GCC unroll 3
    for (int i = 0; i < dim; ++i) {
#pragma GCC unroll 3
        for (int j = 0; j < dim; ++j) {
            typename Isa::V sum = a.at[i][0] * b.at[0][j];
#pragma GCC unroll 3
            for (int k = 1; k < dim; ++k) sum += a.at[i][k] * b.at[k][j];
            c.at[i][j] = sum;
        }
    }
    return c;
}

template <class Isa, int dim>
[[gnu::always_inline]] inline typename Isa::V trace(const Matrix<Isa, dim>& a) {
    typename Isa::V sum = a.at[0][0];
#pragma GCC unroll 3
    for (int i = 1; i < dim; ++i) sum += a.at[i][i];
    return sum;
}

/// The transpose of the adjugate: det(a) a^-T.
template <class Isa, int dim>
[[gnu::always_inline]] inline Matrix<Isa, dim> cofactors(const Matrix<Isa, dim>& a) {
    Matrix<Isa, dim> c;
    if constexpr (dim == 1) {
        c.at[0][0] = Isa::all(1);
    } else if constexpr (dim == 2) {
        c.at[0][0] = a.at[1][1];
        c.at[0][1] = -a.at[1][0];
        c.at[1][0] = -a.at[0][1];
        c.at[1][1] = a.at[0][0];
    } else {
#pragma GCC unroll 3
        for (int i = 0; i < 3; ++i) {
#pragma GCC unroll 3
            for (int j = 0; j < 3; ++j) {
                const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
                c.at[i][j] = a.at[i1][j1] * a.at[i2][j2] - a.at[i1][j2] * a.at[i2][j1];
            }
        }
    }
    return c;
}

template <class Isa, int dim>
[[gnu::always_inline]] inline typename Isa::V determinant(const Matrix<Isa, dim>& a, const Matrix<Isa, dim>& cofactor) {
    typename Isa::V sum = a.at[0][0] * cofactor.at[0][0];
#pragma GCC unroll 3
    for (int j = 1; j < dim; ++j) sum += a.at[0][j] * cofactor.at[0][j];
    return sum;
}

/// a b^-1.
template <class Isa, int dim>
[[gnu::always_inline]] inline Matrix<Isa, dim> divided(const Matrix<Isa, dim>& a, const Matrix<Isa, dim>& b) {
    using V = typename Isa::V;
    Matrix<Isa, dim> c;
    if constexpr (dim == 1) {
        c.at[0][0] = a.at[0][0] / b.at[0][0];
    } else {
        const Matrix<Isa, dim> cofactor = cofactors<Isa, dim>(b);
        const V per_det = Isa::all(1) / determinant<Isa, dim>(b, cofactor);
        Matrix<Isa, dim> inverse;
#pragma GCC unroll 3
        for (int i = 0; i < dim; ++i) {
#pragma GCC unroll 3
            for (int j = 0; j < dim; ++j) inverse.at[i][j] = cofactor.at[j][i] * per_det;
        }
        c = product<Isa, dim>(a, inverse);
    }
    return c;
}

/// I + share a.
template <class Isa, int dim>
[[gnu::always_inline]] inline Matrix<Isa, dim> one_plus(double share, Matrix<Isa, dim> a) {
#pragma GCC unroll 3
    for (int i = 0; i < dim; ++i) {
#pragma GCC unroll 3
        for (int j = 0; j < dim; ++j) {
            if (share != 1) a.at[i][j] = Isa::all(share) * a.at[i][j];
        }
        a.at[i][i] = Isa::all(1) + a.at[i][i];
    }
    return a;
}

/// sigma turned by the spin of dL, as `turned` in solvers/materials/law.hpp; (I - W)^-1 (I + W) of a spin W with axial
/// vector w is I + 2 (W + W^2) / (1 + w . w).
template <class Isa, int dim>
[[gnu::always_inline]] inline Matrix<Isa, dim> turned(const Matrix<Isa, dim>& sigma, const Matrix<Isa, dim>& dL) {
    using V = typename Isa::V;
    if constexpr (dim == 1) {
        return sigma;
    } else {
        const V quarter = Isa::all(0.25);
        Matrix<Isa, dim> W;
        V square = Isa::all(0);
#pragma GCC unroll 3
        for (int i = 0; i < dim; ++i) {
            W.at[i][i] = Isa::all(0);
#pragma GCC unroll 3
            for (int j = i + 1; j < dim; ++j) {
                W.at[i][j] = quarter * (dL.at[i][j] - dL.at[j][i]);
                W.at[j][i] = -W.at[i][j];
                square += W.at[i][j] * W.at[i][j];
            }
        }
        const V twice = Isa::all(2) / (Isa::all(1) + square);
        Matrix<Isa, dim> R = product<Isa, dim>(W, W);
#pragma GCC unroll 3
        for (int i = 0; i < dim; ++i) {
#pragma GCC unroll 3
            for (int j = 0; j < dim; ++j) R.at[i][j] = twice * (R.at[i][j] + W.at[i][j]);
            R.at[i][i] = Isa::all(1) + R.at[i][i];
        }
        const Matrix<Isa, dim> half = product<Isa, dim>(R, sigma);
        Matrix<Isa, dim> full;
#pragma GCC unroll 3
        for (int i = 0; i < dim; ++i) {
#pragma GCC unroll 3
            for (int j = i; j < dim; ++j) {
                V sum = half.at[i][0] * R.at[j][0];
#pragma GCC unroll 3
                for (int k = 1; k < dim; ++k) sum += half.at[i][k] * R.at[j][k];
                full.at[i][j] = full.at[j][i] = sum;
            }
        }
        return full;
    }
}

/// The stress after dL; symmetric.
template <class Isa, int dim>
[[gnu::always_inline]] inline Matrix<Isa, dim> stressed(const Sweep<dim>& s, const Matrix<Isa, dim>& sigma,
                                                        const Matrix<Isa, dim>& dL) {
    using V = typename Isa::V;
    const V growth = trace<Isa, dim>(dL);
    const V mu = Isa::all(s.mu);
    const V pressure = Isa::all(s.lambda) * growth;
    Matrix<Isa, dim> next = s.rate == Rate::nominal ? sigma : turned<Isa, dim>(sigma, dL);
    Matrix<Isa, dim> drag;
    if (s.rate == Rate::nominal) drag = product<Isa, dim>(dL, sigma);
#pragma GCC unroll 3
    for (int i = 0; i < dim; ++i) {
#pragma GCC unroll 3
        for (int j = i; j < dim; ++j) {
            V rise = mu * (dL.at[i][j] + dL.at[j][i]);
            if (i == j) rise = pressure + rise;
            if (s.rate == Rate::nominal) rise += drag.at[i][j] + drag.at[j][i];
            if (s.rate != Rate::logarithmic) rise -= growth * sigma.at[i][j];
            next.at[i][j] = next.at[j][i] = next.at[i][j] + rise;
        }
    }
    return next;
}

}  // namespace ordo::solvers::mpm::fast
