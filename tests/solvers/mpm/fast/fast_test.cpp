// The fast kernel against the readable one, which is the truth.
#include "solvers/mpm/fast/fast.hpp"

#include <map>

#include "tests/allocations.hpp"
#include "tests/catch.hpp"
#include "tests/solvers/mpm/bodies.hpp"

using namespace ordo;
using namespace ordo::solvers;
using namespace ordo::solvers::mpm;
using namespace ordo::solvers::mpm::test;

namespace {

const std::vector<Law> laws{LogarithmicLaw{{.lambda = 0.7, .mu = 0.4}}, ReciprocalLaw{{.lambda = 0.7, .mu = 0.4}},
                            NominalLaw{{.lambda = 0.7, .mu = 0.4}}};

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

Ended run(const Scene& scene, Given options, const std::string& kernel, const Given& resolution, double t) {
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
double furthest_apart(const Snapshot& a, const Snapshot& b) {
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
std::vector<double> numbers(const Ended& ended) {
    std::vector<double> all = ended.shot.x;
    all.insert(all.end(), ended.shot.weights.begin(), ended.shot.weights.end());
    for (const auto& field : ended.shot.fields) all.insert(all.end(), field.values.begin(), field.values.end());
    for (const auto& figure : ended.drift) all.push_back(figure.value);
    return all;
}

const Given small{{"cells", 4.0}, {"ppc", 2.0}, {"dt", 0.004}};

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
const std::vector<Given> schemes{{{"stress_update", "usf"}},
                                 {{"stress_update", "usl"}},
                                 {{"stress_update", "musl"}},
                                 {{"stress_update", "musl"}, {"position_update", "accelerated"}},
                                 {{"stress_update", "usl"}, {"time", "leapfrog"}},
                                 {{"stress_update", "musl"}, {"time", "leapfrog"}},
                                 {{"stress_update", "usf"}, {"frame", "total"}},
                                 {{"stress_update", "usl"}, {"frame", "total"}},
                                 {{"stress_update", "musl"}, {"frame", "total"}},
                                 {{"stress_update", "usl"}, {"volume", "fixed"}, {"placement", "gauss"}}};

std::string name_of(const Given& options) {
    std::string text;
    for (const auto& [option, value] : options) text += option + " " + text_of(value) + ", ";
    return text;
}

template <int dim>
void check_schemes(double speed, bool with_loads) {
    for (const auto& scheme : schemes) {
        for (const std::string basis : {"linear", "quadratic"}) {
            for (const std::string mesh : {"undeformed_mesh", "midpoint_mesh", "moved_mesh"}) {
                Given options = scheme;
                options["basis"] = basis;
                options["strain_increment"] = mesh;
                options["margin"] = 1.0;
                if (dim == 3 && basis == "quadratic") continue;  // not served
                if (scheme.contains("frame") && mesh == "moved_mesh") continue;
                for (const Law& law : laws) {
                    // In space each law with one mesh, for the time that the readable kernel takes.
                    if (dim == 3 && law.index() != (mesh[0] == 'u' ? 0U : mesh[1] == 'i' ? 1U : 2U)) continue;
                    INFO(dim << "D: " << name_of(options) << "law " << law.index());
                    auto scene = thrown<dim>(speed, law);
                    const bool damped = scheme.at("stress_update") != Value("usf");
                    if (with_loads) scene = loaded<dim>(scene, damped);
                    check_alike<dim>(scene, options, small, dim == 3 ? 0.12 : 0.24);
                }
            }
        }
    }
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("fast: as the readable kernel, without loads", "[property]", ((int dim), dim), 1, 2, 3) {
    check_schemes<dim>(0.3, false);
}

TEMPLATE_TEST_CASE_SIG("fast: as the readable kernel, with loads", "[property]", ((int dim), dim), 1, 2, 3) {
    check_schemes<dim>(0.3, true);
}

TEMPLATE_TEST_CASE_SIG("fast: in a free flight with many crossings a step", "[property]", ((int dim), dim), 1, 2, 3) {
    for (const std::string update : {"usf", "usl", "musl"}) {
        INFO(update);
        const Vec<dim> v = Vec<dim>(Vec<3>(7.0, 5.0, -3.1).head<dim>());  // up to a cell in a step
        const auto scene = box<dim>(Vec<dim>::Ones(), Face::free, uniform<dim>(v));
        check_alike<dim>(scene, {{"stress_update", update}, {"margin", 2.5}},
                         {{"cells", 5.0}, {"ppc", 3.0}, {"dt", 0.021}}, 0.21);
    }
}

TEST_CASE("fast: particles that start on faces, and stay there", "[property]") {
    // 1.5 particles a cell, in equal parts of the body: every third stands on a face exactly.
    for (const std::string update : {"usf", "usl", "musl"}) {
        for (const std::string basis : {"linear", "quadratic"}) {
            for (const double v0 : {0.0, 0.05}) {
                INFO(update << ", " << basis << ", v0 = " << v0);
                auto scene = fixed_free_bar(1, 1, v0, NominalLaw{{.lambda = 0, .mu = 0.5}});
                scene.faces = {{{Face::free, Face::free}}};
                if (v0 == 0) scene.traction = uniform<1>(Vec<1>(0.0));
                const Given options{{"stress_update", update}, {"basis", basis}, {"placement", "body_centred"}};
                check_alike<1>(scene, options, {{"cells", 8.0}, {"ppc", 1.5}, {"dt", 0.01}}, 0.3);
            }
        }
    }
}

TEST_CASE("fast: a node without mass that a particle on a face touches", "[property]") {
    // A lone particle on a face pulls at a node that no other feels.
    for (const std::string update : {"usf", "usl", "musl"}) {
        INFO(update);
        auto scene = fixed_free_bar(1, 1, 0.1, LogarithmicLaw{{.lambda = 0, .mu = 0.5}});
        scene.faces = {{{Face::free, Face::free}}};
        const Given options{{"stress_update", update}, {"placement", "body_centred"}};
        check_alike<1>(scene, options, {{"cells", 2.0}, {"ppc", 0.5}, {"dt", 0.01}}, 0.1);
    }
}

TEST_CASE("fast: what leaves the grid or is turned inside out is told in the same words", "[property]") {
    for (const std::string update : {"usf", "usl", "musl"}) {
        INFO(update);
        const Given options{{"stress_update", update}};
        const auto flying = box<2>({1, 0.5}, Face::free, uniform<2>({2, 0.1}));
        const auto crushed = thrown<2>(40, laws[0]);
        check_alike<2>(flying, options, small, 2);
        check_alike<2>(crushed, options, small, 0.5);
        CHECK(run(flying, options, "fast", small, 2).why.find("left the grid") != std::string::npos);
        CHECK_FALSE(run(crushed, options, "fast", small, 0.5).why.empty());
    }
}

TEMPLATE_TEST_CASE_SIG("fast: the same bits with each set of instructions", "[property]", ((int dim), dim), 1, 2, 3) {
    std::vector<std::string> sets{"baseline"};
    if (fast::has(fast::Set::avx2)) sets.emplace_back("avx2");
    if (fast::has(fast::Set::avx512)) sets.emplace_back("avx512");
    for (const auto& scheme : schemes) {
        for (const std::string basis : {"linear", "quadratic"}) {
            INFO(name_of(scheme) << basis);
            Given options = scheme;
            options["basis"] = basis;
            options["margin"] = 1.0;
            std::map<std::string, std::vector<double>> bits;
            for (const auto& set : sets) {
                setenv("ORDO_SIMD", set.c_str(), 1);
                bits[set] = numbers(run(loaded<dim>(thrown<dim>(0.3, laws[0]), false), options, "fast", small, 0.06));
            }
            unsetenv("ORDO_SIMD");
            CHECK(bits["baseline"].size() > 4);
            for (const auto& set : sets) CHECK(bits[set] == bits["baseline"]);
        }
    }
}

TEST_CASE("fast: an unknown set of instructions is refused", "[unit]") {
    setenv("ORDO_SIMD", "sse9", 1);
    CHECK_THROWS_WITH(fast::chosen_set(), ContainsSubstring("sse9") && ContainsSubstring("avx2"));
    unsetenv("ORDO_SIMD");
    CHECK_NOTHROW(fast::chosen_set());
}

TEMPLATE_TEST_CASE_SIG("fast: quiet regions are skipped, and nothing changes", "[property]", ((int dim), dim), 1, 2) {
    for (const std::string update : {"usf", "usl", "musl"}) {
        for (const std::string basis : {"linear", "quadratic"}) {
            INFO(update << ", " << basis);
            // One end is struck; the wave has gone a fifth of the way.
            auto scene = box<dim>(Vec<dim>(Vec<3>(1.0, 0.05, 0.05).head<dim>()), Face::roller, {});
            const double struck = scene.lower[0] + 0.1;
            scene.velocity = pointwise<dim>([struck](const Vec<dim>& X, double) -> Vec<dim> {
                return (X[0] < struck ? 0.01 : 0) * Vec<dim>::Unit(0);
            });
            const Given options{{"stress_update", update}, {"basis", basis}};
            const Given fine{{"cells", dim == 1 ? 400.0 : 200.0}, {"ppc", 2.0}, {"courant", 0.5}};
            const double t = 0.1;
            const Ended skipping = run(scene, options, "fast", fine, t);
            const Ended all = run(scene, options, "fast_everywhere", fine, t);
            // What is less than 1e-30 of the wave speed counts as rest; where amplitudes grow from there, sums round
            // differently. Velocities and stresses are near 0.01.
            for (const auto& field : skipping.shot.fields) {
                double apart = 0;
                for (std::size_t k = 0; k < field.values.size(); ++k)
                    apart = std::max(apart, std::abs(field.values[k] - all.shot.field(field.name).values[k]));
                CHECK(apart < (dim == 1 ? 1e-17 : 1e-15));
            }
            Given on = options;
            on["kernel"] = "fast";
            const auto body = started(scene, on, fine);
            body->advance_to(t, never);
            REQUIRE(body->skipped().size() == 1);
            CHECK(body->skipped()[0].share > 0.5);
            CHECK(body->skipped()[0].share < 0.95);
        }
    }
}

TEST_CASE("fast: a loaded end wakes a body at rest", "[property]") {
    auto scene = fixed_free_bar(1, 1, 0, LogarithmicLaw{{.lambda = 0, .mu = 0.5}});
    scene.traction = uniform<1>(Vec<1>(0.01));
    for (const std::string update : {"usf", "usl", "musl"}) {
        INFO(update);
        const Given options{{"stress_update", update}};
        const Given fine{{"cells", 300.0}, {"ppc", 2.0}, {"courant", 0.2}};
        check_alike<1>(scene, options, fine, 0.1);
        CHECK(run(scene, options, "fast", fine, 0.1).shot.field("velocity").values.back() > 1e-3);
    }
}

TEMPLATE_TEST_CASE_SIG("fast: after the first step none allocates", "[property]", ((int dim), dim), 1, 2, 3) {
    for (const std::string update : {"usf", "usl", "musl"}) {
        INFO(update);
        auto scene = box<dim>(Vec<dim>::Ones(), Face::free, uniform<dim>(Vec<dim>::Constant(0.5)));
        scene.body_force = uniform<dim>(Vec<dim>::Constant(-1));
        const auto body =
            started(scene, {{"stress_update", update}, {"margin", 1.0}}, {{"cells", 4.0}, {"ppc", 2.0}, {"dt", 0.02}});
        body->advance_to(0.02, never);
        const long before = ordo::test::allocations();
        body->advance_to(1, never);
        CHECK(ordo::test::allocations() - before == 0);
        CHECK(figure(body->work(), "cell_crossings") > 0);
    }
}

TEST_CASE("fast: what it does not serve runs readable", "[unit]") {
    const auto scene = thrown<1>(0.3, laws[0]);
    CHECK(fast::serves(scene, options_of({})));
    for (const Given& other : std::vector<Given>{{{"kernel", "readable"}},
                                                 {{"basis", "cubic"}},
                                                 {{"mass", "consistent"}},
                                                 {{"transfer", "pic"}},
                                                 {{"time", "yoshida4"}},
                                                 {{"stress_update", "usavg"}},
                                                 {{"stress_from", "F"}},
                                                 {{"body_force", "nodes"}},
                                                 {{"traction", "last_particle"}},
                                                 {{"beyond_grid", "follow"}}})
        CHECK_FALSE(fast::serves(scene, options_of(other)));
    CHECK_FALSE(fast::serves(thrown<1>(0.3, HenckyLaw{{.lambda = 0, .mu = 0.5}}), options_of({})));
}

TEST_CASE("fast: the comparison sees a step of another kind", "[alarm]") {
    const auto scene = thrown<2>(0.3, laws[0]);
    const Ended usl = run(scene, {{"stress_update", "usl"}}, "fast", small, 0.24);
    const Ended musl = run(scene, {{"stress_update", "musl"}}, "readable", small, 0.24);
    CHECK(furthest_apart(usl.shot, musl.shot) > 1e3 * round_off);
    CHECK(numbers(usl) != numbers(run(scene, {{"stress_update", "usl"}}, "readable", small, 0.24)));
}
