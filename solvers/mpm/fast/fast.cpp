#include "solvers/mpm/fast/fast.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/text.hpp"

namespace ordo::solvers::mpm::fast {

namespace {

/// How quadratic splines are clamped, cell by cell, four rows: see Ends in along.hpp. Padded for whole blocks.
std::vector<double> ends_along(int cells) {
    const std::size_t n = static_cast<std::size_t>((cells / lanes + 2) * lanes);
    std::vector<double> ends(4 * n);
    for (std::size_t c = 0; c < n; ++c) {
        const double before = c == 0 ? 0 : 1;
        const double after = static_cast<int>(c) == cells - 1 ? 0 : 1;
        ends[c] = 1 / (1 + before);
        ends[n + c] = before;
        ends[2 * n + c] = 1 / (1 + after);
        ends[3 * n + c] = after;
    }
    return ends;
}

}  // namespace

template <int dim>
FastMpm<dim>::FastMpm(const SolidScene<dim>& scene, const Options& options, const Resolution& resolution, bool with_F,
                      long section)
    : FastMpm(scene, options, resolution, section, seeded<dim>(scene, options, resolution, with_F)) {}

template <int dim>
FastMpm<dim>::FastMpm(const SolidScene<dim>& scene, const Options& options, const Resolution& resolution, long section,
                      Particles<dim>&& particles)
    : options_(options),
      body_force_(options.body_force == BodyForce::left_out ? std::nullopt : scene.body_force),
      damping_(scene.damping.value_or(0)),
      total_(options.frame == Frame::total),
      everywhere_(options.kernel == Kernel::fast_everywhere || body_force_),
      grid_(scene, options, resolution),
      per_h_(1 / grid_.h),
      slots_(grid_, particles, total_),
      boundary_(scene, options, resolution, particles),
      kernels_(kernels<dim>(grid_.degree, total_)),
      rate_(static_cast<Rate>(scene.law.index())),
      C_(std::visit([](const auto& law) { return law.C; }, scene.law)),
      rest_v_(1e-30 * std::sqrt(stiffness(scene.law) / scene.rho)),
      rest_sigma_(1e-30 * stiffness(scene.law)),
      section_(section),
      hands_(static_cast<std::size_t>(options.threads)),
      lost_(static_cast<long>(particles.size())) {
    X_ = std::move(particles.X);
    const long rows = dim == 1 ? 1 : grid_.cells[dim - 1] + grid_.degree;
    const std::size_t nodes = static_cast<std::size_t>(
        rows * (dim == 1 ? slots_.blocks_along(0) + 1L : slots_.row_of_nodes(dim - 1) / lanes));
    for (auto* field : {&p_, &f_, &v_, &a_}) {
        for (auto& component : *field) component.assign(nodes, {});
    }
    m_.assign(nodes, {});
    for (int axis = 0; grid_.degree > 1 && axis < dim; ++axis)
        ends_[static_cast<std::size_t>(axis)] = ends_along(grid_.cells[axis]);
    for (const auto& [node, axis] : grid_.held) held_.push_back({static_cast<int>(padded(node)), axis});
    if (boundary_.x.empty()) {
        for (auto* vectors : {&grid_.v, &grid_.a}) std::vector<Vec<dim>>().swap(*vectors);
        std::vector<double>().swap(grid_.m);
    }
    near_.resize(slots_.blocks().size());
    seen_.resize(nodes);
    order_.reserve(near_.size());
    watched_.reserve(everywhere_ ? 0 : near_.size());
    runs_.reserve(nodes);
    for (auto& hand : hands_) {
        for (auto* list : {&hand.leaving, &hand.waiting})
            list->reserve(std::min({X_.size(), X_.size() / 16 + 1024, std::size_t{1} << 13}));
        hand.turns.reserve(hand.leaving.capacity());
    }
    slots_.each([&](Seat seat) {
        const Cell<dim> cell = slots_.cell(seat);
        Vec<dim> xi;
        Cell<dim> found = cell;
        const Vec<dim> x = total_ ? X_[static_cast<std::size_t>(slots_.id(seat) - 1)] : where(seat);
        if (!grid_.locate(x, found, xi)) lost_ = std::min(lost_, slots_.id(seat) - 1L);
        slots_.blocks()[static_cast<std::size_t>(slots_.block_of(seat.slot))].near = true;
        on_face_ = on_face_ || on_face(seat);
    });
    for (std::size_t b = 0; !everywhere_ && b < near_.size(); ++b) watched_.push_back(static_cast<int>(b));
    wake();
    begin();
}

/// The sums of the first step, or after particles came where no sweep was. In the total frame the masses are gathered
/// this once, and so from all particles.
template <int dim>
void FastMpm<dim>::begin() {
    const bool everywhere = std::exchange(everywhere_, everywhere_ || total_);
    arrange();
    std::fill(m_.begin(), m_.end(), Eight{});
    clear(p_);
    clear(f_);
    sweep(Pass::begin, 0, 0);
    if (options_.stress_update == StressUpdate::usf) clear(f_);
    everywhere_ = everywhere;
    if (total_ && !everywhere_) arrange();
    missed_ = false;
}

template <int dim>
void FastMpm<dim>::step(double t, double kick, double dt) {
    meet_grid(t);
    swept_ += in_sweep_;
    due_ += static_cast<double>(X_.size());
    const bool bare = on_face_ && find_touches();
    if (options_.stress_update == StressUpdate::usf) {
        solve(Makes::v, 0, false);
        if (bare) lend_velocity();
        sweep(Pass::first, 0, dt);
        gather_loads(t);
        solve(Makes::a_added, kick, !total_);
        move_boundary(dt, v_);
        sweep(Pass::kick_move, kick, dt);
    } else if (options_.stress_update == StressUpdate::usl) {
        gather_loads(t);
        solve(Makes::both, kick, !total_);
        move_boundary(dt, v_);
        if (bare) {
            kick_apart(kick);
            lend_velocity();
        }
        sweep(bare ? Pass::follow_two : Pass::last, kick, dt);
    } else {
        gather_loads(t);
        solve(options_.moved_by_remapped ? Makes::a : Makes::both, kick, false);
        if (!options_.moved_by_remapped) kick_apart(kick);
        else sweep(Pass::kick, kick, dt);
        solve(Makes::v, 0, !total_);
        move_boundary(dt, options_.moved_by_remapped ? v_ : u_);
        if (bare) lend_velocity();
        if (options_.moved_by_remapped && damping_ != 0) u_ = v_;
        sweep(options_.moved_by_remapped && damping_ == 0 ? Pass::follow : Pass::follow_two, kick, dt);
    }
    wake();
    if (missed_) begin();
    else if (dirty_) arrange();
}

/// v_p alone, and their momentum; what the nodes had is kept as u.
template <int dim>
void FastMpm<dim>::kick_apart(double kick) {
    u_ = v_;
    sweep(Pass::kick, kick, 0);
    if (options_.stress_update == StressUpdate::usl) clear(p_);
}

template <int dim>
void FastMpm<dim>::synchronise(double t, double kick) {
    meet_grid(t);
    gather_loads(t);
    solve(Makes::a, kick, false);
    sweep(Pass::kick, kick, 0);
}

template <int dim>
void FastMpm<dim>::meet_grid(double t) {
    if (lost_ < static_cast<long>(X_.size()))
        throw Diverged("particle " + std::to_string(lost_) + " left the grid at t = " + shortest(t));
    if (boundary_.x.empty()) return;
    boundary_.meet_grid(grid_, total_, {});
    wake_loaded();
    if (dirty_ && due_ == 0) begin();
    else if (dirty_) arrange();
}

template <int dim>
void FastMpm<dim>::clear(Field& field) {
    for (auto& component : field) std::fill(component.begin(), component.end(), Eight{});
}

template <int dim>
void FastMpm<dim>::gather_loads(double t) {
    load_.setZero();
    if (body_force_) gather_body_force(t);
    if (boundary_.traction && !boundary_.x.empty()) {
        const auto each = [&](auto&& visit) {
            for (std::size_t k = 0; k < boundary_.x.size(); ++k)
                boundary_.stencils.row(
                    k, [&](int i, double, const auto&) { visit(static_cast<std::size_t>(i), padded(i)); });
        };
        each([&](std::size_t i, long node) {
            grid_.m[i] = at(m_, node);
            grid_.a[i].setZero();
        });
        load_ += boundary_.pull(t, grid_, grid_.a);
        each([&](std::size_t i, long node) {
            for (int c = 0; c < dim; ++c) at(f_[static_cast<std::size_t>(c)], node) += grid_.a[i][c];
            grid_.a[i].setZero();
        });
    }
    for (int c = 0; damping_ != 0 && c < dim; ++c) {
        for (const long run : runs_) {
            for (int lane = 0; lane < lanes; ++lane)
                load_[c] -= damping_ * at(p_[static_cast<std::size_t>(c)], run + lane);
        }
    }
}

template <int dim>
void FastMpm<dim>::gather_body_force(double t) {
    b_.assign(X_.size() + 1, Vec<dim>::Zero());
    (*body_force_)(X_, t, std::span(b_).subspan(1));
    sweep(Pass::load, 0, 0);
}

template <int dim>
void FastMpm<dim>::move_boundary(double dt, const Field& v) {
    for (std::size_t k = 0; k < boundary_.x.size(); ++k) {
        boundary_.stencils.row(k, [&](int i, double, const auto&) {
            for (int c = 0; c < dim; ++c)
                grid_.v[static_cast<std::size_t>(i)][c] = at(v[static_cast<std::size_t>(c)], padded(i));
        });
    }
    if (!boundary_.x.empty()) boundary_.move(dt, grid_);
}

template class FastMpm<1>;
template class FastMpm<2>;
template class FastMpm<3>;

}  // namespace ordo::solvers::mpm::fast
