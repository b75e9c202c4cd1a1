#include "bench/kernels/cases.hpp"

#include <malloc.h>

#include <algorithm>
#include <ctime>
#include <memory>
#include <stdexcept>

#include "bench/reference/floor.hpp"
#include "bench/reference/scalar.hpp"
#include "solvers/solver.hpp"

namespace ordo::bench {
namespace {

using namespace ordo::solvers;

bool has_fast_kernel() {
    const auto& options = solver_named("mpm", "bench").options;
    return std::ranges::any_of(options, [](const Parameter& option) { return option.name == "kernel"; });
}

/// `with`: the capability that the scene has beside the wave; empty: none.
template <int dim>
SolidScene<dim> scene_of(const Wave& wave, const std::string& with) {
    SolidScene<dim> scene;
    for (int axis = 0; axis < dim; ++axis) {
        scene.upper[axis] = wave.h * wave.cells[axis];
        const Face face = wave.margin > 0 ? Face::free : Face::roller;
        scene.faces[axis] = {face, face};
    }
    scene.rho = wave.rho;
    // No law turns the stress in the bare loops; in one dimension none does.
    if constexpr (dim == 1) scene.law = LogarithmicLaw{{.lambda = wave.lambda, .mu = wave.mu}};
    else scene.law = NominalLaw{{.lambda = wave.lambda, .mu = wave.mu}};
    scene.velocity = [wave](std::span<const Vec<dim>> X, double, std::span<Vec<dim>> v) {
        for (std::size_t i = 0; i < X.size(); ++i) {
            std::array<double, 3> at{};
            for (int axis = 0; axis < dim; ++axis) at[axis] = X[i][axis];
            for (int axis = 0; axis < dim; ++axis) v[i][axis] = wave.velocity(at, axis);
        }
    };
    const auto nothing = [](std::span<const Vec<dim>>, double, std::span<Vec<dim>> out) {
        std::fill(out.begin(), out.end(), Vec<dim>::Zero());
    };
    if (with == "body_force") scene.body_force = nothing;
    if (with == "damping") scene.damping = 1e-6;
    if (with == "traction") {
        scene.faces[0][1] = Face::free;
        scene.traction = nothing;
    }
    return scene;
}

Scene solver_scene(const Wave& wave, const std::string& with) {
    if (wave.dim == 1) return scene_of<1>(wave, with);
    if (wave.dim == 2) return scene_of<2>(wave, with);
    return scene_of<3>(wave, with);
}

std::function<void(long)> solver_steps(const Wave& wave, const std::string& words) {
    const auto end = words.find(" with ");
    const std::string kernel = words.substr(0, end);
    const std::string with = end == std::string::npos ? "" : words.substr(end + 6);
    const Solver& solver = solver_named("mpm", "bench");
    Given options{{"basis", wave.degree == 1 ? "linear" : "quadratic"}, {"mass", "lumped"}, {"stress_update", "usl"}};
    if (wave.margin > 0) options["margin"] = static_cast<double>(wave.margin) / wave.cells[0];
    if (with == "fixed_volume") options["volume"] = "fixed";
    const std::vector<std::string> fields(with == "strain" ? 1 : 0, "strain");
    if (with == "threads") options["threads"] = 2.0;
    if (has_fast_kernel()) options["kernel"] = kernel;
    const Given resolution{{"cells", static_cast<double>(wave.cells[0])}, {"ppc", 2.0}, {"dt", wave.dt()}};
    std::shared_ptr<Simulation> simulation =
        solver.start(solver_scene(wave, with), resolve(solver.options, options, "", "bench"),
                     resolve(solver.resolution, resolution, "", "bench"), fields);
    return [simulation, dt = wave.dt(), done = 0L](long steps) mutable {
        done += steps;
        simulation->advance_to(static_cast<double>(done) * dt, [] { return false; });
    };
}

template <class Loop>
std::function<void(long)> bare_steps(std::shared_ptr<Loop> loop) {
    return [loop](long steps) {
        for (long i = 0; i < steps; ++i) loop->step();
    };
}

std::function<void(long)> steps_of(const Wave& wave, const std::string& loop) {
    if (loop == "scalar") return bare_steps(std::make_shared<Scalar>(wave));
    if (loop == "registers") return bare_steps(std::make_shared<Scalar>(wave, true));
    if (loop == "floor") return bare_steps(std::make_shared<Floor>(wave));
    if (loop.starts_with("floor ")) return bare_steps(std::make_shared<Floor>(wave, loop.substr(6)));
    if (loop.starts_with("solver ")) return solver_steps(wave, loop.substr(7));
    throw std::invalid_argument("no loop is named '" + loop + "'");
}

double bytes_in_use() {
    const auto info = mallinfo2();
    return static_cast<double>(info.uordblks + info.hblkhd);
}

}  // namespace

std::vector<std::string> loops_for(const Case& wanted) {
    std::vector<std::string> loops{"scalar"};
    if (wanted.dim == 1) loops.emplace_back("registers");
    if (!wanted.crossing) loops.emplace_back("floor");
    loops.emplace_back("solver readable");
    if (has_fast_kernel()) loops.emplace_back("solver fast");
    return loops;
}

Wave wave_of(const Case& wanted) {
    Wave wave{.dim = wanted.dim, .degree = wanted.degree};
    if (wanted.dim > 1) {
        wave.lambda = 30;
        wave.mu = 35;
    }
    for (int axis = 0; axis < wanted.dim; ++axis) wave.cells[axis] = wanted.cells;
    wave.v0 = 1e-6;
    if (wanted.crossing) {
        wave.drift = 0.26 * wave.h / wave.dt();
        wave.margin = 26 * (most_crossing_steps + 1) / 100 + 2;
    }
    return wave;
}

Started started(const Case& wanted) {
    const Wave wave = wave_of(wanted);
    const double before = bytes_in_use();
    auto steps = steps_of(wave, wanted.loop);
    steps(1);  // what is allocated by need
    return {steps, static_cast<double>(wave.particles()), bytes_in_use() - before};
}

double thread_seconds() {
    timespec time;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace ordo::bench
