// The fast kernel against the readable one, which is the truth.
#include "solvers/mpm/fast/fast.hpp"

#include "tests/allocations.hpp"
#include "tests/solvers/mpm/fast/twins.hpp"

using namespace ordo;
using namespace ordo::solvers;
using namespace ordo::solvers::mpm;
using namespace ordo::solvers::mpm::test;

namespace {

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
