// Seeded faults and random data for the oedometer.
#include <string>
#include <vector>

#include "core/error.hpp"
#include "oracles/bars/oedometer.hpp"
#include "tests/catch.hpp"
#include "tests/oracles/bars/oedometer_cases_gate.hpp"
#include "tests/oracles/fuzz.hpp"

using namespace ordo;
using namespace ordo::oracles;
using namespace ordo::oracles::gate;
using namespace ordo::oracles::gate::loaded;

TEST_CASE("oedometer: the gates ring for seeded faults", "[alarm]") {
    for (const auto& column : {columns()[3], columns()[6]}) {
        INFO(name_of(column));
        const BarMotion good = motion_of(column);
        REQUIRE(ringing(good).empty());
        const auto other = [&](double Oedometer::*member, double factor) {
            Oedometer faulty = column;
            faulty.*member *= factor;
            BarMotion motion = good;
            return ringing(with_members(std::move(motion), faulty));
        };
        CHECK_THAT(other(&Oedometer::g, 1 + 1e-6), ContainsSubstring("equation"));
        CHECK_THAT(other(&Oedometer::g, -1), ContainsSubstring("equation"));
        CHECK_THAT(other(&Oedometer::p0, 1 + 1e-6), ContainsSubstring("data"));
        CHECK_THAT(other(&Oedometer::p0, -1), ContainsSubstring("data"));
        CHECK_FALSE(other(&Oedometer::rho, 1 + 1e-6).empty());
        CHECK_FALSE(other(&Oedometer::H, 1 + 1e-6).empty());
        if (column.ramp > 0) CHECK_THAT(other(&Oedometer::ramp, 1 + 1e-6), ContainsSubstring("equation"));
        // The wave from the free end forgotten, and its sign.
        for (const double factor : {0.0, 2.0}) {
            BarMotion reflected = good;
            reflected.displacement = [=](double X, double t) {
                const double e = std::max(0.0, good.speed() * t - 2 * good.L + X);
                return good.displacement(X, t) - factor * 1e-6 * e * e;
            };
            CHECK(ringing(reflected).empty() == (factor == 0));
        }
        BarMotion sign = good;
        sign.strain = [good](double X, double t) { return -good.strain(X, t); };
        CHECK_THAT(ringing(sign), ContainsSubstring("equation"));
        BarMotion broken = good;
        broken.displacement = [](double, double) { return std::nan(""); };
        CHECK_THAT(ringing(broken), ContainsSubstring("equation") && ContainsSubstring("data"));
    }
}

TEST_CASE("oedometer: the gates ring for a truncated series", "[alarm]") {
    Oedometer truncated = columns()[3];
    truncated.terms = 20;
    BarMotion series = motion_of(columns()[3]);
    CHECK_THAT(ringing(with_members(std::move(series), truncated)),
               ContainsSubstring("equation") && ContainsSubstring("data") && ContainsSubstring("fronts"));
}

TEST_CASE("oedometer: random columns obey both ends, and their mean strain is the top's displacement", "[property]") {
    Random random(20262);
    Tally tally;
    const Oracle oracle = oedometer();
    const int rounds = fuzz_rounds(1000);
    for (int round = 0; round < rounds; ++round) {
        const bool extreme = round % 10 == 0;
        const double decades = extreme ? 1e150 : 1e4;
        Oedometer column{.H = random.log_uniform(1 / decades, decades),
                         .E = random.log_uniform(1 / decades, decades),
                         .rho = random.log_uniform(1 / decades, decades),
                         .g = random.coin() ? random.log_uniform(1e-3, 1e3) : 0,
                         .p0 = random.coin() ? random.uniform(-3, 3) : 0};
        const double transit = column.H / column.wave_speed();
        if (random.coin() && transit > 0) column.ramp = random.log_uniform(1e-6, 20) * transit;
        if (!std::isfinite(column.ramp)) column.ramp = 0;
        try {
            const Exact exact = oracle.bind(resolve(oracle.parameters, given_by(column), "", "oedometer"));
            const double t = random.log_uniform(1e-3, 1e4) * transit;
            const Row root = row_at(exact, 0, t), top = row_at(exact, column.H, t);
            const Row inside = row_at(exact, random.uniform(0, 1) * column.H, t);
            for (const double value : {inside[0], inside[1], inside[2], inside[3], top[0], top[1]})
                REQUIRE(std::isfinite(value));
            if (extreme) {  // identities underflow: nothing but finite values is asked
                ++tally.refused;
                continue;
            }
            const double strain = 2 * (std::abs(column.p0) + column.rho * column.g * column.H) / column.E;
            const double tolerance = 1e-14 * (1 + t / transit) * strain;
            INFO(name_of(column) << " t " << t / transit << " of strain " << strain);
            REQUIRE(std::abs(root[0]) <= tolerance * column.H);
            REQUIRE(std::abs(root[1]) <= tolerance * column.wave_speed());
            REQUIRE(std::abs(top[3] - column.p0 / column.E) <= tolerance);
            const Row mean = mean_over(exact, 0, column.H, t);  // of the strain: the top's displacement
            REQUIRE(std::abs(mean[3] - top[0] / column.H) <= 2 * tolerance);
            ++tally.checked;
        } catch (const InputError&) {
            REQUIRE(extreme);  // only data whose speed or amplitude is no number are refused
            ++tally.refused;
        }
    }
    CHECK(tally.mostly_checked());
}
