#pragma once
// The problem of the reference loops: a standing wave in an elastic box, as plain arrays.
#include <array>
#include <vector>

namespace ordo::bench {

/// A box of cells from the origin on, filled with 2 particles a cell and axis, between smooth rigid walls:
///
///   u = A grad(prod_a cos(pi x_a / L_a)) sin(omega t)      omega = c pi sqrt(sum_a 1 / L_a^2)
///
/// A bar with a free end has the wave of twice its length. A body that drifts has no walls but `margin` cells around
/// it.
struct Wave {
    int dim = 1;
    int degree = 1;                     ///< of the tensor-product B-splines: 1 or 2
    std::array<int, 3> cells{1, 1, 1};  ///< of the body; those beyond dim are 1
    double h = 0.125;                   ///< cell width [m]
    double rho = 1;                     ///< [kg/m^dim]
    double lambda = 0;                  ///< [Pa]
    double mu = 50;                     ///< [Pa]
    double v0 = 1e-3;                   ///< amplitude of the first velocity component [m/s]
    double courant = 0.1;               ///< dt c / h
    bool free_end = false;              ///< of a bar of tents: its upper face is free
    double drift = 0;                   ///< velocity of the whole body along axis 0 [m/s]
    int margin = 0;                     ///< cells of grid around a body that drifts

    double speed() const;
    double dt() const { return courant * h / speed(); }
    double omega() const;
    int slots() const { return 1 << dim; }  ///< particles a cell
    long particles() const;
    /// Displacement along an axis at time t of what was at X [m].
    double displacement(const std::array<double, 3>& X, int axis, double t) const;
    double velocity(const std::array<double, 3>& X, int axis) const;  ///< at t = 0 [m/s]
};

/// Structure of arrays; cells one after the other, axis 0 fastest, and so the particles of a cell.
struct Particles {
    std::array<std::vector<double>, 3> x, v;
    std::array<std::vector<double>, 6> sigma;  ///< xx, yx, yy, zx, zy, zz
    std::vector<double> volume, m;

    std::size_t size() const { return m.size(); }
};

/// At rest positions with the wave's velocity at t = 0, free of stress.
Particles seeded(const Wave& wave);

/// Relative L2 norm of the displacement's error over the particles after t.
double error_of(const Wave& wave, const Particles& now, double t);

}  // namespace ordo::bench
