// Seeded faults and random data for bar_traction.
#include <string>
#include <vector>

#include "core/error.hpp"
#include "oracles/bars/bar_traction.hpp"
#include "tests/catch.hpp"
#include "tests/oracles/bars/bar_traction_cases_gate.hpp"
#include "tests/oracles/fuzz.hpp"

using namespace ordo;
using namespace ordo::oracles;
using namespace ordo::oracles::gate;
using namespace ordo::oracles::gate::loaded;

TEST_CASE("bar_traction: the gates ring for seeded faults", "[alarm]") {
    for (const auto& bar : {loaded_bars()[1], loaded_bars()[3], loaded_bars()[6]}) {
        INFO(name_of(bar));
        const BarMotion good = motion_of(bar);
        REQUIRE(ringing(good).empty());

        const auto other = [&](const BarTraction& faulty) {
            BarMotion motion = good;
            return with_members(std::move(motion), faulty);
        };
        BarTraction faulty = bar;
        faulty.tau *= 1 + 1e-6;
        CHECK_THAT(ringing(other(faulty)), ContainsSubstring("data"));
        faulty = bar;
        faulty.tau = -bar.tau;
        CHECK_THAT(ringing(other(faulty)), ContainsSubstring("data") && ContainsSubstring("energy"));
        faulty = bar;
        faulty.rho *= 1 + 1e-6;
        CHECK_THAT(ringing(other(faulty)), ContainsSubstring("energy"));
        if (bar.profile == Profile::sine) {
            faulty = bar;
            faulty.omega *= 1 + 1e-6;
            CHECK_THAT(ringing(other(faulty)), ContainsSubstring("data"));
        }

        // The second image forgotten: from the first return on, as if the fixed end were not there.
        BarMotion one_way = good;
        one_way.displacement = [good](double X, double t) {
            return t < good.transit() ? good.displacement(X, t) : good.displacement(good.L, t);
        };
        CHECK_THAT(ringing(one_way), ContainsSubstring("equation") && ContainsSubstring("data"));
        BarMotion sides = good;  // mirrored
        for (auto field : {&BarMotion::displacement, &BarMotion::velocity, &BarMotion::strain, &BarMotion::stress})
            sides.*field = [f = good.*field, L = bar.L](double X, double t) { return f(L - X, t); };
        CHECK_THAT(ringing(sides), ContainsSubstring("data"));
        BarMotion sign = good;
        sign.velocity = [good](double X, double t) { return -good.velocity(X, t); };
        CHECK_THAT(ringing(sign), ContainsSubstring("equation") && ContainsSubstring("energy"));
        BarMotion slow = good;
        slow.displacement = [good](double X, double t) { return good.displacement(X, t * (1 - 1e-6)); };
        CHECK_FALSE(ringing(slow).empty());
        BarMotion broken = good;
        broken.strain = [](double, double) { return std::nan(""); };
        CHECK_THAT(ringing(broken), ContainsSubstring("equation") && ContainsSubstring("energy"));
    }
    BarTraction faulty = loaded_bars()[1];
    const BarMotion good = motion_of(faulty);
    BarMotion left_state = good;  // at the front the state to its left
    left_state.velocity = [good](double X, double t) { return good.velocity(std::nextafter(X, -1.0), t); };
    CHECK_THAT(ringing(left_state), ContainsSubstring("fronts"));
    BarMotion elsewhere = good;
    elsewhere.jumps = [good](double t) { return std::vector{good.L - good.jumps(t).front()}; };
    CHECK_THAT(ringing(elsewhere), ContainsSubstring("fronts"));
    // A series off by one part in a million, and a bound that is too small.
    BarTraction bar = loaded_bars()[3];
    bar.tau *= 1 + 1e-6;
    const double X = bar.L, t = 1.3 * bar.L / bar.wave_speed();
    CHECK(std::abs(bar.displacement(X, t) - loaded_bars()[3].lifted_displacement(X, t, 3000)) > bar.lifted_bound(3000));
}

TEST_CASE("bar_traction: random loads obey both ends, and the mean strain is the displacement of the end",
          "[property]") {
    Random random(20261);
    Tally tally;
    const Oracle oracle = bar_traction();
    const int rounds = fuzz_rounds(2000);
    for (int round = 0; round < rounds; ++round) {
        const bool extreme = round % 10 == 0;
        const double decades = extreme ? 1e150 : 1e4;
        BarTraction bar{.L = random.log_uniform(1 / decades, decades),
                        .E = random.log_uniform(1 / decades, decades),
                        .rho = random.log_uniform(1 / decades, decades),
                        .tau = random.uniform(-3, 3)};
        bar.profile = random.coin() ? Profile::sine : Profile::step;
        const double theta = random.coin() ? (random.whole(1, 9) - 0.5) * pi : random.log_uniform(1e-3, 1e3);
        bar.omega = theta * bar.wave_speed() / bar.L;
        if (!(bar.omega > 0 && std::isfinite(bar.omega))) bar.omega = 1;
        try {
            const Exact exact = oracle.bind(resolve(oracle.parameters, given_by(bar), "", "bar_traction"));
            const bool sine = bar.profile == Profile::sine;
            const double transit = bar.L / bar.wave_speed();
            const double t = random.log_uniform(1e-3, sine ? 1e4 / (1 + theta) : 1e4) * transit;
            const Row root = row_at(exact, 0, t), end = row_at(exact, bar.L, t);
            const Row inside = row_at(exact, random.uniform(0, 1) * bar.L, t);
            for (const double value : {inside[0], inside[1], inside[2], inside[3], end[0], end[1]})
                REQUIRE(std::isfinite(value));
            if (extreme) {  // identities underflow: nothing but finite values is asked
                ++tally.refused;
                continue;
            }
            const double strain = std::abs(bar.tau) / bar.E;
            // 1 + number of images at most: the amplitude anywhere until t.
            const double most = sine ? std::min(2 + t / transit, 2 + 2 / std::abs(std::cos(theta))) : 2;
            const double tolerance = 1e-14 * (1 + (sine ? bar.omega * t : t / transit)) * most * strain;
            REQUIRE(root[0] == 0);
            REQUIRE(root[1] == 0);
            const double load = sine ? bar.tau / bar.E * std::sin(bar.omega * t) : bar.tau / bar.E;
            INFO(name_of(bar) << " t " << t / transit << " strain " << end[3] << " load " << load);
            REQUIRE(std::abs(end[3] - load) <= tolerance);
            const Row bar_mean = mean_over(exact, 0, bar.L, t);  // of the strain: the ends' displacement
            REQUIRE(std::abs(bar_mean[3] - end[0] / bar.L) <= 2 * tolerance);
            ++tally.checked;
        } catch (const InputError&) {
            REQUIRE(extreme);  // only data whose speed or amplitude is no number are refused
            ++tally.refused;
        }
    }
    CHECK(tally.mostly_checked());
}
