#pragma once
// Godunov's method on a fixed grid: read `step` first. The peer that the Repeated Replacement Method is measured
// against.
#include <array>
#include <vector>

#include "solvers/godunov/active.hpp"
#include "solvers/godunov/columns.hpp"
#include "solvers/godunov/options.hpp"
#include "solvers/solver.hpp"

namespace ordo::solvers::godunov {

/// The solver "godunov" of the registry.
Solver solver();

/// What a fixed grid knows of its cells, ghosts included: mean contents q, and from them density, velocity and
/// pressure (elastic: temperature), in which cells are linear; contents at the left and right end of each cell.
struct Cells {
    explicit Cells(std::size_t n) : q(n), v(n), third(n), speed(n), left(n), right(n) {}

    Columns q;
    std::vector<double> v;      ///< [m/s]
    std::vector<double> third;  ///< p [Pa], or T [K]
    std::vector<double> speed;  ///< |v| + a [m/s]
    Columns left, right;        ///< used where cells are linear
};

/// The passes over a stretch of cells in a step; each is one loop for each kind of medium, limiter and flux, chosen
/// before it.

/// v, third and speed of cells; the speed is NaN where a cell is no matter waves can run through.
void measure_cells(const Medium& medium, Stretch cells, Cells& row);

/// The largest of these speeds [m/s]; NaN where one is.
double fastest_of(std::span<const double> speeds);

/// left and right of cells, half of `step_by_h` = dt / h [s/m] ahead in time. Reads v and third of one more on each
/// side.
void reconstruct(const Medium& medium, const Limiter& limiter, double step_by_h, Stretch cells, Cells& row);

/// left and right that are no matter become the mean of their cell.
void repair(const Medium& medium, Stretch cells, Cells& row);

/// through[i] between before[i] and behind[i + 1]. Returns whether all these states are matter.
bool pass_faces(const Medium& medium, const Options& options, const Columns& before, const Columns& behind,
                Stretch faces, Columns& through);

/// Equal cells between two fixed places, two more beyond each end.
///
///   q_i += dt / h (F_(i-1/2) - F_(i+1/2)),   F from the states on both sides of a face
///
/// First order: the states are the means. Second: means -+ half of the limited rise of density, velocity and pressure
/// (elastic: temperature), both ahead by dt / (2 h) (flux(left) - flux(right)); where that is no matter, the mean.
/// Beyond a reservoir the first contents of the end piece are held: right until a wave gets there. What comes in from
/// held contents is right up to the cube of their jump, as the Riemann solver is. Cells that no difference reaches are
/// not touched; see Active.
/// source   [Godunov1959], [VanLeer1979], [Toro2009, ch. 14]
class Grid {
public:
    /// `scene` is checked. Contents of a cell are those of the pieces within it.
    Grid(const LineScene& scene, const Options& options, const Resolution& resolution);

    /// Largest |v| + a of all cells [m/s]. Throws Diverged, with the place, where one has none.
    double fastest(double t) const;
    /// Over dt, not longer than Courant's condition allows for fastest().
    void step(double dt);

    std::size_t size() const { return n_; }
    std::size_t active() const { return total(active_.stretches()); }  ///< cells that the next step will touch
    double edge(std::size_t i) const;                                  ///< left one of cell i [m]
    Contents mean(std::size_t i) const { return cells_.q[i + ghosts]; }
    Contents left(std::size_t i) const { return cells_.left[i + ghosts]; }
    Contents right(std::size_t i) const { return cells_.right[i + ghosts]; }
    /// left and right of now, for those who look at the cells' slopes.
    void reconstruct_now();

    /// What the line holds, and what has come in by its left less what went out by its right end; `size`: the same of
    /// absolute values.
    struct Balance {
        Contents held, held_size, passed, passed_size;
    };
    Balance balance() const;

private:
    static constexpr std::size_t ghosts = 2;
    [[noreturn]] void refuse(double t) const;
    void pass(double step_by_h);
    void measure();
    void fill_ghosts();
    Contents ghost(std::size_t side, std::size_t depth) const;
    void pass_ends(double dt);

    std::size_t n_;
    double from_;  ///< [m]
    double to_;    ///< [m]
    double h_;
    Medium medium_;
    Options options_;
    std::array<LineEnd, 2> ends_;  ///< a reservoir's contents stand in `outside`
    Cells cells_;
    Columns through_;  ///< [i] between cells i and i + 1; of the stretches
    Active active_;
    Contents passed_, passed_size_;
};

}  // namespace ordo::solvers::godunov
