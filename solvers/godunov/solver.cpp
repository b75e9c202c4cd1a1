// The door of the fixed grid: from declared values to a running line.
#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "solvers/godunov/godunov.hpp"
#include "solvers/media/fields.hpp"

namespace ordo::solvers::godunov {
namespace {

/// Steps a Grid in time, counts its work and reads its fields. Each step is as long as the Courant number allows in the
/// fastest cell; the last one before a stop is cut to end there.
class Running final : public Simulation {
public:
    Running(const LineScene& scene, const Options& options, const Resolution& resolution,
            std::span<const std::string> fields)
        : medium_(scene.medium),
          fields_(line_fields(scene.medium, fields)),
          second_order_(options.second_order),
          longest_(resolution.courant * resolution.h),
          grid_(scene, options, resolution),
          start_(grid_.balance()) {}

    void advance_to(double t, const Interrupt& interrupt) override {
        constexpr double most_steps = 1e9;
        const double shortest_step = (t - t_) / most_steps;
        while (t_ < t) {
            if (interrupt()) throw Interrupted("interrupted");
            const double dt = longest_ / grid_.fastest(t_);
            const double next = t_ + dt < t ? t_ + dt : t;
            if (next < t && dt < shortest_step)
                throw Diverged("the time step has shrunk to " + shortest(dt) + " s at t = " + shortest(t_));
            if (next == t_) throw Diverged("the time step is lost in the time at t = " + shortest(t_));
            touched_ += static_cast<double>(grid_.active());
            grid_.step(next == t ? t - t_ : dt);
            t_ = next;
            ++steps_;
        }
        grid_.fastest(t_);  // refuses what the last step has left
    }

    Snapshot snapshot() const override {
        std::vector<double> edges;
        for (std::size_t i = 0; i <= grid_.size(); ++i) edges.push_back(grid_.edge(i));
        Snapshot shot =
            snapshot_of_cells(t_, std::move(edges), medium_, fields_, [&](std::size_t i) { return grid_.mean(i); });
        if (second_order_) shot.slopes = slopes();
        return shot;
    }

    std::vector<Figure> work() const override {
        return {{"steps", static_cast<double>(steps_)}, {"cell_updates", cell_updates()}};
    }

    std::vector<Skipped> skipped() const override {
        if (steps_ == 0) return {};
        return {{"updates of quiet cells", 1 - touched_ / cell_updates()}};
    }

    /// What is held now against what was held at the start and has passed the ends, relative to the sizes of both.
    std::vector<Figure> drift() const override {
        const Grid::Balance now = grid_.balance();
        const Contents defect = now.held - start_.held - now.passed;
        const Contents size = now.held_size + now.passed_size;
        const auto relative = [](double part, double whole) { return whole == 0 ? 0 : std::abs(part) / whole; };
        return {{"mass", relative(defect.mass, size.mass)},
                {"momentum", relative(defect.momentum, size.momentum)},
                {"energy", relative(defect.energy, size.energy)}};
    }

private:
    double cell_updates() const { return static_cast<double>(steps_) * static_cast<double>(grid_.size()); }

    std::vector<Field> slopes() const {
        Grid now = grid_;
        now.reconstruct_now();
        return rises_over_cells(
            medium_, fields_, now.size(), [&](std::size_t i) { return now.left(i); },
            [&](std::size_t i) { return now.right(i); });
    }

    Medium medium_;
    std::vector<LineField> fields_;
    bool second_order_;
    double longest_;  ///< way of the fastest wave in a step [m]
    Grid grid_;
    Grid::Balance start_;
    double t_ = 0;
    long steps_ = 0;
    double touched_ = 0;  ///< cells, summed over the steps
};

double fastest_piece(const LineScene& scene) {
    double fastest = 0;
    for (const Contents& q : scene.pieces) {
        const Flow f = std::visit([&](const auto& kind) { return kind.flow(q); }, scene.medium);
        fastest = std::max(fastest, std::abs(f.v) + f.a);
    }
    return fastest;
}

Claim claim(const Values& values) {
    const double order = values.word("order") == "second" ? 2 : 1;
    const bool steep = order == 2 && values.word("limiter") == "superbee";
    return {.order_in_space = order,
            .order_in_time = order,
            .conserves = {"mass", "momentum", "energy"},
            .provided = "smooth flow, in l1; where there are shocks and contacts at most 1",
            .source = "Toro2009",
            .rings = order == 2 && values.word("limiter") == "central",
            .steep = steep ? std::vector<std::string>{"contact", "linear"} : std::vector<std::string>{}};
}

Plan plan(const Scene& scene, const Values& options, const Values& resolution) {
    const auto& line = std::get<LineScene>(scene);
    check(line);
    options_from(line.medium, options);
    const Resolution fine = resolution_from(line, resolution);
    return {.h = fine.h, .dt = fine.courant * fine.h / fastest_piece(line), .points = static_cast<double>(fine.cells)};
}

std::unique_ptr<Simulation> start(const Scene& scene, const Values& options, const Values& resolution,
                                  std::span<const std::string> fields) {
    const auto& line = std::get<LineScene>(scene);
    check(line);
    return std::make_unique<Running>(line, options_from(line.medium, options), resolution_from(line, resolution),
                                     fields);
}

}  // namespace

Solver solver() {
    return {.name = "godunov",
            .about = "Godunov's method on a fixed grid, first order or MUSCL-Hancock: a reference for moving cells",
            .source = {"Godunov1959", "VanLeer1979", "Toro2009"},
            .options = option_parameters(),
            .resolution = resolution_parameters(),
            .fields = line_field_names(),
            .fields_in = line_fields_in,
            .claim = claim,
            .accepts = is_line,
            .plan = plan,
            .start = start};
}

}  // namespace ordo::solvers::godunov
