#pragma once
// Simulations made of the house's kernels with one piece of the tests' own. Each does without a fault what the house's
// own simulation does; a test holds them to that, so that only the fault can ring.
#include <algorithm>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "solvers/fem/fem.hpp"
#include "solvers/mpm/basis/tensor.hpp"
#include "solvers/mpm/mpm.hpp"
#include "solvers/mpm/transfer.hpp"
#include "tests/mutations/broken.hpp"

namespace ordo::tests {

/// A simulation in equal steps, as MPM and finite elements take them; `step(t, last dt, dt)` is the inheritor's.
class Stepped : public solvers::Simulation {
public:
    explicit Stepped(double dt) : longest_(dt) {}
    void advance_to(double t, const solvers::Interrupt& interrupt) override {
        solvers::in_equal_steps(t_, t, longest_, interrupt, [&](double now, double dt) {
            step(now, last_dt_, dt);
            last_dt_ = dt;
        });
    }
    std::vector<solvers::Figure> work() const override { return {}; }
    std::vector<solvers::Figure> drift() const override { return {}; }

protected:
    virtual void step(double t, double last_dt, double dt) = 0;
    double t_ = 0;
    double last_dt_ = 0;

private:
    double longest_;
};

/// Displacement and velocity of particles.
template <int dim>
solvers::Snapshot snapshot_of(double t, const solvers::mpm::Particles<dim>& p, const std::vector<solvers::Vec<dim>>& v,
                              double rho) {
    solvers::Snapshot shot{.t = t,
                           .dim = dim,
                           .X = {},
                           .x = {},
                           .weights = {},
                           .weights_undeformed = {},
                           .fields = {{"displacement", dim, {}}, {"velocity", dim, {}}}};
    for (std::size_t i = 0; i < p.size(); ++i) {
        shot.weights_undeformed.push_back(p.m[i] / rho);
        shot.weights.push_back(p.volume[i]);
        shot.X.insert(shot.X.end(), p.X[i].data(), p.X[i].data() + dim);
        shot.x.insert(shot.x.end(), p.x[i].data(), p.x[i].data() + dim);
        shot.fields[1].values.insert(shot.fields[1].values.end(), v[i].data(), v[i].data() + dim);
    }
    for (std::size_t k = 0; k < shot.x.size(); ++k) shot.fields[0].values.push_back(shot.x[k] - shot.X[k]);
    return shot;
}

/// A hand in the house's MPM: on the particles at the start and after each step, and on the first kick, which is
/// `first_kick` steps long.
template <int dim>
struct Hand {
    using Particles = solvers::mpm::Particles<dim>;
    std::function<void(Particles&)> start{};
    std::function<void(Particles&, const solvers::SolidScene<dim>&, double h)> after_step{};
    double first_kick = 0.5;
};

template <int dim>
class DrivenMpm final : public Stepped {
public:
    DrivenMpm(const solvers::SolidScene<dim>& scene, const solvers::mpm::Options& options,
              const solvers::mpm::Resolution& resolution, Hand<dim> hand)
        : Stepped(resolution.dt),
          scene_(scene),
          leaps_(options.leaps()),
          h_(resolution.h),
          hand_(std::move(hand)),
          mpm_(scene, options, resolution, true) {
        if (hand_.start) hand_.start(mpm_.particles());
    }

    solvers::Snapshot snapshot() const override {
        solvers::mpm::Mpm<dim> now = mpm_;
        if (leaps_ && last_dt_ > 0) now.synchronise(t_, 0.5 * last_dt_);
        return snapshot_of<dim>(t_, mpm_.particles(), now.particles().v, scene_.rho);
    }

private:
    void step(double t, double last_dt, double dt) override {
        const double share = last_dt > 0 ? 1 : hand_.first_kick;
        mpm_.step(t, leaps_ ? share * dt : dt, dt);
        if (hand_.after_step) hand_.after_step(mpm_.particles(), scene_, h_);
    }

    solvers::SolidScene<dim> scene_;
    bool leaps_;
    double h_;
    Hand<dim> hand_;
    solvers::mpm::Mpm<dim> mpm_;
};

/// A neo-Hookean bar by total Lagrangian MPM on functions of the tests' own, composed of drifts and kicks to fourth
/// order, with a consistent mass: what a step of Mpm does with these choices, in terms of its kernels.
///
/// Functions   from (cell, xi, cells): arrays `value` and `slope` of the functions that live in a cell
template <class Functions>
class BarOnBasis final : public Stepped {
public:
    BarOnBasis(const solvers::SolidScene<1>& scene, const solvers::mpm::Options& options,
               const solvers::mpm::Resolution& resolution)
        : Stepped(resolution.dt),
          scene_(scene),
          law_(std::get<solvers::NeoHookeanLaw>(scene.law)),
          grid_(scene, options, resolution),
          p_(solvers::mpm::seeded<1>(scene, options, resolution, true)),
          mass_(options),
          b_(p_.size()) {
        for (std::size_t p = 0; p < p_.size(); ++p) {
            solvers::Vec<1> xi;
            grid_.locate(p_.X[p], p_.cell[p], xi);
            const Functions found(p_.cell[p][0], xi[0], grid_.cells[0]);
            for (std::size_t k = 0; k < found.value.size(); ++k)
                rows_.add(p_.cell[p][0] + static_cast<int>(k), found.value[k],
                          solvers::Vec<1>(found.slope[k] / grid_.h));
            rows_.close_row();
        }
        solvers::mpm::scatter_mass<1>(rows_, p_.m, grid_.m);
        mass_.assemble(grid_, rows_, p_.m);
    }

    solvers::Snapshot snapshot() const override { return snapshot_of<1>(t_, p_, p_.v, scene_.rho); }

private:
    void step(double t, double, double dt) override {
        const auto [drifts, kicks] = solvers::mpm::yoshida4();
        for (std::size_t stage = 0;; ++stage) {
            drift(drifts[stage] * dt);
            if (stage == kicks.size()) return;
            t += drifts[stage] * dt;
            kick(t, kicks[stage] * dt);
        }
    }

    void drift(double dt) {
        grid_.v.assign(grid_.v.size(), solvers::Vec<1>::Zero());
        solvers::mpm::scatter<1>(rows_, p_.m, p_.v, grid_.v);
        mass_.solve(grid_, grid_.v, {});
        for (std::size_t p = 0; p < p_.size(); ++p) {
            p_.x[p] += dt * solvers::mpm::value_at<1>(rows_, p, grid_.v);
            p_.F[p] += dt * solvers::mpm::gradient_at<1>(rows_, p, grid_.v);
            p_.sigma[p] = law_.cauchy<1>(p_.F[p]);
        }
    }

    void kick(double t, double dt) {
        grid_.a.assign(grid_.a.size(), solvers::Vec<1>::Zero());
        (*scene_.body_force)(p_.X, t, b_);
        solvers::mpm::scatter<1>(rows_, p_.m, b_, grid_.a);
        const auto nominal = [&](std::size_t p) { return p_.sigma[p]; };  // in one dimension P = sigma
        solvers::mpm::scatter_stress<1>(rows_, p_.volume, nominal, grid_.a);
        mass_.solve(grid_, grid_.a, {});
        for (std::size_t p = 0; p < p_.size(); ++p) p_.v[p] += dt * solvers::mpm::value_at<1>(rows_, p, grid_.a);
    }

    solvers::SolidScene<1> scene_;
    solvers::NeoHookeanLaw law_;
    solvers::mpm::Grid<1> grid_;
    solvers::mpm::Particles<1> p_;
    solvers::mpm::MassMatrix<1> mass_;
    solvers::mpm::Stencils<1> rows_;
    std::vector<solvers::Vec<1>> b_;
};

/// The house's bar of finite elements; its first kick is `first_kick` steps long. Displacement only.
class DrivenBar final : public Stepped {
public:
    DrivenBar(const solvers::SolidScene<1>& scene, const solvers::fem::Options& options,
              const solvers::fem::Resolution& resolution, double first_kick)
        : Stepped(resolution.dt), first_kick_(first_kick), bar_(scene, options, resolution) {}

    solvers::Snapshot snapshot() const override {
        solvers::Snapshot shot{.t = t_, .dim = 1, .X = {}, .x = {}, .weights = {}, .fields = {{"displacement", 1, {}}}};
        for (std::size_t i = 0; i < bar_.u().size(); ++i) {
            shot.X.push_back(bar_.X()[i][0]);
            shot.x.push_back(shot.X[i] + bar_.u()[i]);
            shot.weights.push_back(bar_.h());
            shot.fields[0].values.push_back(bar_.u()[i]);
        }
        return shot;
    }

private:
    void step(double t, double last_dt, double dt) override {
        const double share = last_dt > 0 ? 1 : first_kick_;
        bar_.step({.t = t, .dt = dt, .kick = share * dt, .velocity_time = t + 0.5 * dt});
    }

    double first_kick_;
    solvers::fem::Bar bar_;
};

/// The house's MPM with that hand in it, in scenes of `dim` dimensions.
template <int dim>
Broken driven_mpm(const Hand<dim>& hand) {
    solvers::Solver solver = solvers::solver_named("mpm", "");
    solver.start = [hand](const solvers::Scene& scene, const Values& options, const Values& resolution,
                          std::span<const std::string>) -> std::unique_ptr<solvers::Simulation> {
        const auto& solid = std::get<solvers::SolidScene<dim>>(scene);
        const auto chosen = solvers::mpm::options_from(options);
        return std::make_unique<DrivenMpm<dim>>(solid, chosen, solvers::mpm::resolution_from(solid, chosen, resolution),
                                                hand);
    };
    return with_solver(std::move(solver));
}

template <class Functions>
Broken bar_on_basis() {
    solvers::Solver solver = solvers::solver_named("mpm", "");
    solver.start = [](const solvers::Scene& scene, const Values& options, const Values& resolution,
                      std::span<const std::string>) -> std::unique_ptr<solvers::Simulation> {
        const auto& solid = std::get<solvers::SolidScene<1>>(scene);
        const auto chosen = solvers::mpm::options_from(options);
        return std::make_unique<BarOnBasis<Functions>>(solid, chosen,
                                                       solvers::mpm::resolution_from(solid, chosen, resolution));
    };
    return with_solver(std::move(solver));
}

Broken driven_bar(double first_kick);

}  // namespace ordo::tests
