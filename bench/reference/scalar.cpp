#include "bench/reference/scalar.hpp"

#include <algorithm>

#include "bench/reference/stencil.hpp"
#include "bench/reference/walls.hpp"

namespace ordo::bench {
namespace {

template <int dim, int degree, bool in_registers>
struct Loops {
    static constexpr int per_axis = degree + 1;
    static constexpr int nodes = power(per_axis, dim);
    static constexpr int values = 1 + 2 * dim;

    /// The functions that a particle touches, and the first node of its cell.
    struct Stencil {
        double w[dim][per_axis], slope[dim][per_axis];
        int first = 0;

        Stencil(const ScalarGrid& g, const Particles& p, std::size_t i) {
            for (int a = 0; a < dim; ++a) {
                const double r = (p.x[a][i] - g.lower[a]) * g.inv_h;
                const int cell = static_cast<int>(r);
                splines<double, degree>(r - cell, g.inv_h, w[a], slope[a]);
                first += cell * g.stride[a];
            }
        }
    };

    /// visit(node from `first` on, w, grad) for each node of the stencil.
    template <class Visit>
    [[gnu::always_inline]] static void each_node(const ScalarGrid& g, const Stencil& s, Visit&& visit) {
#pragma GCC unroll 9
        for (int k = 0; k < nodes; ++k) {
            const int at[3]{k % per_axis, k / per_axis % per_axis, k / (per_axis * per_axis)};
            double w = 1;
            double grad[dim];
            std::fill(grad, grad + dim, 1.0);
            int offset = 0;
            for (int a = 0; a < dim; ++a) {
                w *= s.w[a][at[a]];
                for (int b = 0; b < dim; ++b) grad[b] *= a == b ? s.slope[a][at[a]] : s.w[a][at[a]];
                offset += at[a] * g.stride[a];
            }
            visit(k, offset, w, grad);
        }
    }

    static void to_grid(ScalarGrid& g, const Particles& p) {
        std::fill(g.nodes.begin(), g.nodes.end(), 0.0);
        for (std::size_t i = 0; i < p.size(); ++i) {
            const Stencil s(g, p, i);
            double* first = g.nodes.data() + s.first * values;
            const double m = p.m[i];
            double momentum[dim], P[dim][dim];
            pulls(p, i, momentum, P);
            each_node(
                g, s, [&](int, int offset, double w, const double(&grad)[dim]) __attribute__((always_inline)) {
                    add(first + offset * values, m, momentum, P, w, grad);
                });
        }
    }

    /// m v and V sigma.
    static void pulls(const Particles& p, std::size_t i, double (&momentum)[dim], double (&P)[dim][dim]) {
        for (int a = 0, k = 0; a < dim; ++a) {
            momentum[a] = p.m[i] * p.v[a][i];
            for (int b = 0; b <= a; ++b, ++k) P[a][b] = P[b][a] = p.volume[i] * p.sigma[k][i];
        }
    }

    [[gnu::always_inline]] static void add(double* sum, double m, const double (&momentum)[dim],
                                           const double (&P)[dim][dim], double w, const double (&grad)[dim]) {
        sum[0] += w * m;
        for (int a = 0; a < dim; ++a) {
            sum[1 + a] += w * momentum[a];
            double f = P[a][0] * grad[0];
            for (int b = 1; b < dim; ++b) f += P[a][b] * grad[b];
            sum[1 + dim + a] -= f;
        }
    }

    /// The same with the sums of the cell at hand.
    static void to_grid_by_cells(ScalarGrid& g, const Particles& p) {
        std::fill(g.nodes.begin(), g.nodes.end(), 0.0);
        double sum[nodes * values]{};
        int cell = 0;
        const auto put = [&] {
            for (int k = 0; k < nodes * values; ++k) {
                g.nodes[static_cast<std::size_t>(cell * values + k)] += sum[k];
                sum[k] = 0;
            }
        };
        for (std::size_t i = 0; i < p.size(); ++i) {
            const Stencil s(g, p, i);
            if (s.first != cell) put();
            cell = s.first;
            double momentum[dim], P[dim][dim];
            pulls(p, i, momentum, P);
            each_node(
                g, s, [&](int k, int, double w, const double(&grad)[dim]) __attribute__((always_inline)) {
                    add(sum + k * values, p.m[i], momentum, P, w, grad);
                });
        }
        put();
    }

    static void meet_walls(ScalarGrid& g) {
        const int count = static_cast<int>(g.nodes.size()) / values;
        for (int a = 0; a < dim; ++a) {
            const Wall wall{dim, 1, a, 0, 1};
            const int last = g.free_end ? 0 : g.cells[a];
            for (int i = 0; i < count; ++i) {
                const int place = i / g.stride[a] % (g.cells[a] + degree);
                if (place != 0 && place != last) continue;
                double* node = g.nodes.data() + i * values;
                wall(node, node + (degree - 1) * g.stride[a] * values);
            }
        }
    }

    static void accelerate(ScalarGrid& g) {
        for (double* node = g.nodes.data(); node != g.nodes.data() + g.nodes.size(); node += values) {
            const double inverse = node[0] > 0 ? 1 / node[0] : 0;
            for (int a = 1; a <= dim; ++a) {
                node[a + dim] *= inverse;
                node[a] = node[a] * inverse + g.dt * node[a + dim];
            }
        }
    }

    static void from_grid(const ScalarGrid& g, Particles& p) {
        for (std::size_t i = 0; i < p.size(); ++i) {
            const Stencil s(g, p, i);
            const double* first = g.nodes.data() + s.first * values;
            double dv[dim]{}, dx[dim]{}, L[dim][dim]{};
            each_node(
                g, s, [&](int, int offset, double w, const double(&grad)[dim]) __attribute__((always_inline)) {
                    const double* node = first + offset * values;
                    for (int a = 0; a < dim; ++a) {
                        dx[a] += w * node[1 + a];
                        dv[a] += w * node[1 + dim + a];
                        for (int b = 0; b < dim; ++b) L[a][b] += grad[b] * node[1 + a];
                    }
                });
            double trace = 0;
            for (int a = 0; a < dim; ++a) {
                p.v[a][i] += g.dt * dv[a];
                p.x[a][i] += g.dt * dx[a];
                trace += g.dt * L[a][a];
            }
            p.volume[i] *= 1 + trace;
            for (int a = 0, k = 0; a < dim; ++a) {
                for (int b = 0; b <= a; ++b, ++k)
                    p.sigma[k][i] += g.dt * g.mu * (L[a][b] + L[b][a]) + (a == b ? g.lambda * trace : 0);
            }
        }
    }

    static void step(ScalarGrid& g, Particles& p) {
        if (in_registers) to_grid_by_cells(g, p);
        else to_grid(g, p);
        if (g.walls) meet_walls(g);
        accelerate(g);
        from_grid(g, p);
    }
};

ScalarGrid grid_of(const Wave& wave) {
    ScalarGrid g{.inv_h = 1 / wave.h,
                 .dt = wave.dt(),
                 .lambda = wave.lambda,
                 .mu = wave.mu,
                 .walls = wave.margin == 0,
                 .free_end = wave.free_end,
                 .nodes = {}};
    int count = 1;
    for (int a = 0; a < wave.dim; ++a) {
        const int margin = a == 0 ? wave.margin : wave.margin > 0 ? 1 : 0;
        g.cells[a] = wave.cells[a] + 2 * margin;
        g.lower[a] = -margin * wave.h;
        g.stride[a] = count;
        count *= g.cells[a] + wave.degree;
    }
    g.nodes.resize(static_cast<std::size_t>(count * (1 + 2 * wave.dim)));
    return g;
}

}  // namespace

Scalar::Scalar(const Wave& wave, bool in_registers) : p_(seeded(wave)), grid_(grid_of(wave)) {
    if (wave.dim == 1 && wave.degree == 1) step_ = in_registers ? Loops<1, 1, true>::step : Loops<1, 1, false>::step;
    else if (wave.dim == 1) step_ = in_registers ? Loops<1, 2, true>::step : Loops<1, 2, false>::step;
    else if (wave.dim == 2) step_ = wave.degree == 1 ? Loops<2, 1, false>::step : Loops<2, 2, false>::step;
    else step_ = Loops<3, 1, false>::step;
}

double Scalar::bytes_per_particle() const {
    std::size_t values = grid_.nodes.size() + p_.volume.size() + p_.m.size();
    for (const auto& field : p_.x) values += field.size();
    for (const auto& field : p_.v) values += field.size();
    for (const auto& field : p_.sigma) values += field.size();
    return static_cast<double>(sizeof(double) * values) / static_cast<double>(p_.size());
}

}  // namespace ordo::bench
