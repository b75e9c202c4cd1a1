// The door of the finite elements: from declared values to a running bar.
#include <cmath>

#include "solvers/fem/fem.hpp"

namespace ordo::solvers::fem {
namespace {

/// Steps a Bar in time, counts its work and reads its fields.
class Running final : public Simulation {
public:
    Running(const SolidScene<1>& scene, const Options& options, const Resolution& resolution,
            std::span<const std::string> fields)
        : fields_(fields.begin(), fields.end()),
          options_(options),
          dt_(resolution.dt),
          mass_(scene.rho * (scene.upper - scene.lower)[0]),
          bar_(scene, options, resolution),
          momentum_(bar_.momentum()) {}

    void advance_to(double t, const Interrupt& interrupt) override {
        in_equal_steps(t_, t, dt_, interrupt, [&](double now, double dt) {
            touched_ += static_cast<double>(bar_.active());
            bar_.step({.t = now,
                       .dt = dt,
                       .kick = options_.leapfrog ? 0.5 * (last_dt_ + dt) : dt,
                       .velocity_time = now + (options_.leapfrog ? 0.5 : 1.0) * dt});
            ++steps_;
            last_dt_ = dt;
        });
    }

    Snapshot snapshot() const override {
        Snapshot shot{.t = t_,
                      .dim = 1,
                      .X = X(),
                      .x = sampled(bar_.u()),
                      .weights = weights(true),
                      .weights_undeformed = weights(false),
                      .fields = {}};
        for (std::size_t i = 0; i < shot.X.size(); ++i) shot.x[i] += shot.X[i];
        for (const auto& name : fields_) shot.fields.push_back({name, 1, read(name)});
        return shot;
    }

    std::vector<Figure> work() const override {
        const double steps = static_cast<double>(steps_);
        return {{"steps", steps}, {"element_steps", steps * static_cast<double>(bar_.F().size())}};
    }

    std::vector<Skipped> skipped() const override {
        if (steps_ == 0) return {};
        const double all = static_cast<double>(steps_) * static_cast<double>(bar_.u().size());
        return {{"updates of quiet nodes", 1 - touched_ / all}};
    }

    /// Mass: all entries of the matrix against rho L. Momentum: its change against the impulse of reactions, tractions,
    /// body force and damping, relative to the sum of m |v| and that impulse.
    std::vector<Figure> drift() const override {
        double moving = 0;
        for (std::size_t i = 0; i < bar_.v().size(); ++i) moving += bar_.m()[i] * std::abs(bar_.v()[i]);
        const double scale = moving + std::abs(bar_.impulse());
        const double change = bar_.momentum() - momentum_;
        return {{"mass", std::abs(bar_.mass() - mass_) / mass_},
                {"momentum", scale == 0 ? 0 : std::abs(change - bar_.impulse()) / scale}};
    }

private:
    std::vector<double> read(const std::string& name) const {
        if (name == "displacement") return sampled(bar_.u());
        if (name == "stress") return by_element([&](std::size_t e) { return bar_.P()[e]; });
        if (name == "strain") return by_element([&](std::size_t e) { return bar_.F()[e] - 1; });
        if (!options_.leapfrog || steps_ == 0) return sampled(bar_.v());
        Bar now = bar_;
        now.synchronise({.t = t_, .dt = 0, .kick = 0.5 * last_dt_, .velocity_time = t_});
        return sampled(now.v());
    }

    /// What lives at the nodes, at the snapshot's points.
    std::vector<double> sampled(std::span<const double> nodal) const {
        if (!options_.at_centres) return {nodal.begin(), nodal.end()};
        std::vector<double> values;
        for (std::size_t e = 0; e + 1 < nodal.size(); ++e) values.push_back(0.5 * (nodal[e] + nodal[e + 1]));
        return values;
    }

    /// What lives in the elements, get(e), at the snapshot's points; at the ends of the bar one-sided.
    template <class Get>
    std::vector<double> by_element(Get get) const {
        const std::size_t last = bar_.F().size() - 1;
        std::vector<double> values;
        if (!options_.at_centres) values.push_back(get(0));
        for (std::size_t e = options_.at_centres ? 0 : 1; e <= last; ++e)
            values.push_back(options_.at_centres ? get(e) : 0.5 * (get(e - 1) + get(e)));
        if (!options_.at_centres) values.push_back(get(last));
        return values;
    }

    std::vector<double> X() const {
        std::vector<double> nodes;
        for (const auto& X : bar_.X()) nodes.push_back(X[0]);
        return sampled(nodes);
    }

    /// Lengths of the elements, now or undeformed, half of each to either node.
    std::vector<double> weights(bool now) const {
        std::vector<double> values(bar_.F().size() + (options_.at_centres ? 0 : 1), 0);
        for (std::size_t e = 0; e < bar_.F().size(); ++e) {
            const double length = bar_.h() * (now ? bar_.F()[e] : 1);
            values[e] += options_.at_centres ? length : length / 2;
            if (!options_.at_centres) values[e + 1] += length / 2;
        }
        return values;
    }

    std::vector<std::string> fields_;
    Options options_;
    double dt_;
    double mass_;  ///< rho L [kg]
    Bar bar_;
    double momentum_;  ///< at the start [kg m/s]
    double t_ = 0;
    double last_dt_ = 0;
    long steps_ = 0;
    double touched_ = 0;  ///< nodes, summed over the steps
};

Claim claim(const Values& values) {
    const Options options = options_from(values);
    return {.order_in_space = 2,
            .order_in_time = options.leapfrog ? 2.0 : 1.0,
            .conserves = {"mass", "momentum"},
            .provided =
                "displacement and velocity of smooth data; courant <= 1 with lumped, 1/sqrt 3 with consistent "
                "mass; stress and strain are of that order at centres only",
            .source = "Hughes2000",
            .rings = true,
            .fields =
                options.at_centres ? std::vector<std::string>{} : std::vector<std::string>{"displacement", "velocity"}};
}

Plan plan(const Scene& scene, const Values& options, const Values& resolution) {
    const Resolution fine = resolution_from(std::get<SolidScene<1>>(scene), resolution);
    return {.h = fine.h, .dt = fine.dt, .points = fine.cells + (options_from(options).at_centres ? 0.0 : 1.0)};
}

std::unique_ptr<Simulation> start(const Scene& scene, const Values& options, const Values& resolution,
                                  std::span<const std::string> fields) {
    const auto& solid = std::get<SolidScene<1>>(scene);
    return std::make_unique<Running>(solid, options_from(options), resolution_from(solid, resolution), fields);
}

}  // namespace

Solver solver() {
    return {
        .name = "fem",
        .about = "linear finite elements for a bar, total Lagrangian and explicit: a reference for particle methods",
        .source = {"Hughes2000"},
        .options = option_parameters(),
        .resolution = resolution_parameters(),
        .fields = {"displacement", "velocity", "stress", "strain"},
        .carries = "displacement",
        .claim = claim,
        .accepts = [](const Scene& scene) { return std::holds_alternative<SolidScene<1>>(scene); },
        .plan = plan,
        .start = start};
}

}  // namespace ordo::solvers::fem
