// The door of MPM: from declared values to a running, typed simulation.
#include <cmath>

#include "core/error.hpp"
#include "solvers/instruction_set.hpp"
#include "solvers/mpm/fast/fast.hpp"
#include "solvers/mpm/mpm.hpp"

namespace ordo::solvers::mpm {
namespace {

/// Steps an Mpm<dim>, or what stands for it, in time, counts its work and reads its fields.
template <int dim, class Method>
class Running final : public Simulation {
public:
    Running(const SolidScene<dim>& scene, const Options& options, const Resolution& resolution,
            std::span<const std::string> fields)
        : fields_(fields.begin(), fields.end()),
          options_(options),
          rho_(scene.rho),
          dt_(resolution.dt),
          mpm_(scene, options, resolution, asked("strain")),
          momentum_(mpm_.momentum()),
          count_(static_cast<double>(mpm_.particles().size())) {}

    void advance_to(double t, const Interrupt& interrupt) override {
        in_equal_steps(t_, t, dt_, interrupt, [&](double now, double dt) {
            const double kick = options_.leaps() ? 0.5 * (last_dt_ + dt) : dt;
            if constexpr (requires { mpm_.composed_step(now, dt); }) {
                if (options_.composed()) mpm_.composed_step(now, dt);
                else mpm_.step(now, kick, dt);
            } else {
                mpm_.step(now, kick, dt);
            }
            ++steps_;
            last_dt_ = dt;
        });
        mpm_.meet_grid(t_);  // what has left the grid in the last step has left it
    }

    Snapshot snapshot() const override {
        const auto& p = mpm_.particles();
        Snapshot shot{
            .t = t_, .dim = dim, .X = {}, .x = {}, .weights = p.volume, .weights_undeformed = {}, .fields = {}};
        for (std::size_t i = 0; i < p.size(); ++i) {
            if (options_.frame == Frame::total) shot.weights[i] *= p.F[i].determinant();
            shot.weights_undeformed.push_back(p.m[i] / rho_);
            shot.X.insert(shot.X.end(), p.X[i].data(), p.X[i].data() + dim);
            shot.x.insert(shot.x.end(), p.x[i].data(), p.x[i].data() + dim);
        }
        for (const auto& name : fields_) shot.fields.push_back(read(name, p));
        return shot;
    }

    std::vector<Figure> work() const override {
        const double steps = static_cast<double>(steps_);
        return {{"steps", steps},
                {"particle_steps", steps * count_},
                {"cell_crossings", static_cast<double>(mpm_.crossings())}};
    }

    /// Mass: what the grid gathered in the last step against the particles'. Momentum: its change against the impulse
    /// of held faces and loads, relative to the sum of m |v|, the impulse and the sum of m |u| / t.
    std::vector<Figure> drift() const override {
        const auto& p = mpm_.particles();
        double mass = 0;
        for (const double m : p.m) mass += m;
        const Vec<dim> change = mpm_.momentum() - momentum_;
        const double scale = moving(p) + mpm_.impulse().norm() + travelled(p);
        return {{"mass", steps_ == 0 ? 0 : std::abs(mpm_.mass_on_grid() - mass) / mass},
                {"momentum", scale == 0 ? 0 : (change - mpm_.impulse()).norm() / scale}};
    }

    std::vector<Skipped> skipped() const override {
        if constexpr (requires { mpm_.skipped(); }) return mpm_.skipped();
        else return {};
    }

    double helper_seconds() const override {
        if constexpr (requires { mpm_.helper_seconds(); }) return mpm_.helper_seconds();
        else return 0;
    }

private:
    bool asked(const std::string& name) const {
        for (const auto& field : fields_) {
            if (field == name) return true;
        }
        return false;
    }

    Field read(const std::string& name, const Particles<dim>& p) const {
        if (name == "displacement")
            return per_particle<dim>(name, [&](std::size_t i) { return Vec<dim>(p.x[i] - p.X[i]); });
        if (name == "stress") return per_particle<dim * dim>(name, [&](std::size_t i) { return p.sigma[i]; });
        if (name == "strain") {
            return per_particle<dim * dim>(
                name, [&](std::size_t i) { return Tensor<dim>((p.F[i] - Tensor<dim>::Identity()).transpose()); });
        }
        if (!options_.leaps() || steps_ == 0) return per_particle<dim>(name, [&](std::size_t i) { return p.v[i]; });
        Method now = mpm_;
        now.synchronise(t_, 0.5 * last_dt_);
        const auto& later = now.particles();
        return per_particle<dim>(name, [&](std::size_t i) { return later.v[i]; });
    }

    template <int components, class Get>
    Field per_particle(const std::string& name, Get&& get) const {
        Field field{name, components, {}};
        for (std::size_t i = 0; i < static_cast<std::size_t>(count_); ++i) {
            const auto value = get(i).eval();
            field.values.insert(field.values.end(), value.data(), value.data() + components);
        }
        return field;
    }

    /// Sum of m |u| / t: what swings is not judged by the moment when it turns.
    double travelled(const Particles<dim>& p) const {
        double sum = 0;
        for (std::size_t i = 0; i < p.size(); ++i) sum += p.m[i] * (p.x[i] - p.X[i]).norm();
        return t_ > 0 ? sum / t_ : 0;
    }

    static double moving(const Particles<dim>& p) {
        double sum = 0;
        for (std::size_t i = 0; i < p.size(); ++i) sum += p.m[i] * p.v[i].norm();
        return sum;
    }

    std::vector<std::string> fields_;
    Options options_;
    double rho_;
    double dt_;
    Method mpm_;
    Vec<dim> momentum_;
    double count_;  ///< of the particles
    double t_ = 0;
    double last_dt_ = 0;
    long steps_ = 0;
};

/// Transfers that replace particle velocities by the grid's, in every step: their damping does not fall with dt.
bool filters(const Options& o) {
    return o.transfer == Transfer::pic || o.transfer == Transfer::xpic || o.transfer == Transfer::fmpm ||
           o.transfer == Transfer::mls;
}

double claimed_in_time(const Options& o) {
    if (filters(o)) return 1;
    // A drift is exact where the mapped velocity does not change under the particles as they move: in the total frame,
    // and to the error of the reconstruction. Otherwise a term of first order in dt grows with the amplitude.
    const bool exact_drift = o.frame == Frame::total || o.reconstruction == Reconstruction::mls;
    if (o.composed()) return !exact_drift ? 1 : o.time == Time::yoshida6 ? 6 : 4;
    // Positions and strains that follow velocities mapped off the particles make a leapfrog; with a consistent mass
    // those are the accelerated ones.
    const bool alike = o.separable() || (o.mass == Mass::consistent && o.stress_update == StressUpdate::usl);
    return o.leaps() && alike ? 2 : 1;
}

/// Integrals as good as the functions: then errors are those of Galerkin's method with splines.
bool integrates_well(const Options& o) {
    const bool gauss_points = o.frame == Frame::total && o.placement == Placement::gauss;
    const bool least_squares = o.reconstruction == Reconstruction::mls && o.degree > o.spline_degree();
    return o.mass == Mass::consistent && (gauss_points || least_squares);
}

double claimed_in_space(const Options& o) {
    if (!integrates_well(o)) return 2;
    return o.spline_degree() + (o.transfer == Transfer::blend ? 0 : 1);
}

/// Orders along dt proportional to h, for smooth solutions.
Claim claim(const Values& values) {
    const Options o = options_from(values);
    const bool crossing = o.frame == Frame::total || o.reconstruction == Reconstruction::mls ||
                          o.reconstruction == Reconstruction::impm || o.basis == Basis::cpgimp ||
                          o.basis == Basis::cpdi || o.basis == Basis::cpdi2;
    const bool all_mass = o.reconstruction == Reconstruction::none || o.reconstruction == Reconstruction::mls ||
                          o.reconstruction == Reconstruction::tls;
    std::vector<std::string> conserves;
    if (all_mass) conserves.push_back("mass");
    // Lost is the first moment of a box that is cut at the grid's end.
    const bool skews = o.affine() && o.boxes();
    if ((o.reconstruction == Reconstruction::none && !skews) || o.conservative) conserves.push_back("momentum");
    // A degree needs as many particles a cell for its functions to be felt everywhere.
    const std::string per_cell =
        o.spline_degree() > 2 ? "; at least " + std::to_string(o.spline_degree() - 1) + " particles a cell" : "";
    std::string provided = crossing ? "smooth solutions, also where particles cross cell faces"
                                    : "smooth solutions while no particle crosses a cell face; beyond that the error "
                                      "grows again under refinement";
    provided +=
        per_cell + "; orders in time above 2 where the stress comes from F; a scene's damping is first order in time";
    if (filters(o)) provided += "; dt proportional to h: at the same h a smaller step damps more";
    return {.order_in_space = claimed_in_space(o),
            .order_in_time = claimed_in_time(o),
            .conserves = conserves,
            .provided = provided,
            .source = crossing ? "DeVaucorbeil2020" : "WobbesTielen2015",
            .order_of_waves = integrates_well(o) ? 2.0 * o.spline_degree() : 2,
            .rings = true,
            .fields = {"displacement", "velocity"}};
}

template <int dim>
void check_threads(const SolidScene<dim>& scene, const Options& o) {
    if (o.threads == 1 || fast::serves(scene, o)) return;
    throw InputError("", "'threads' is " + std::to_string(o.threads) +
                             ", but these choices run on the readable kernel, which knows one thread (nearest: 1)");
}

Plan plan(const Scene& scene, const Values& options, const Values& resolution) {
    const Options chosen = options_from(options);
    return on_solid(scene, [&]<int dim>(const SolidScene<dim>& solid) {
        check_fits(solid, chosen);
        check_threads(solid, chosen);
        const Resolution fine = resolution_from(solid, chosen, resolution);
        instruction_set();  // refuses a word of ORDO_SIMD at the door
        double points = 1;
        for (int axis = 0; axis < dim; ++axis)
            points *= count_along_edge(chosen, fine, solid.upper[axis] - solid.lower[axis]);
        return Plan{.h = fine.h, .dt = fine.dt, .points = points};
    });
}

std::unique_ptr<Simulation> start(const Scene& scene, const Values& options, const Values& resolution,
                                  std::span<const std::string> fields) {
    const Options chosen = options_from(options);
    return on_solid(scene, [&]<int dim>(const SolidScene<dim>& solid) -> std::unique_ptr<Simulation> {
        check_fits(solid, chosen);
        check_threads(solid, chosen);
        const Resolution fine = resolution_from(solid, chosen, resolution);
        if (fast::serves(solid, chosen))
            return std::make_unique<Running<dim, fast::FastMpm<dim>>>(solid, chosen, fine, fields);
        return std::make_unique<Running<dim, Mpm<dim>>>(solid, chosen, fine, fields);
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
            .carries = "strain",
            .claim = claim,
            .accepts = is_solid,
            .plan = plan,
            .start = start};
}

}  // namespace ordo::solvers::mpm
