#include "core/elastic_constants.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "tests/catch.hpp"
#include "tests/oracles/fuzz.hpp"

using namespace ordo;
using oracles::gate::Random;

namespace {

constexpr double ulp = std::numeric_limits<double>::epsilon();
constexpr std::array all_six{Elastic::E, Elastic::nu, Elastic::K, Elastic::G, Elastic::lambda, Elastic::M};

double get(const ElasticConstants& c, Elastic which) {
    return std::array{c.E, c.nu, c.K, c.G, c.lambda, c.M}[static_cast<std::size_t>(which)];
}

using Pair = std::array<Elastic, 2>;
std::vector<Pair> all_pairs() {
    std::vector<Pair> pairs;
    for (const auto a : all_six) {
        for (const auto b : all_six) {
            if (a < b) pairs.push_back({a, b});
        }
    }
    return pairs;
}

/// From two entries of `c`, the larger name first: the order must not matter.
ElasticConstants by(const Pair& pair, const ElasticConstants& c) {
    return elastic_constants({pair[1], get(c, pair[1])}, {pair[0], get(c, pair[0])}, "");
}

/// d ln y / d nu at constant E.
double growth(Elastic y, double nu) {
    const double G = -1 / (1 + nu), K = 2 / (1 - 2 * nu);
    switch (y) {
        case Elastic::G: return G;
        case Elastic::K: return K;
        case Elastic::lambda: return 1 / nu + G + K;
        case Elastic::M: return G + K - 1 / (1 - nu);
        case Elastic::E:
        case Elastic::nu: break;
    }
    return 0;
}

/// The stated condition of y from the pair: by how much relative errors of the two grow.
double condition(Elastic y, const Pair& pair, double nu) {
    const auto [a, b] = pair;
    if (a == Elastic::nu || b == Elastic::nu) {
        const Elastic modulus = a == Elastic::nu ? b : a;
        return y == Elastic::nu ? 1 : 1 + std::abs(nu * (growth(y, nu) - growth(modulus, nu)));
    }
    const double parting = std::abs(growth(a, nu) - growth(b, nu));
    if (y == Elastic::nu) return 2 / (parting * std::abs(nu));
    return (std::abs(growth(y, nu) - growth(b, nu)) + std::abs(growth(y, nu) - growth(a, nu))) / parting;
}

/// A solid whose nu is at every distance, down to 1e-7, from 0, -1 and 0.5.
ElasticConstants random_solid(Random& random, bool auxetic) {
    const double near = random.log_uniform(1e-7, 0.25);
    const double nu = auxetic ? (random.coin() ? -near : -1 + near) : (random.coin() ? near : 0.5 - near);
    return elastic_constants({Elastic::E, random.log_uniform(1e-12, 1e12)}, {Elastic::nu, nu}, "");
}

/// E and M know the solid with nu >= 0 only.
bool can_tell(const Pair& pair, const ElasticConstants& c) { return pair != Pair{Elastic::E, Elastic::M} || c.nu >= 0; }

/// Largest error of `found` in units of what is stated for a result whose two givens were `given_error` wrong [ulp].
double excess(const ElasticConstants& found, const ElasticConstants& truth, const Pair& pair, double given_error) {
    double most = 0;
    for (const auto y : all_six) {
        const double stated = (4 + given_error * condition(y, pair, truth.nu)) * ulp * std::abs(get(truth, y));
        most = std::max(most, std::abs(get(found, y) - get(truth, y)) / stated);
    }
    return most;
}

std::string refusal(KnownElastic a, KnownElastic b) {
    try {
        elastic_constants(a, b, "scene");
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

Values given(const Given& values) { return resolve(elastic_parameters("E 7, nu 0.25"), values, "", "a scene"); }

}  // namespace

TEST_CASE("elastic constants: they are what Hooke's law says of them", "[unit]") {
    const double E = 200, nu = 0.3;
    for (const auto& pair : all_pairs()) {
        const auto c = by(pair, elastic_constants({Elastic::E, E}, {Elastic::nu, nu}, ""));
        const auto stress = [&](double along, double across, double across_too, double what) {
            return c.lambda * (along + across + across_too) + 2 * c.G * what;
        };
        CHECK(stress(1, -c.nu, -c.nu, 1) == Approx(E).epsilon(1e-14));  // a bar pulled: sigma = E eps
        CHECK(std::abs(stress(1, -c.nu, -c.nu, -c.nu)) < 1e-14 * E);    // and free at its sides
        CHECK(stress(1, 0, 0, 1) == Approx(c.M).epsilon(1e-14));        // sides held: sigma = M eps
        CHECK(stress(1, 1, 1, 1) == Approx(3 * c.K).epsilon(1e-14));    // pressure = -K volume strain
        CHECK(c.G == Approx(E / 2.6).epsilon(1e-14));                   // steel's textbook ratio
        CHECK((c.nu == Approx(nu).epsilon(1e-14) && c.E == Approx(E).epsilon(1e-14)));
    }
}

TEST_CASE("elastic constants: every pair to every pair and back, within the stated accuracy", "[property]") {
    Random random(20261122);
    const auto pairs = all_pairs();
    double there = 0, and_back = 0;
    for (int round = 0; round < oracles::gate::fuzz_rounds(200); ++round) {
        const auto solid = random_solid(random, random.coin());
        for (const auto& from : pairs) {
            if (!can_tell(from, solid)) continue;
            // `solid` is itself rounded: 4 ulp (1 + condition) of (E, nu), in each of the two givens.
            double rounding = 0;
            for (const auto y : from)
                rounding = std::max(rounding, 4 * (1 + condition(y, {Elastic::E, Elastic::nu}, solid.nu)));
            const auto all = by(from, solid);
            there = std::max(there, excess(all, solid, from, 4 + rounding));
            for (const auto& to : pairs) {
                if (!can_tell(to, solid)) continue;
                double error = 0;
                for (const auto y : to) error = std::max(error, 4 * (1 + condition(y, from, solid.nu)));
                and_back = std::max(and_back, excess(by(to, all), all, to, 4 + error));
            }
        }
    }
    CHECK(there <= 1);
    CHECK(and_back <= 1);
}

TEST_CASE("elastic constants: what was given comes back to the bit", "[unit]") {
    Random random(7);
    for (int round = 0; round < 50; ++round) {
        const auto solid = random_solid(random, false);
        for (const auto& pair : all_pairs()) {
            const auto all = by(pair, solid);
            CHECK((get(all, pair[0]) == get(solid, pair[0]) && get(all, pair[1]) == get(solid, pair[1])));
        }
    }
}

TEST_CASE("elastic constants: E and M take the solid that does not widen when pulled", "[unit]") {
    const auto auxetic = elastic_constants({Elastic::E, 3}, {Elastic::nu, -0.4}, "");
    const auto other = elastic_constants({Elastic::E, auxetic.E}, {Elastic::M, auxetic.M}, "");
    CHECK((other.nu > 0 && other.nu < 0.5));
    CHECK(elastic_constants({Elastic::E, other.E}, {Elastic::nu, other.nu}, "").M == Approx(auxetic.M).epsilon(1e-13));
    CHECK(elastic_constants({Elastic::E, 2}, {Elastic::M, 2}, "").nu == 0);
}

TEST_CASE("elastic constants: what no stable solid has, or what leaves it open, is refused in one line", "[unit]") {
    CHECK(refusal({Elastic::E, 9}, {Elastic::K, 1}) ==
          "scene: no stable solid (K > 0, G > 0) has E = 9 and K = 1; must be 0 < E < 9 K");
    CHECK_THAT(refusal({Elastic::lambda, 0}, {Elastic::nu, 0}), ContainsSubstring("leaves E open"));
    CHECK_THAT(refusal({Elastic::lambda, -1}, {Elastic::nu, 0.2}), ContainsSubstring("of the sign of nu"));
    CHECK_THAT(refusal({Elastic::lambda, 1}, {Elastic::lambda, 2}), ContainsSubstring("are the same constant"));
    const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
    const std::vector<std::array<KnownElastic, 2>> impossible{{{{Elastic::E, 1}, {Elastic::nu, 0.5}}},
                                                              {{{Elastic::E, 1}, {Elastic::nu, -1}}},
                                                              {{{Elastic::E, 0}, {Elastic::nu, 0.3}}},
                                                              {{{Elastic::E, 3}, {Elastic::G, 1}}},
                                                              {{{Elastic::E, 1.01}, {Elastic::M, 1}}},
                                                              {{{Elastic::E, -1}, {Elastic::lambda, 1}}},
                                                              {{{Elastic::K, 1}, {Elastic::lambda, 1}}},
                                                              {{{Elastic::K, -1}, {Elastic::lambda, -2}}},
                                                              {{{Elastic::K, 1}, {Elastic::M, 1}}},
                                                              {{{Elastic::K, 1}, {Elastic::G, 0}}},
                                                              {{{Elastic::nu, 0.6}, {Elastic::K, 1}}},
                                                              {{{Elastic::nu, 0.3}, {Elastic::G, -1}}},
                                                              {{{Elastic::nu, -2}, {Elastic::lambda, -1}}},
                                                              {{{Elastic::nu, 0.5}, {Elastic::M, 1}}},
                                                              {{{Elastic::G, 3}, {Elastic::lambda, -2}}},
                                                              {{{Elastic::G, 3}, {Elastic::M, 4}}},
                                                              {{{Elastic::lambda, 1}, {Elastic::M, 1}}},
                                                              {{{Elastic::lambda, -1}, {Elastic::M, 2}}},
                                                              {{{Elastic::E, nan}, {Elastic::nu, 0.3}}},
                                                              {{{Elastic::K, 1}, {Elastic::lambda, -inf}}},
                                                              {{{Elastic::E, 1e308}, {Elastic::nu, 0.499999}}}};
    for (const auto& [a, b] : impossible) {
        const std::string message = refusal(a, b);
        INFO(message);
        CHECK((message.starts_with("scene: ") && message.find('\n') == std::string::npos));
    }
}

TEST_CASE("elastic constants: a scene takes none or exactly two", "[unit]") {
    const auto fallback = elastic_constants({Elastic::E, 7}, {Elastic::nu, 0.25}, "");
    CHECK(elastic_constants(given({}), fallback, "").E == 7);
    CHECK(elastic_constants(given({{"K", 2.0}, {"G", 1.0}}), fallback, "").M == Approx(10.0 / 3));
    CHECK_THROWS_WITH(elastic_constants(given({{"nu", 0.3}}), fallback, "bar"),
                      "bar: only nu = 0.3 is given, but an isotropic solid has exactly two of E, nu, K, G, lambda, M");
    CHECK_THROWS_WITH(elastic_constants(given({{"M", 3.0}, {"G", 1.0}, {"K", 2.0}}), fallback, "bar"),
                      ContainsSubstring("K = 2, G = 1, M = 3 are given"));
    CHECK_THROWS_WITH(given({{"G", -1.0}}), ContainsSubstring("'G' is -1, but must be > 0"));
}

TEST_CASE("elastic constants: a bar that needs E alone takes E alone, or any two", "[unit]") {
    CHECK(youngs_modulus(given({}), 5, "") == 5);
    CHECK(youngs_modulus(given({{"E", 4.0}}), 5, "") == 4);
    CHECK(youngs_modulus(given({{"nu", 0.25}, {"G", 2.0}}), 9, "") == 5);
    CHECK_THROWS_WITH(youngs_modulus(given({{"G", 2.0}}), 9, ""), ContainsSubstring("only G = 2 is given"));
    CHECK_THROWS_AS(youngs_modulus(given({{"E", 9.0}, {"K", 1.0}}), 9, ""), InputError);
    CHECK_THROWS_AS(youngs_modulus(given({{"E", 9.0}, {"K", 4.0}, {"nu", 0.2}}), 9, ""), InputError);
}

TEST_CASE("elastic constants: an error of 1e-9 in any of the fifteen forms is seen", "[alarm]") {
    const auto solid = elastic_constants({Elastic::E, 200}, {Elastic::nu, 0.3}, "");
    for (const auto& pair : all_pairs()) {
        auto wrong = by(pair, solid);
        CHECK(excess(wrong, solid, pair, 40) <= 1);
        wrong.K *= 1 + 1e-9;
        CHECK(excess(wrong, solid, pair, 40) > 1);
    }
}
