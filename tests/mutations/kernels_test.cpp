// Solvers broken from inside: the house's kernels with a basis, law, mass, time scheme or medium of the tests' own.
#include "solvers/media/fields.hpp"
#include "solvers/rrm/chop_out.hpp"
#include "solvers/rrm/events.hpp"
#include "solvers/rrm/find.hpp"
#include "solvers/rrm/flatten.hpp"
#include "solvers/rrm/options.hpp"
#include "solvers/rrm/put_back.hpp"
#include "solvers/rrm/show.hpp"
#include "solvers/rrm/storage.hpp"
#include "solvers/rrm/waves.hpp"
#include "tests/catch.hpp"
#include "tests/mutations/drivers.hpp"
#include "tests/mutations/shipped.hpp"

namespace ordo::tests {
namespace {

using solvers::mpm::Particles;
using solvers::mpm::Spline;
using Bar = solvers::SolidScene<1>;
using enum studies::Fault;

// ---- bases: quadratic splines

using Quadratic = Spline<2>;

/// The middle function of a cell is 1 % too large; its slope is right.
struct HeavyWeight : Quadratic {
    HeavyWeight(int cell, double xi, int cells) : Quadratic(cell, xi, cells) { value[1] *= 1.01; }
};

/// The first function of a cell is 1 % too steep.
struct SteepSlope : Quadratic {
    SteepSlope(int cell, double xi, int cells) : Quadratic(cell, xi, cells) { slope[0] *= 1.01; }
};

/// The splines of the ends are those of the middle: they do not interpolate there.
struct OpenEnds : Quadratic {
    OpenEnds(int cell, double xi, int cells) : Quadratic(cell + 9, xi, cells + 18) {}
};

// ---- a hand in the house's MPM

/// Neo-Hookean without 1/J: the Kirchhoff stress for the Cauchy stress.
void lose_J(Particles<1>& p, const Bar& bar, double) {
    const auto& law = std::get<solvers::NeoHookeanLaw>(bar.law);
    for (std::size_t i = 0; i < p.size(); ++i) p.sigma[i] = p.F[i](0, 0) * law.cauchy<1>(p.F[i]);
}

void keep_law(Particles<1>& p, const Bar& bar, double) {
    const auto& law = std::get<solvers::NeoHookeanLaw>(bar.law);
    for (std::size_t i = 0; i < p.size(); ++i) p.sigma[i] = law.cauchy<1>(p.F[i]);
}

/// What the first cell holds stands still with its wall.
void hold_first_cell(Particles<1>& p, const Bar& bar, double h) {
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (p.X[i][0] < bar.lower[0] + h) p.v[i].setZero();
    }
}

void damp(Particles<1>& p, const Bar&, double) {
    for (auto& v : p.v) v *= 0.999;
}

void heavy_half(Particles<1>& p) {
    for (std::size_t i = p.size() / 2; i < p.size(); ++i) p.m[i] *= 1.01;
}

void light_end(Particles<1>& p) { p.m.front() *= 0.5; }

// ---- a gas for the Repeated Replacement Method

/// p = (gamma - 1) (energy - rho v^2): the half of the kinetic energy is lost.
struct LostHalf : solvers::IdealGas {
    solvers::Flow flow(const solvers::Contents& q) const {
        auto f = solvers::IdealGas::flow(q);
        f.p = (gamma - 1) * (q.energy - q.momentum * f.v);
        f.a = std::sqrt(gamma * f.p / f.rho);
        return f;
    }
};

/// The house's line of a gas of the tests' own, between reservoirs that no wave reaches.
template <class Gas>
class GasLine final : public solvers::Simulation {
public:
    GasLine(const solvers::LineScene& scene, const solvers::rrm::Options& options, std::span<const std::string> fields)
        : scene_(scene),
          fields_(solvers::line_fields(scene.medium, fields)),
          line_(Gas{std::get<solvers::IdealGas>(scene.medium)}, scene, options) {}

    void advance_to(double t, const solvers::Interrupt& interrupt) override {
        line_.advance_to(t, interrupt);
        t_ = t;
    }
    solvers::Snapshot snapshot() const override {
        auto pieces = line_.pieces(t_);
        pieces.front().from = scene_.edges.front();
        pieces.back().to = scene_.edges.back();
        std::vector<double> edges{pieces.front().from};
        for (const auto& piece : pieces) edges.push_back(piece.to);
        auto shot = solvers::snapshot_of_cells(t_, std::move(edges), scene_.medium, fields_,
                                               [&](std::size_t i) { return pieces[i].mean; });
        shot.slopes = solvers::rises_over_cells(
            scene_.medium, fields_, pieces.size(), [&](std::size_t i) { return pieces[i].left; },
            [&](std::size_t i) { return pieces[i].right; });
        return shot;
    }
    std::vector<solvers::Figure> work() const override {
        return {{"chop_outs", line_.counts().chop_outs}, {"cells_alive", static_cast<double>(line_.pieces(t_).size())}};
    }
    std::vector<solvers::Figure> drift() const override { return {}; }

private:
    solvers::LineScene scene_;
    std::vector<solvers::LineField> fields_;
    solvers::rrm::Line<Gas> line_;
    double t_ = 0;
};

template <class Gas>
Broken line_of() {
    solvers::Solver solver = solvers::solver_named("rrm", "");
    solver.start = [](const solvers::Scene& scene, const Values& options, const Values& resolution,
                      std::span<const std::string> fields) -> std::unique_ptr<solvers::Simulation> {
        const auto& line = std::get<solvers::LineScene>(scene);
        return std::make_unique<GasLine<Gas>>(line, solvers::rrm::options_from(line, options, resolution), fields);
    };
    return with_solver(std::move(solver));
}

struct RightGas : solvers::IdealGas {};

}  // namespace

Broken driven_bar(double first_kick) {
    solvers::Solver solver = solvers::solver_named("fem", "");
    solver.start = [first_kick](const solvers::Scene& scene, const Values& options, const Values& resolution,
                                std::span<const std::string>) -> std::unique_ptr<solvers::Simulation> {
        const auto& bar = std::get<Bar>(scene);
        return std::make_unique<DrivenBar>(bar, solvers::fem::options_from(options),
                                           solvers::fem::resolution_from(bar, resolution), first_kick);
    };
    return with_solver(std::move(solver));
}

MutationClass broken_kernels() {
    return {"kernel",
            {
                {"mpm: one function of the basis 1 % too large",
                 shipped::mpm_gauss_3,
                 bar_on_basis<HeavyWeight>(),
                 {order_too_low, at_floor, stalled}},
                {"mpm: one slope of the basis 1 % too steep",
                 shipped::mpm_gauss_3,
                 bar_on_basis<SteepSlope>(),
                 {order_too_low, at_floor, stalled, diverges}},
                {"mpm: the splines of the ends do not interpolate",
                 shipped::mpm_gauss_3,
                 bar_on_basis<OpenEnds>(),
                 {order_too_low, at_floor, stalled}},
                {"mpm: the stress lost its factor 1/J",
                 shipped::mpm_total,
                 driven_mpm<1>({.after_step = lose_J}),
                 {order_too_low, at_floor, stalled}},
                {"mpm: the wall holds the whole first cell",
                 shipped::mpm_bar,
                 driven_mpm<1>({.after_step = hold_first_cell}),
                 {published_differs}},
                {"mpm: a step loses 0.1 % of the velocity",
                 shipped::mpm_bar,
                 driven_mpm<1>({.after_step = damp}),
                 {order_too_low, at_floor, stalled}},
                {"mpm: one half of the bar is 1 % too heavy",
                 shipped::mpm_bar,
                 driven_mpm<1>({.start = heavy_half}),
                 {published_differs}},
                {"mpm: the first particle has half its mass",
                 shipped::mpm_bar,
                 driven_mpm<1>({.start = light_end}),
                 {published_differs}},
                {"mpm: the first kick is a whole step",
                 shipped::mpm_flight,
                 driven_mpm<2>({.first_kick = 1}),
                 {error_too_large}},
                {"fem: the first kick is a whole step",
                 shipped::fem_column,
                 driven_bar(1),
                 {order_too_low, order_uncertain, at_floor, pre_asymptotic}},
                {"rrm: the pressure lost the half of rho v^2 / 2",
                 shipped::gas_tube,
                 line_of<LostHalf>(),
                 {error_too_large, run_diverged}},
            }};
}

TEST_CASE("mutations: solvers broken from inside ring", "[alarm]") { try_all(broken_kernels()); }

TEST_CASE("mutations: what the drivers are made of breaks nothing", "[alarm]") {
    const std::vector<std::pair<Shipped, Broken>> whole{
        {shipped::mpm_gauss_3, bar_on_basis<Quadratic>()},
        {shipped::mpm_total, driven_mpm<1>({})},
        {shipped::mpm_total, driven_mpm<1>({.after_step = keep_law})},
        {shipped::mpm_bar, driven_mpm<1>({})},
        {shipped::mpm_flight, driven_mpm<2>({})},
        {shipped::fem_column, driven_bar(0.5)},
        {shipped::gas_tube, line_of<RightGas>()},
    };
    for (const auto& [study, unchanged] : whole) {
        const auto result = broken(study, unchanged);
        INFO(study.name << "\n" << what_rings(result));
        CHECK(result.verdict == studies::Verdict::pass);
    }
}

}  // namespace ordo::tests
