#pragma once
// What a sweep over the particles is given: plain numbers and pointers, so that kernels of several instruction sets
// share nothing that a linker could take from the wrong one.

namespace ordo::solvers::mpm::fast {

constexpr int lanes = 8;         ///< cells of a block along axis 0, and particles of a slot, whatever the registers
constexpr double beside = 1e-8;  ///< nearer to a face than this, in cells, a particle is placed by the exact quotient

/// Where the fields of a slot begin, in rows of `lanes` doubles.
template <int dim>
struct Row {
    enum : int {
        x = 0,                            ///< position [m]
        v = dim,                          ///< velocity [m/s]
        sigma = 2 * dim,                  ///< Cauchy stress [Pa]: xx, yy, zz, xy, xz, yz as far as they exist
        m = sigma + dim * (dim + 1) / 2,  ///< mass [kg]; zero where no particle is
        volume = m + 1,                   ///< [m^dim]; undeformed in the total frame
        F = volume + 1,                   ///< deformation gradient [-], column by column, where kept
        xi = F + dim * dim,               ///< place in its cell, in the total frame alone [-]
        of_updated = F,                   ///< rows of a slot
        of_updated_with_F = xi,
        of_total = xi + dim,
    };
};

/// Eight cells side by side along axis 0 and a chain of slots: lane l of each holds a particle of cell l, or none.
struct Block {
    int first = -1;      ///< slot; -1: none
    int cell[3] = {};    ///< of lane 0 along each axis
    long node = 0;       ///< of lane 0
    bool near = false;   ///< a particle may stand `beside` a face
    bool awake = false;  ///< no longer at rest
    bool swept = false;  ///< stands in the sweep's order, or will: what its particles give has come to the nodes
};

/// How the stress follows the increment dL of the displacement gradient, as in solvers/materials/law.hpp.
enum class Rate { logarithmic, reciprocal, nominal };
enum class Mesh { undeformed, midpoint, moved };

/// What one sweep does with each particle, in this order; "place" is its stencil.
///   gather   at the place it has     kick: v_p; move: x_p; strain: F_p, sigma_p, V_p
///   scatter  at the place it comes to
enum class Pass {
    begin,       ///< m, p, f
    last,        ///< USL: kick, move and strain; m, p, f
    kick,        ///< MUSL: kick; p again
    follow,      ///< MUSL: move and strain by the nodes' v; m, f
    follow_two,  ///< move by their u, strain by their v; m, p, f
    first,       ///< USF: strain by v; f
    kick_move,   ///< USF: kick and move; m, p
    load,        ///< b to f
    count
};

template <int dim>
struct Sweep {
    double* slots;  ///< slot s begins at s * stride
    long stride;
    const int* next;  ///< slot after a slot in its block; -1: none
    const int* id;    ///< number of the particle in each lane of each slot
    Block* blocks;
    const int* order;      ///< the blocks to sweep, rising
    long count;            ///< of them
    long row[dim];         ///< from a node to the next along each axis
    const double* v[dim];  ///< of the nodes
    const double* u[dim];
    const double* a[dim];
    double* m;  ///< sums at the nodes: mass, momentum, force
    double* p[dim];
    double* f[dim];
    const double* ends[dim];  ///< four numbers a cell along each axis: how splines are clamped, see along.hpp
    long cells[dim];          ///< length of each of the four rows of `ends`
    double lower[dim];        ///< where the first cell begins [m]
    double h, per_h;
    double kick, dt;    ///< [s]
    double lambda, mu;  ///< [Pa]
    Rate rate;
    Mesh mesh;
    bool volume_updated;
    bool keeps_F;
    const double* b;               ///< force per unit mass on each particle, dim numbers each [m/s^2]
    double load[dim][lanes];       ///< sum of m b, lane by lane [N]
    double travelled[dim][lanes];  ///< sums of the positions in the total frame: finite where all are
    void* settle_for;              ///< the first argument of settle
};

/// Called for lanes that stand beside a face, have left their cell or are turned inside out (bits from `lane` on). Puts
/// the place of each into xi[axis * lanes + lane], and 0 into keep[lane] where the particle leaves the cell.
template <int dim>
void settle(const Sweep<dim>& sweep, Block& block, int slot, int lane, unsigned out, unsigned inverted, double* xi,
            double* keep);

/// Nodes from sums to velocities and accelerations; the sums that were used up become zero.
template <int dim>
struct NodePass {
    const long* first;  ///< of the runs of `lanes` nodes to go over
    long count;
    double* m;
    double* p[dim];
    double* f[dim];
    double* v[dim];
    double* a[dim];
    double kick;     ///< v += kick a, where both are made [s]
    double damping;  ///< alpha of f -= alpha p [1/s]
    bool takes_p;    ///< v = p / m
    bool takes_f;    ///< a = f / m
    bool adds;       ///< v += kick a
    bool ends_m;     ///< the mass will be gathered anew
};

template <int dim>
struct Kernels {
    void (*sweep[static_cast<int>(Pass::count)])(Sweep<dim>&);
    void (*nodes)(const NodePass<dim>&);
};

}  // namespace ordo::solvers::mpm::fast
