#include "oracles/lines/shock_collision.hpp"

#include "core/error.hpp"
#include "tests/catch.hpp"
#include "tests/oracles/lines/shock_collision_gate.hpp"

using namespace ordo;
using namespace ordo::oracles;
using namespace ordo::oracles::gate;
using namespace ordo::oracles::gate::collision;

TEST_CASE("shock collision: totals, waves, gas law and means hold before and after", "[gate]") {
    for (const auto& flow : flows) {
        INFO("x_L = " << flow.x_L << ", gamma = " << flow.gamma);
        CHECK(ringing_of(exact_of(flow), flow) == "");
        CHECK(means(exact_of(flow), flow).holds());
    }
}

TEST_CASE("shock collision: at the end two waves meet, and not before", "[gate]") {
    for (const auto& flow : flows) {
        INFO("x_L = " << flow.x_L << ", gamma = " << flow.gamma);
        const Exact exact = exact_of(flow);
        const double end = exact.times.high;
        const auto nearest = [&](double t) {
            const auto list = exact.waves(t);
            double gap = flow.x_R - flow.x_L;
            for (std::size_t i = 0; i + 1 < list.size(); ++i) {
                // Waves that left one place together are no meeting.
                gap = std::min(gap, list[i + 1].left - list[i].right);
            }
            return gap;
        };
        REQUIRE(std::isfinite(end));
        CHECK(std::abs(nearest(end)) <= 1e-12 * (flow.x_R - flow.x_L));
        CHECK(nearest(0.98 * end) > 1e-4 * (flow.x_R - flow.x_L));
        const double t_c = constant(exact, "t_c"), x_c = constant(exact, "x_c");
        CHECK((t_c <= end && (end > t_c) == (exact.constants({}).size() == 15)));
        // Just before t_c the innermost waves are at x_c, one from each side.
        const double before = t_c * (1 - 1e-12);
        int arrived = 0;
        for (const auto& wave : exact.waves(before)) {
            for (const double edge : {wave.left, wave.right}) arrived += std::abs(edge - x_c) < 1e-10;
        }
        CHECK(arrived >= 2);
        CHECK_THROWS_AS(exact.check(std::vector{0.0}, end * 1.0001, "test"), InputError);
    }
}

TEST_CASE("shock collision: the mirror image is the mirrored flow", "[property]") {
    const Exact one = exact_of(strong), other = exact_of(reversed);
    for (const double t : moments(strong, one)) {
        for (int i = 0; i < 200; ++i) {
            const double x = -3 + 0.0317 * i;
            const auto a = row_at(one, x, t), b = row_at(other, -x, t);
            CHECK(field(one, "density", a) == Approx(field(other, "density", b)).epsilon(1e-13));
            CHECK(field(one, "velocity", a) == Approx(-field(other, "velocity", b)).margin(1e-12));
        }
    }
}

TEST_CASE("shock collision: the inrush as another program has it", "[gate]") {
    // A separate prototype of the Riemann solver; all digits that it printed.
    const Exact exact = exact_of(inrush);
    const std::vector<std::pair<std::string, double>> found{{"p_star_left", 0.3546039},
                                                            {"v_star_left", 0.7165542},
                                                            {"rho_star_L_left", 0.275266},
                                                            {"rho_star_R_left", 0.149725},
                                                            {"p_star_right", 0.3798924},
                                                            {"v_star_right", -0.8078459},
                                                            {"rho_star_L_right", 0.156932},
                                                            {"rho_star_R_right", 0.493095},
                                                            {"t_c", 2.28080},
                                                            {"x_c", -0.07893},
                                                            {"p_star_after", 0.640986},
                                                            {"v_star_after", -0.090927},
                                                            {"rho_star_L_after", 0.227161},
                                                            {"rho_star_R_after", 0.227084}};
    for (const auto& [name, value] : found) {
        INFO(name);
        CHECK(constant(exact, name) == Approx(value).margin(6e-6));
    }
    // By hand from speeds printed there: -5 + 0.7165542 t = -0.07893 - 1.65220 (t - 2.28080).
    CHECK(exact.times.high == Approx(8.6894 / 2.36875).epsilon(2e-5));
}

TEST_CASE("shock collision: gases that part never meet, equal ones make one problem", "[unit]") {
    const Flow outwards{{1, -9, 1}, {1, 0, 1}, {1, 9, 1}, 1.4, -1, 1};  // 9 a = 7.6 a / (gamma - 1): two cavities
    const Exact parting = exact_of(outwards);
    CHECK(parting.times.high == constant(parting, "t_c"));  // the fans of the middle gas meet
    Flow one = inrush;
    one.left = one.middle;
    const Exact single = exact_of(one);
    CHECK(std::isinf(single.times.high));
    CHECK(single.waves(1).size() == 3);
    CHECK(at(single, "pressure", -120, 50) == 0.2);
    CHECK_THAT(refusal(shock_collision(), {{"x_L", 5.0}}),
               ContainsSubstring("x_L = 5") && ContainsSubstring("nearest: 6"));
    CHECK_THAT(refusal(shock_collision(), {{"rho_M", 0.0}}), ContainsSubstring("rho_M"));
}

TEST_CASE("alarm: shock collision: the gates ring for seeded faults", "[alarm]") {
    for (const auto& flow : {inrush, strong}) {
        const Exact good = exact_of(flow);
        const double t_c = constant(good, "t_c");
        const auto with = [&](auto change) {
            Claim claim{good, 0, 1, 1, {}, {}};
            return ringing_of(changed(claim, change).exact, flow);
        };
        const auto collided = [&](auto row, double t) {
            return t > t_c && row[2] > constant(good, "p_star_right") * 1.01;
        };
        CHECK_THAT(with([&](auto row, double, double t) {
                       if (collided(row, t)) row[2] *= 1 + 1e-6;
                   }),
                   ContainsSubstring("waves") && ContainsSubstring("gas law"));
        CHECK_THAT(with([&](auto row, double, double t) {
                       if (collided(row, t)) row[0] *= 1 + 1e-6;
                   }),
                   ContainsSubstring("waves") && ContainsSubstring("totals"));
        Exact late = good;  // the shocks pass through each other as if nothing had happened
        late.sample = [given = good.sample, t_c](auto x, double t, auto rows) { given(x, std::min(t, t_c), rows); };
        late.averages = [given = good.averages, t_c](auto x, double t, auto rows) { given(x, std::min(t, t_c), rows); };
        CHECK_THAT(ringing_of(late, flow), ContainsSubstring("waves") && ContainsSubstring("totals"));
        Exact moved = good;
        moved.jumps = [given = good.jumps](double t) { return given(t * (1 + 1e-6)); };
        CHECK_THAT(ringing_of(moved, flow), ContainsSubstring("waves"));
        Exact smeared = good;
        smeared.averages = [given = good.averages](auto edges, double t, auto rows) { given(edges, t * 0.999, rows); };
        CHECK_FALSE(means(smeared, flow).holds());
    }
}
