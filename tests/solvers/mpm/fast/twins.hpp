#pragma once
// The same run by the fast and by the readable kernel, and how far apart they end.
#include "solvers/mpm/fast/fast.hpp"
#include "tests/catch.hpp"
#include "tests/solvers/mpm/bodies.hpp"

namespace ordo::solvers::mpm::test {

inline const std::vector<Law> laws{LogarithmicLaw{{.lambda = 0.7, .mu = 0.4}},
                                   ReciprocalLaw{{.lambda = 0.7, .mu = 0.4}}, NominalLaw{{.lambda = 0.7, .mu = 0.4}}};

/// A body that is thrown, swings and turns, held at one face and guided at another.
template <int dim>
SolidScene<dim> thrown(double speed, const Law& law) {
    const auto velocity = [speed](const Vec<dim>& X, double) -> Vec<dim> {
        return speed * Vec<3>(0.5, 0.31, -0.22).head<dim>() + 0.2 * Vec<dim>::Constant(std::sin(3 * X.sum()));
    };
    auto scene = box<dim>(Vec<dim>(Vec<3>(1.0, 0.5, 0.5).head<dim>()), Face::free, pointwise<dim>(velocity));
    scene.faces[0][0] = Face::fixed;
    if (dim > 1) scene.faces[1][1] = Face::roller;
    scene.law = law;
    return scene;
}

template <int dim>
SolidScene<dim> loaded(SolidScene<dim> scene, bool damped) {
    scene.body_force = pointwise<dim>(
        [](const Vec<dim>& X, double t) -> Vec<dim> { return Vec<dim>::Constant(0.1 * std::cos(X[0] + t)); });
    scene.traction = pointwise<dim>(
        [](const Vec<dim>& X, double t) -> Vec<dim> { return Vec<dim>::Constant(0.02 * std::sin(X[0] + 3 * t)); });
    if (damped) scene.damping = 0.1;
    return scene;
}

struct Ended {
    Snapshot shot;
    std::string why;  ///< it diverged; empty: it did not
    std::vector<Figure> work, drift;
};

inline Ended run(const Scene& scene, Given options, const std::string& kernel, const Given& resolution, double t) {
    options["kernel"] = kernel;
    const auto body = started(scene, options, resolution);
    Ended ended;
    try {
        body->advance_to(t / 3, never);
        body->advance_to(t, never);
        ended.shot = body->snapshot();
    } catch (const Diverged& diverged) {
        ended.why = diverged.what();
    }
    ended.work = body->work();
    ended.drift = body->drift();
    return ended;
}

/// Largest difference of a field in units of its largest value, or of a tenth: moduli, velocities and edges are near
/// one.
inline double furthest_apart(const Snapshot& a, const Snapshot& b) {
    double worst = 0;
    for (const auto& field : a.fields) {
        double scale = 0.1;
        double apart = 0;
        for (std::size_t k = 0; k < field.values.size(); ++k) {
            const double other = b.field(field.name).values[k];
            scale = std::max(scale, std::abs(other));
            if (!(std::abs(field.values[k] - other) <= apart)) apart = std::abs(field.values[k] - other);
        }
        if (!(apart / scale <= worst)) worst = apart / scale;
    }
    return worst;
}

/// The bits of everything that a run returns.
inline std::vector<double> numbers(const Ended& ended) {
    std::vector<double> all = ended.shot.x;
    all.insert(all.end(), ended.shot.weights.begin(), ended.shot.weights.end());
    for (const auto& field : ended.shot.fields) all.insert(all.end(), field.values.begin(), field.values.end());
    for (const auto& figure : ended.drift) all.push_back(figure.value);
    return all;
}

inline const Given small{{"cells", 4.0}, {"ppc", 2.0}, {"dt", 0.004}};

/// Sums of some tens of terms in another order, over 60 steps; a node with a small share of mass at the rim enlarges an
/// ulp a thousandfold. Runs that fail, fail alike.
constexpr double round_off = 1e-10;

template <int dim>
void check_alike(const SolidScene<dim>& scene, const Given& options, const Given& resolution, double t) {
    REQUIRE(fast::serves(scene, options_of(options)));
    const Ended fast = run(scene, options, "fast", resolution, t);
    const Ended readable = run(scene, options, "readable", resolution, t);
    CHECK(fast.why == readable.why);
    CHECK(figure(fast.work, "steps") == figure(readable.work, "steps"));
    if (!readable.why.empty()) return;
    CHECK(furthest_apart(fast.shot, readable.shot) < round_off);
    CHECK(figure(fast.work, "cell_crossings") == figure(readable.work, "cell_crossings"));
    CHECK(figure(fast.drift, "mass") < 1e-13);
    CHECK(std::abs(figure(fast.drift, "momentum") - figure(readable.drift, "momentum")) < 1e-12);
}

/// Orders of the stress update, times and frames that the fast kernel serves.
inline const std::vector<Given> schemes{{{"stress_update", "usf"}},
                                        {{"stress_update", "usl"}},
                                        {{"stress_update", "musl"}},
                                        {{"stress_update", "musl"}, {"position_update", "accelerated"}},
                                        {{"stress_update", "usl"}, {"time", "leapfrog"}},
                                        {{"stress_update", "musl"}, {"time", "leapfrog"}},
                                        {{"stress_update", "usf"}, {"frame", "total"}},
                                        {{"stress_update", "usl"}, {"frame", "total"}},
                                        {{"stress_update", "musl"}, {"frame", "total"}},
                                        {{"stress_update", "usl"}, {"volume", "fixed"}, {"placement", "gauss"}}};

inline std::string name_of(const Given& options) {
    std::string text;
    for (const auto& [option, value] : options) text += option + " " + text_of(value) + ", ";
    return text;
}

}  // namespace ordo::solvers::mpm::test
