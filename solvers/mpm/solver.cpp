// The door of MPM: from declared values to a running, typed simulation.
#include <cmath>
#include <type_traits>

#include "solvers/mpm/mpm.hpp"

namespace ordo::solvers::mpm {
namespace {

/// Steps an Mpm<dim> in time, counts its work and reads its fields.
template <int dim>
class Running final : public Simulation {
public:
    Running(const SolidScene<dim>& scene, const Options& options, const Resolution& resolution,
            std::span<const std::string> fields)
        : fields_(fields.begin(), fields.end()),
          half_kick_(options.half_kick),
          dt_(resolution.dt),
          mpm_(scene, options, resolution, asked("strain")),
          momentum_(momentum()) {}

    void advance_to(double t, const Interrupt& interrupt) override {
        const double start = t_;
        const long count = steps_to(t - start, dt_);
        const double dt = (t - start) / static_cast<double>(count);
        for (long k = 0; k < count; ++k) {
            if (interrupt()) throw Interrupted("interrupted");
            mpm_.step(t_, half_kick_ ? 0.5 * (last_dt_ + dt) : dt, dt);
            ++steps_;
            last_dt_ = dt;
            t_ = k + 1 == count ? t : start + static_cast<double>(k + 1) * dt;
        }
    }

    Snapshot snapshot() const override {
        Snapshot shot{.t = t_, .dim = dim, .X = {}, .x = {}, .weights = mpm_.particles().volume, .fields = {}};
        const auto& p = mpm_.particles();
        for (std::size_t i = 0; i < p.size(); ++i) {
            shot.X.insert(shot.X.end(), p.X[i].data(), p.X[i].data() + dim);
            shot.x.insert(shot.x.end(), p.x[i].data(), p.x[i].data() + dim);
        }
        for (const auto& name : fields_) shot.fields.push_back(read(name));
        return shot;
    }

    std::vector<Figure> work() const override {
        const double particles = static_cast<double>(mpm_.particles().size());
        const double steps = static_cast<double>(steps_);
        return {{"steps", steps},
                {"particle_steps", steps * particles},
                {"cell_crossings", static_cast<double>(mpm_.crossings())}};
    }

    /// Mass: what the grid gathered in the last step against the particles'. Momentum: its change against the impulse
    /// of held faces and body force, relative to the sum of m |v| (to the impulse, where all rests).
    std::vector<Figure> drift() const override {
        double on_grid = 0;
        double mass = 0;
        for (const double m : mpm_.grid().m) on_grid += m;
        for (const double m : mpm_.particles().m) mass += m;
        const Vec<dim> change = momentum() - momentum_;
        const double scale = moving() + mpm_.impulse().norm();
        return {{"mass", steps_ == 0 ? 0 : std::abs(on_grid - mass) / mass},
                {"momentum", scale == 0 ? 0 : (change - mpm_.impulse()).norm() / scale}};
    }

private:
    bool asked(const std::string& name) const {
        for (const auto& field : fields_) {
            if (field == name) return true;
        }
        return false;
    }

    Field read(const std::string& name) const {
        const auto& p = mpm_.particles();
        if (name == "displacement")
            return per_particle<dim>(name, [&](std::size_t i) { return Vec<dim>(p.x[i] - p.X[i]); });
        if (name == "stress") return per_particle<dim * dim>(name, [&](std::size_t i) { return p.sigma[i]; });
        if (name == "strain") {
            return per_particle<dim * dim>(
                name, [&](std::size_t i) { return Tensor<dim>((p.F[i] - Tensor<dim>::Identity()).transpose()); });
        }
        if (!half_kick_ || steps_ == 0) return per_particle<dim>(name, [&](std::size_t i) { return p.v[i]; });
        Mpm<dim> now = mpm_;
        now.synchronise(t_, 0.5 * last_dt_);
        return per_particle<dim>(name, [&](std::size_t i) { return now.particles().v[i]; });
    }

    template <int components, class Get>
    Field per_particle(const std::string& name, Get&& get) const {
        Field field{name, components, {}};
        for (std::size_t i = 0; i < mpm_.particles().size(); ++i) {
            const auto value = get(i).eval();
            field.values.insert(field.values.end(), value.data(), value.data() + components);
        }
        return field;
    }

    Vec<dim> momentum() const {
        const auto& p = mpm_.particles();
        Vec<dim> sum = Vec<dim>::Zero();
        for (std::size_t i = 0; i < p.size(); ++i) sum += p.m[i] * p.v[i];
        return sum;
    }

    double moving() const {
        const auto& p = mpm_.particles();
        double sum = 0;
        for (std::size_t i = 0; i < p.size(); ++i) sum += p.m[i] * p.v[i].norm();
        return sum;
    }

    std::vector<std::string> fields_;
    bool half_kick_;
    double dt_;
    Mpm<dim> mpm_;
    Vec<dim> momentum_;
    double t_ = 0;
    double last_dt_ = 0;
    long steps_ = 0;
};

Claim claim(const Values& values) {
    const Options options = options_from(values);
    return {.order_in_space = 2,
            // USL strains, and `accelerated` moves, by dt a_i instead of its re-mapped mean: an error of O(dt h^2).
            .order_in_time = options.half_kick && options.moved_by_remapped ? 2.0 : 1.0,
            .conserves = {"mass", "momentum"},
            .provided = "while no particle crosses a cell face; beyond that the error grows again under refinement",
            .source = "WobbesTielen2015"};
}

Plan plan(const Scene& scene, const Values& options, const Values& resolution) {
    options_from(options);
    return on_solid(scene, [&]<int dim>(const SolidScene<dim>& solid) {
        const Resolution fine = resolution_from(solid, resolution);
        const double cells = ((solid.upper - solid.lower) / fine.h).array().round().prod();
        return Plan{.h = fine.h, .dt = fine.dt, .points = cells * std::pow(fine.ppc, dim)};
    });
}

std::unique_ptr<Simulation> start(const Scene& scene, const Values& options, const Values& resolution,
                                  std::span<const std::string> fields) {
    return on_solid(scene, [&]<int dim>(const SolidScene<dim>& solid) -> std::unique_ptr<Simulation> {
        return std::make_unique<Running<dim>>(solid, options_from(options), resolution_from(solid, resolution), fields);
    });
}

}  // namespace

Solver solver() {
    return {.name = "mpm",
            .about = "Material Point Method: particles carry the state through a grid that is reset in every step",
            .source = {"Sulsky1994", "Sulsky1995"},
            .options = option_parameters(),
            .resolution = resolution_parameters(),
            .fields = {"displacement", "velocity", "stress", "strain"},
            .claim = claim,
            .accepts = is_solid,
            .plan = plan,
            .start = start};
}

}  // namespace ordo::solvers::mpm
