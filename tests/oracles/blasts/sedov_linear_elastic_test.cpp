#include "oracles/blasts/sedov_linear_elastic.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "tests/catch.hpp"
#include "tests/oracles/fuzz.hpp"

using namespace ordo;
using namespace ordo::oracles;
using namespace ordo::oracles::gate;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
enum : std::size_t { velocity, density, stress, strain, temperature, energy, momentum, total_energy, displacement };
using Row = std::array<double, 9>;

/// A claimed blast: fields at (x, t), means over cells, and the numbers it was claimed for.
struct Blast {
    double L0, lambda_c, E, rho0, T, c_v;
    Exact exact;
    std::function<Row(double x, double t)> at;
    std::function<Row(double a, double b, double t)> mean;

    double c0() const { return std::sqrt(E / rho0); }
};

Blast blast_of(double L0, double lambda_c, double E, double rho0, double T, double c_v) {
    static const Oracle oracle = sedov_linear_elastic();
    const Given given{{"L0", L0}, {"lambda_c", lambda_c}, {"E", E}, {"rho0", rho0}, {"T", T}, {"c_v", c_v}};
    const Exact exact = oracle.bind(resolve(oracle.parameters, given, "", oracle.name));
    return {L0,
            lambda_c,
            E,
            rho0,
            T,
            c_v,
            exact,
            [exact](double x, double t) {
                Row row;
                exact.sample({&x, 1}, t, row);
                return row;
            },
            [exact](double a, double b, double t) {
                Row row;
                const std::array edges{a, b};
                exact.averages(edges, t, row);
                return row;
            }};
}

/// What is wrong, relative; the worst of all statements below at a few times before and after the slug has split.
///   Right half: its momentum is the push of the core's stress E (1 - lambda_c) at the centre until L0 / (2 c0), its
///   energy E0 / 2 (nothing passes the centre, which is at rest), half of it kinetic at late times.
///   Energy above the heat and mass above that of the relaxed line are those of the crushed slug.
///   Fields are mirror images, and nothing has moved ahead of the front, which runs at c0.
double wrong(const Blast& b) {
    const double c0 = b.c0();
    const double E0 = b.E * (1 - b.lambda_c) * (1 - b.lambda_c) * b.L0 / 2;
    const double heat = b.c_v * b.T;  // per reference volume
    double worst = 0;
    const auto say = [&](double difference, double scale) {
        if (!(std::abs(difference) <= worst * scale))
            worst = std::isnan(difference) ? 1e9 : std::abs(difference) / scale;
    };
    for (const double share : {0.0, 0.21, 0.83, 1.0, 1.37, 2.6, 9.0}) {
        const double t = share * b.L0 / (2 * c0);
        const double box = 8 * b.L0;
        const Row right = b.mean(0, box, t);
        const double push = b.E * (1 - b.lambda_c) * std::min(t, b.L0 / (2 * c0));
        // Material that is in [0, box]: the slug's half and what lies outside of it.
        const double length = b.L0 / 2 + (box - b.lambda_c * b.L0 / 2);
        say(right[momentum] * box - push, b.rho0 * c0 * b.L0);
        say(right[density] * box - b.rho0 * length, b.rho0 * box);
        say(right[total_energy] * box - E0 / 2 - heat * length, b.E * b.L0 + heat * box);
        double kinetic = 0;
        const double front = b.lambda_c * b.L0 / 2 + c0 * t;
        for (const double x : {0.01 * front, 0.3 * front, 0.77 * front, 0.999 * front, 1.001 * front, 3 * front}) {
            const Row row = b.at(x, t);
            const Row mirror = b.at(-x, t);
            const double lambda = b.rho0 / row[density];
            say(row[velocity] + mirror[velocity], c0);
            say(row[stress] - mirror[stress], b.E);
            say(row[displacement] + mirror[displacement], b.L0 + c0 * t);
            say(row[stress] - b.E * (lambda - 1), b.E);
            say(row[strain] - (lambda - 1), 1);
            say(row[energy] * b.rho0 - b.E * (lambda - 1) * (lambda - 1) / 2 - heat, b.E + heat);
            say(row[temperature] - b.T, b.T + eps);
            say(row[momentum] - row[density] * row[velocity], row[density] * c0);
            // E v^2 = c0^2 (E strain^2) in a wave that runs one way, sigma = -rho0 c0 v to the right.
            if (x > front) say(std::abs(row[velocity]) + std::abs(row[displacement]), c0 + b.L0);
        }
        if (share > 1) {
            const double middle = c0 * t;  // in the right pulse
            const Row row = b.at(middle, t);
            kinetic = 0.5 * row[density] * row[velocity] * row[velocity] * (front - (c0 * t - b.L0 / 2));
            say(kinetic - E0 / 4, b.E * b.L0);
            say(row[stress] + b.rho0 * c0 * row[velocity], b.E);
            say(b.at(0, t)[velocity], c0);
            say(b.at(0, t)[strain], 1);
        }
        // The displacement is continuous and linear between the slug's rear, its last particle and its front.
        const double v = c0 * (1 - b.lambda_c) / 2;
        const double rear = t < b.L0 / (2 * c0) ? b.lambda_c * (b.L0 / 2 - c0 * t) : c0 * t - b.L0 / 2;
        const double last = b.lambda_c * b.L0 / 2 + v * std::min(t, b.L0 / c0);
        std::vector<double> corners{0, rear, last, front, 1.3 * front};
        std::sort(corners.begin(), corners.end());
        double integral = 0;
        for (std::size_t i = 0; i + 1 < corners.size(); ++i)
            integral += (corners[i + 1] - corners[i]) / 2 *
                        (b.at(corners[i], t)[displacement] + b.at(corners[i + 1], t)[displacement]);
        say(b.mean(0, 1.3 * front, t)[displacement] - integral / (1.3 * front), b.L0 + c0 * t);
    }
    // A particle's displacement is the time integral of its velocity (piecewise constant along it).
    const double t = 0.9 * b.L0 / (2 * c0);
    const double x = b.at(0, t)[displacement] + b.lambda_c * b.L0 / 2 + 0.5 * c0 * t;
    const Row now = b.at(x, t);
    const double X = x - now[displacement];  // where it was at t = 0, outside of the slug
    const double arrival = (X - b.lambda_c * b.L0 / 2) / c0;
    say(now[displacement] - now[velocity] * (t - arrival), b.L0);
    return worst;
}

}  // namespace

TEST_CASE("sedov_linear_elastic: momentum, mass, energy, mirror and law hold", "[gate]") {
    for (const auto& blast : {blast_of(1, 0.1, 1, 1, 0, 1), blast_of(2.3, 0.37, 2.1e11, 7850, 293, 3.6e6),
                              blast_of(0.01, 0.9, 0.02, 13, 0.5, 7), blast_of(1, 1e-6, 1, 1, 0.3, 1)})
        CHECK(wrong(blast) <= 256 * eps);
}

TEST_CASE("sedov_linear_elastic: the slug of length 1 crushed to a tenth, at t = 2", "[published]") {
    const Blast blast = blast_of(1, 0.1, 1, 1, 0.3, 1);
    const auto jumps = blast.exact.jumps(2);
    REQUIRE(jumps.size() == 4);
    CHECK((jumps[2] == Approx(1.5).epsilon(1e-15) && jumps[3] == Approx(2.05).epsilon(1e-15)));
    const Row pulse = blast.at(1.8, 2);
    CHECK(pulse[density] == Approx(1.8181818).epsilon(3e-8));
    CHECK(pulse[velocity] == Approx(0.45).epsilon(1e-15));
    const auto constants = blast.exact.constants(2.0);
    const auto number = [&](const char* name) {
        for (const auto& constant : constants) {
            if (constant.name == name) return std::get<double>(constant.value);
        }
        return std::nan("");
    };
    CHECK(number("E0") == Approx(0.405).epsilon(1e-15));
    CHECK((number("t0") == 0.5 && number("x_front") == 2.05 && number("x_rear") == 1.5));
    CHECK((number("rho_pulse") == pulse[density] && number("v_pulse") == Approx(0.45).epsilon(1e-15)));
    CHECK(std::abs(number("sigma_pulse") - pulse[stress]) <= 2 * eps);
    // The closed form of the fronts before and after the split.
    const SedovLinearElastic closed{.L0 = 2, .lambda_c = 0.3, .E = 4, .rho0 = 1};
    const Exact early = blast_of(2, 0.3, 4, 1, 0, 1).exact;
    for (const double t : {0.1, 0.3, 0.6, 2.0}) {
        const auto places = early.jumps(t);
        REQUIRE(places.size() == 4);
        CHECK(std::abs(places[3] - closed.front(t)) <= 8 * eps * (2 + 2 * t));
        CHECK(std::abs(places[2] - closed.rear(t)) <= 8 * eps * (2 + 2 * t));
    }
}

TEST_CASE("sedov_linear_elastic: the gate rings for seeded faults", "[alarm]") {
    const Blast good = blast_of(2.3, 0.37, 3, 1.7, 0.2, 1.9);
    REQUIRE(wrong(good) <= 256 * eps);
    Blast stiffer = blast_of(2.3, 0.37, 3 * (1 + 1e-6), 1.7, 0.2, 1.9);
    stiffer.E = 3;
    CHECK(wrong(stiffer) > 1e-8);
    Blast longer = blast_of(2.3 * (1 + 1e-6), 0.37, 3, 1.7, 0.2, 1.9);
    longer.L0 = 2.3;
    CHECK(wrong(longer) > 1e-8);
    for (const std::size_t field : {velocity, density, stress, strain, energy, momentum, displacement}) {
        Blast bad = good;
        bad.at = [good, field](double x, double t) {
            Row row = good.at(x, t);
            row[field] *= 1 + 1e-6;
            return row;
        };
        INFO(field);
        CHECK(wrong(bad) > 1e-9);
    }
    for (const std::size_t field : {density, momentum, total_energy, displacement}) {
        Blast bad = good;
        bad.mean = [good, field](double a, double b, double t) {
            Row row = good.mean(a, b, t);
            row[field] *= 1 + 1e-6;
            return row;
        };
        INFO(field);
        CHECK(wrong(bad) > 1e-9);
    }
    Blast inwards = good;
    inwards.at = [good](double x, double t) { return good.at(-x, t); };
    CHECK(wrong(inwards) > 1e-3);
    Blast broken = good;
    broken.at = [good](double x, double t) {
        Row row = good.at(x, t);
        row[stress] = std::nan("");
        return row;
    };
    CHECK(wrong(broken) > 1);
}

TEST_CASE("sedov_linear_elastic: what is no slug is refused", "[unit]") {
    CHECK_THROWS_WITH(blast_of(1, 0, 1, 1, 0, 1), ContainsSubstring("lambda_c"));
    CHECK_THROWS_WITH(blast_of(1, 1.1, 1, 1, 0, 1), ContainsSubstring("lambda_c"));
    CHECK_THROWS_AS(blast_of(0, 0.5, 1, 1, 0, 1), InputError);
    CHECK_THROWS_AS(blast_of(1, 0.5, 1, 1, -1, 1), InputError);
    CHECK_THROWS_AS(blast_of(1e300, 0.5, 1e300, 1, 0, 1), InputError);
    const Blast nothing = blast_of(1, 1, 1, 1, 0, 1);
    CHECK((nothing.exact.jumps(0.7).empty() && nothing.at(0.3, 0.7)[velocity] == 0));
}

TEST_CASE("sedov_linear_elastic: fuzz", "[property]") {
    Random random(47);
    Tally tally;
    for (int i = 0; i < fuzz_rounds(2000); ++i) {
        const double L0 = random.log_uniform(1e-6, 1e6);
        const double E = random.log_uniform(1e-6, 1e12);
        const double rho0 = random.log_uniform(1e-4, 1e5);
        const double T = random.whole(0, 3) == 0 ? 0 : random.log_uniform(1e-3, 1e4);
        const Blast b = blast_of(L0, random.log_uniform(1e-9, 1), E, rho0, T, random.log_uniform(1e-3, 1e8));
        const double t = random.log_uniform(1e-6, 1e6) * L0 / b.c0();
        const double reach = b.lambda_c * L0 / 2 + b.c0() * t;
        for (int n = 0; n < 8; ++n) {
            const double x = random.uniform(-1.2, 1.2) * reach;
            const Row row = b.at(x, t);
            for (const double value : row) REQUIRE(std::isfinite(value));
            if (std::abs(x) > reach * (1 + 8 * eps)) REQUIRE((row[velocity] == 0 && row[strain] == 0));
            // Everywhere the state is the slug's, the relaxed one's, or one wave's: |sigma| = 0, E (1 - lambda_c), or
            // rho0 c0 |v|.
            const double wave = std::abs(std::abs(row[stress]) - rho0 * b.c0() * std::abs(row[velocity]));
            const double core = std::abs(row[stress] + E * (1 - b.lambda_c));
            REQUIRE(std::min(wave, core) <= 8 * eps * E);
        }
        ++tally.checked;
    }
    CHECK(tally.mostly_checked());
}
