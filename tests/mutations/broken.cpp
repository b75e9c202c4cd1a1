#include "tests/mutations/broken.hpp"

#include <cmath>

namespace ordo::tests {
namespace {

using solvers::Plan;
using solvers::Scene;
using solvers::Simulation;
using solvers::Snapshot;

class Veiled final : public Simulation {
public:
    Veiled(std::unique_ptr<Simulation> inner, const Veil& veil, const Plan& plan)
        : inner_(std::move(inner)), veil_(veil), plan_(plan) {}

    void advance_to(double t, const solvers::Interrupt& interrupt) override {
        t_ = t;
        inner_->advance_to(veil_.clock ? veil_.clock(t, plan_) : t, interrupt);
    }
    Snapshot snapshot() const override {
        Snapshot shot = inner_->snapshot();
        shot.t = t_;
        if (veil_.shown) veil_.shown(shot, plan_);
        return shot;
    }
    std::vector<solvers::Figure> work() const override { return inner_->work(); }
    std::vector<solvers::Figure> drift() const override { return inner_->drift(); }

private:
    std::unique_ptr<Simulation> inner_;
    Veil veil_;
    Plan plan_;
    double t_ = 0;
};

Compared compared(const studies::Quantity& quantity, const Snapshot& shot, const oracles::Exact& exact) {
    const Field& found = shot.field(quantity.field);
    const auto& x = exact.coordinates == oracles::Coordinates::material ? shot.X : shot.x;
    std::vector<double> rows(shot.points() * exact.width());
    exact.sample(x, shot.t, rows);
    const auto components = static_cast<std::size_t>(found.components);
    Compared both{found.values, {}, shot.weights, components};
    for (std::size_t row = exact.offset(quantity.field).value(); row < rows.size(); row += exact.width()) {
        for (std::size_t c = 0; c < components; ++c) both.exact.push_back(rows[row + c]);
    }
    return both;
}

}  // namespace

double Compared::error(std::size_t point) const {
    double square = 0;
    for (std::size_t k = point * components; k < (point + 1) * components; ++k)
        square += (found[k] - exact[k]) * (found[k] - exact[k]);
    return std::sqrt(square);
}

Broken with_solver(solvers::Solver changed) {
    Broken broken{.parts = studies::house_parts(), .solver = changed.name};
    broken.parts->solver = [kept = std::make_shared<solvers::Solver>(std::move(changed))](
                               const std::string& name) -> const solvers::Solver& {
        return name == kept->name ? *kept : solvers::solver_named(name, "");
    };
    return broken;
}

Broken with_choices(const std::string& name, const Rewrite& rewrite) {
    solvers::Solver solver = solvers::solver_named(name, "");
    solver.start = [house = solver, rewrite](const Scene& scene, const Values& options, const Values& resolution,
                                             std::span<const std::string> fields) {
        Given other_options = options.all();
        Given other_resolution = resolution.all();
        rewrite(other_options, other_resolution);
        return house.start(scene, Values(other_options), Values(other_resolution), fields);
    };
    return with_solver(std::move(solver));
}

Broken behind(const std::string& name, const Veil& veil) {
    solvers::Solver solver = solvers::solver_named(name, "");
    solver.start = [house = solver, veil](const Scene& scene, const Values& options, const Values& resolution,
                                          std::span<const std::string> fields) -> std::unique_ptr<Simulation> {
        return std::make_unique<Veiled>(house.start(scene, options, resolution, fields), veil,
                                        house.plan(scene, options, resolution));
    };
    return with_solver(std::move(solver));
}

Broken with_truth(const ChangeTruth& change) {
    Broken broken{.parts = studies::house_parts()};
    broken.parts->scene = [change, kept = std::make_shared<studies::SceneEntry>()](
                              const std::string& name) -> const studies::SceneEntry& {
        const auto& house = studies::scene_named(name, "");
        *kept = house;
        kept->truth = [change, truth = house.truth](const Values& values) { return change(values, truth(values)); };
        return *kept;
    };
    return broken;
}

Broken with_errors(const Errors& errors) {
    Broken broken{.parts = studies::house_parts()};
    broken.parts->errors = errors;
    return broken;
}

Broken with_norm(const std::function<double(const Compared&)>& norm) {
    return with_errors([norm](const auto& quantities, const Snapshot& shot, const oracles::Exact& exact) {
        std::vector<studies::RunFigure> errors;
        for (const auto& quantity : quantities)
            errors.push_back({quantity.key(), norm(compared(quantity, shot, exact))});
        return errors;
    });
}

Broken with_plan(const std::function<void(std::vector<studies::RunSpec>&)>& change) { return {.plan = change}; }
Broken with_runs(const std::function<void(std::vector<studies::Run>&)>& change) { return {.runs = change}; }

}  // namespace ordo::tests
