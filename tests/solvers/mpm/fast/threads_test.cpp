// Sections of a sweep: the same bits for any number of threads, and the same answer as in one piece.
#include <cstring>

#include "tests/solvers/mpm/fast/twins.hpp"

using namespace ordo;
using namespace ordo::solvers;
using namespace ordo::solvers::mpm;
using namespace ordo::solvers::mpm::test;

namespace {

struct Stepped {
    std::vector<double> numbers;  ///< all that may be asked of it
    std::size_t sections = 0;     ///< most in a step
    long crossings = 0;
    double skipped = 0;
    std::string why;
};

/// In sections of `section` blocks.
template <int dim>
Stepped stepped(const SolidScene<dim>& scene, const Given& options, const Given& resolution, int steps, int threads,
                long section) {
    Options chosen = options_of(options);
    chosen.threads = threads;
    REQUIRE(fast::serves(scene, chosen));
    const Resolution fine =
        resolution_from(scene, chosen, resolve(resolution_parameters(), resolution, "", "solver mpm"));
    fast::FastMpm<dim> body(scene, chosen, fine, true, section);
    Stepped end;
    try {
        for (int k = 0; k < steps; ++k) {
            end.sections = std::max(end.sections, body.sections());
            body.step(k * fine.dt, fine.dt, fine.dt);
        }
        body.meet_grid(steps * fine.dt);
    } catch (const Diverged& diverged) {
        end.why = diverged.what();
        return end;
    }
    const auto add = [&](const auto& values) {
        for (const auto& value : values)
            end.numbers.insert(end.numbers.end(), value.data(), value.data() + value.size());
    };
    const auto p = body.particles();
    add(p.x), add(p.v), add(p.sigma), add(p.F);
    add(std::vector{body.momentum(), body.impulse()});
    end.numbers.insert(end.numbers.end(), p.volume.begin(), p.volume.end());
    end.numbers.push_back(body.mass_on_grid());
    end.crossings = body.crossings();
    for (const auto& [what, share] : body.skipped()) end.skipped = share;
    return end;
}

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

double furthest(const std::vector<double>& a, const std::vector<double>& b) {
    double apart = a.size() == b.size() ? 0 : 1;
    for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k) {
        if (!(std::abs(a[k] - b[k]) <= apart)) apart = std::abs(a[k] - b[k]);
    }
    return apart;
}

/// The same bits with one, two and three threads; to round-off those of a sweep in one piece.
template <int dim>
Stepped check_threads(const SolidScene<dim>& scene, const Given& options, const Given& resolution, int steps,
                      long section) {
    const auto with = [&](int threads, long blocks) {
        return stepped(scene, options, resolution, steps, threads, blocks);
    };
    const Stepped one = with(1, section);
    const Stepped whole = with(2, 1'000'000);
    CHECK(whole.sections == 1);
    CHECK(one.why == whole.why);
    if (one.why.empty()) CHECK(furthest(one.numbers, whole.numbers) < round_off);
    CHECK(one.crossings == whole.crossings);
    for (const int threads : {2, 3}) {
        const Stepped more = with(threads, section);
        CHECK(more.why == one.why);
        CHECK(same_bits(more.numbers, one.numbers));
        CHECK(more.crossings == one.crossings);
        CHECK(more.skipped == one.skipped);
    }
    return one;
}

/// Particles that leave their cells on all sides, at up to a quarter of a cell a step.
template <int dim>
SolidScene<dim> whirling(double speed) {
    return box<dim>(Vec<dim>::Ones(), Face::free, pointwise<dim>([speed](const Vec<dim>& X, double) -> Vec<dim> {
                        Vec<dim> v;
                        for (int axis = 0; axis < dim; ++axis) v[axis] = speed * std::sin(9 * X.sum() + 3 * axis + 1);
                        return v;
                    }));
}

template <int dim>
Given fine_for(double courant) {
    return {{"cells", dim == 1 ? 1200.0 : 44.0}, {"ppc", 2.0}, {"courant", courant}};
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("threads: the same bits, staying and crossing", "[property]", ((int dim), dim), 1, 2) {
    for (const std::string update : {"usf", "usl", "musl"}) {
        for (const std::string basis : {"linear", "quadratic"}) {
            for (const double speed : {1e-7, 0.8}) {
                // Small sections have no spare slot, so that travellers wait for one; larger ones have a few.
                const long section = (dim == 1 ? 4 : 7) * (basis == "linear" ? 1 : 2);
                INFO(update << ", " << basis << ", speed " << speed << ", section " << section);
                const Given options{{"stress_update", update}, {"basis", basis}, {"margin", 0.25}};
                const int steps = dim == 1 ? 12 : 4;
                const auto end = check_threads<dim>(whirling<dim>(speed), options, fine_for<dim>(0.3), steps, section);
                CHECK(end.sections >= 8);
                CHECK((end.crossings > 300) == (speed > 0.1));
            }
        }
    }
}

TEST_CASE("threads: the same bits with loads, walls and the other schemes", "[property]") {
    for (const auto& scheme : schemes) {
        INFO(name_of(scheme));
        Given options = scheme;
        options["margin"] = 0.25;
        const bool damped = scheme.at("stress_update") != Value("usf");
        check_threads<1>(loaded<1>(thrown<1>(0.3, laws[0]), damped), options, fine_for<1>(0.3), 4, 3);
    }
}

TEST_CASE("threads: planes of blocks in space", "[property]") {
    const Given fine{{"cells", 20.0}, {"ppc", 1.0}, {"courant", 0.2}};
    const auto end = check_threads<3>(whirling<3>(0.8), {{"margin", 0.1}}, fine, 4, 30);
    CHECK(end.sections >= 8);
    CHECK(end.crossings > 300);
}

TEST_CASE("threads: the same bits where regions are at rest", "[property]") {
    for (const std::string update : {"usf", "musl"}) {
        INFO(update);
        auto scene = box<1>(Vec<1>(1.0), Face::roller, {});
        scene.velocity = pointwise<1>([middle = scene.lower[0] + 0.2](const Vec<1>& X, double) -> Vec<1> {
            return Vec<1>(std::abs(X[0] - middle) < 0.15 ? 0.4 * std::sin(50 * X[0]) : 0);
        });
        const Given fine{{"cells", 1280.0}, {"ppc", 2.0}, {"courant", 0.4}};
        const auto end = check_threads<1>(scene, {{"stress_update", update}}, fine, 40, 2);
        CHECK(end.sections >= 8);
        CHECK(end.crossings > 300);
        CHECK(end.skipped > 0.5);
    }
}

TEST_CASE("threads: what goes wrong in any of them is told in the same words", "[property]") {
    const auto crushed = check_threads<2>(whirling<2>(60), {{"stress_update", "usl"}}, fine_for<2>(0.5), 60, 7);
    CHECK_THAT(crushed.why, ContainsSubstring("turned inside out") || ContainsSubstring("left the grid"));
    const auto flying = box<1>(Vec<1>::Ones(), Face::free, uniform<1>(Vec<1>(1.0)));
    const auto lost = check_threads<1>(flying, {{"margin", 0.01}}, fine_for<1>(0.5), 60, 2);
    CHECK_THAT(lost.why, ContainsSubstring("left the grid"));
}

TEST_CASE("threads: a copy works on its own", "[property]") {
    Options options = options_of({{"stress_update", "musl"}, {"margin", 0.25}});
    options.threads = 2;
    const auto scene = whirling<1>(0.8);
    const Resolution fine = resolution_from(scene, options, resolve(resolution_parameters(), fine_for<1>(0.2), "", ""));
    auto body = std::make_unique<fast::FastMpm<1>>(scene, options, fine, false, 2);
    body->step(0, fine.dt, fine.dt);
    auto copy = *body;
    body->step(fine.dt, fine.dt, fine.dt);
    const auto x = body->particles().x;
    CHECK(body->helper_seconds() > 0);
    body.reset();
    copy.step(fine.dt, fine.dt, fine.dt);
    CHECK(copy.particles().x == x);
}

TEST_CASE("threads: a body of few cells is swept in one piece, by the caller alone", "[unit]") {
    Options options = options_of({});
    options.threads = 2;
    const auto scene = whirling<1>(0.8);
    const Resolution fine = resolution_from(scene, options, resolve(resolution_parameters(), fine_for<1>(0.2), "", ""));
    fast::FastMpm<1> body(scene, options, fine, false);
    body.step(0, fine.dt, fine.dt);
    CHECK(body.sections() == 1);
    CHECK(body.helper_seconds() == 0);
}

TEST_CASE("threads: refused where the readable kernel would run", "[unit]") {
    const Scene scene = whirling<1>(0.8);
    const Given fine{{"cells", 4.0}, {"dt", 0.01}};
    for (const Given& other : std::vector<Given>{{{"kernel", "readable"}}, {{"basis", "cubic"}}}) {
        CHECK_NOTHROW(started(scene, other, fine));
        Given two = other;
        two["threads"] = 2.0;
        CHECK_THROWS_WITH(started(scene, two, fine),
                          ContainsSubstring("'threads' is 2") && ContainsSubstring("nearest: 1"));
    }
    CHECK_NOTHROW(started(scene, {{"threads", 2.0}}, fine));
}

TEST_CASE("threads: sections of other lengths round otherwise", "[alarm]") {
    const auto scene = whirling<2>(0.8);
    const auto sums = [&](long section) { return stepped(scene, {}, fine_for<2>(0.2), 8, 1, section).numbers; };
    CHECK_FALSE(same_bits(sums(7), sums(1'000'000)));
}
