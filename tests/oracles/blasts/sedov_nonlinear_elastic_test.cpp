#include "oracles/blasts/sedov_nonlinear_elastic.hpp"

#include <cmath>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "tests/catch.hpp"
#include "tests/oracles/blasts/sedov_nonlinear_elastic_gate.hpp"
#include "tests/oracles/fuzz.hpp"

using namespace ordo;
using namespace ordo::oracles;
using namespace ordo::oracles::gate;
using namespace ordo::oracles::gate::elastic_blast;

namespace {

using Material = ElasticBlast::Material;

/// Default and off-default: each material, k below, at and above 1, odd densities, heats and energies.
std::vector<ElasticBlast> blasts() {
    std::vector<ElasticBlast> list;
    for (const auto material : {Material::A, Material::B, Material::C}) {
        list.push_back({.material = material});
        list.push_back({.E = 3e-3, .rho0 = 2.5, .c_v = 0.3, .k = 0.4, .material = material, .energy = 20});
        list.push_back({.E = 1e4, .rho0 = 1200, .c_v = 9e5, .k = 2.2, .material = material, .energy = 4e9});
    }
    return list;
}

std::string name_of(const ElasticBlast& given) {
    return std::string("material ") + "ABC"[static_cast<int>(given.material)] + ", k = " + std::to_string(given.k);
}

std::string ringing(const ClaimedElasticBlast& blast) {
    std::string names;
    for (const auto& [name, gate] : elastic_gates) {
        if (!gate(blast).holds()) names += name + "; ";
    }
    return names;
}

/// The same blast with another modulus: M^2 grows as E falls, nothing else in the gas changes.
ElasticBlast softer(ElasticBlast given, double m2) {
    const SedovNonlinearElastic solid(given);
    given.E *= solid.strength(1) / m2;
    return given;
}

Given given_of(const ElasticBlast& blast, double m2_min) {
    return {{"E", blast.E},
            {"rho0", blast.rho0},
            {"c_v", blast.c_v},
            {"k", blast.k},
            {"material", std::string(1, "ABC"[static_cast<int>(blast.material)])},
            {"energy", blast.energy},
            {"m2_min", m2_min}};
}

Exact bound(const Given& given) {
    const Oracle oracle = sedov_nonlinear_elastic();
    return oracle.bind(resolve(oracle.parameters, given, "", "oracle sedov_nonlinear_elastic"));
}

}  // namespace

TEST_CASE("sedov_nonlinear_elastic: the law holds, mass and momentum are balanced, the sides mirror", "[gate]") {
    for (const auto& given : blasts()) {
        for (const auto& [name, gate] : elastic_gates) {
            const Defect defect = gate(claim_of(given));
            INFO(name << ": " << name_of(given) << ": defect " << defect.found << ", allowed " << defect.allowed);
            CHECK(defect.holds());
        }
    }
}

TEST_CASE("sedov_nonlinear_elastic: the limit's error is of first order in 1/M^2", "[convergence]") {
    for (const auto& given : blasts()) {
        INFO(name_of(given));
        const auto coarse = limit_errors(claim_of(softer(given, 1e4)), 1);
        const auto fine = limit_errors(claim_of(softer(given, 1e5)), 1);
        for (auto part :
             {&LimitErrors::stretch, &LimitErrors::hugoniot, &LimitErrors::temperature, &LimitErrors::total}) {
            INFO(coarse.*part << " at 1e4, " << fine.*part << " at 1e5");
            // The next order is 1/M^2 times a few tens (k = 0.4: squares of lambda2^-2 = 36) of the first.
            CHECK(std::abs(coarse.*part / (fine.*part) / 10 - 1) <= 0.03);
            CHECK(std::abs(fine.*part) * 1e5 <= 60);
            CHECK(std::abs(fine.*part) * 1e5 >= 1e-2);
        }
    }
}

TEST_CASE("sedov_nonlinear_elastic: the strong-shock relations of material A, k = 1", "[gate]") {
    // M -> infinity: lambda2 = 1/3, u2 = 2U/3, p2 = 2 rho0 U^2 / 3, T2 = rho0 U^2 lambda2^2 2/3 / c_v, alpha of gamma
    // = 2.
    const SedovNonlinearElastic solid({.E = 1e-9, .energy = 0.1831658784 * 0.125});
    const auto front = solid.blast().front(1);
    CHECK(front.r == Approx(0.5).epsilon(1e-10));
    CHECK(front.speed == Approx(1.0 / 3).epsilon(1e-10));
    const auto behind = solid.at(-front.r, 1);
    CHECK(behind.density == Approx(3).epsilon(1e-12));
    CHECK(behind.velocity == Approx(-2.0 / 9).epsilon(1e-10));
    CHECK(behind.pressure == Approx(2.0 / 27).epsilon(1e-10));
    CHECK(behind.temperature == Approx(2.0 / 243).epsilon(1e-7));
    CHECK(behind.strain == Approx(-2.0 / 3).epsilon(1e-12));
    CHECK(solid.blast().integrals().alpha == Approx(0.183165878384863).epsilon(1e-14));
    // M^2 = (4/9) energy / (alpha E R), one side's energy and alpha.
    const SedovNonlinearElastic usual(ElasticBlast{});
    CHECK(usual.strength(1) == Approx(1.0 / 9 / 1e-4).epsilon(1e-8));
}

TEST_CASE("sedov_nonlinear_elastic: the window is M^2 >= m2_min, and is enforced", "[unit]") {
    for (const auto& given : blasts()) {
        for (const double m2_min : {700.0, 1000.0, 5e6}) {
            const Exact exact = bound(given_of(given, m2_min));
            const SedovNonlinearElastic solid(given);
            const double t_max = exact.times.high;
            CHECK(solid.strength(t_max) == Approx(m2_min).epsilon(1e-12));
            CHECK(claim_of(given).strength(t_max) == Approx(m2_min).epsilon(1e-9));
            CHECK_NOTHROW(exact.check({}, t_max, ""));
            CHECK_THROWS_AS(exact.check({}, t_max * (1 + 1e-12), ""), InputError);
            CHECK_THROWS_AS(exact.check({}, 0, ""), InputError);
        }
    }
    const auto message = [](const Given& given) -> std::string {
        try {
            bound(given);
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    };
    CHECK_THAT(message({{"m2_min", 5.0}}), ContainsSubstring("'m2_min'") && ContainsSubstring(">= 10"));
    CHECK_THAT(message({{"m2_min", 20.0}}), ContainsSubstring("nearest: m2_min = 44"));
    CHECK_THAT(message({{"k", 0.05}}), ContainsSubstring("elastic stress behind the shock"));
    CHECK_THAT(message({{"k", 0.0}}), ContainsSubstring("'k'"));
    CHECK_THAT(message({{"k", 1e-17}, {"material", std::string("C")}}), ContainsSubstring("k + 1 must be > 1"));
    CHECK_THAT(message({{"E", 0.0}}), ContainsSubstring("'E'"));
    CHECK_THAT(message({{"material", std::string("D")}}), ContainsSubstring("'material'"));
}

TEST_CASE("sedov_nonlinear_elastic: the gate rings for seeded faults", "[alarm]") {
    for (const auto& given : blasts()) {
        const ClaimedElasticBlast good = claim_of(given);
        INFO(name_of(given));
        CHECK(ringing(good).empty());
        const auto with = [&](auto&& change) {
            ClaimedElasticBlast faulty = good;
            faulty.at = [&good, change](double x, double t) {
                auto state = good.at(x, t);
                if (std::abs(x) < good.shock(t)) change(state, std::abs(x) / good.shock(t));
                return state;
            };
            return ringing(faulty);
        };
        CHECK_THAT(with([](auto& s, double) { s.temperature *= 1 + 1e-6; }), ContainsSubstring("law"));
        CHECK_THAT(with([](auto& s, double) { s.energy *= 1 + 1e-6; }), ContainsSubstring("law"));
        CHECK_THAT(with([](auto& s, double) { s.strain += 1e-6; }), ContainsSubstring("law"));
        CHECK_THAT(with([](auto& s, double) { s.stress = s.pressure; }), ContainsSubstring("law"));
        CHECK_THAT(with([](auto& s, double) { s.velocity *= 1 + 1e-6; }), ContainsSubstring("balance"));
        CHECK_THAT(with([](auto& s, double y) { s.density *= 1 + 1e-6 * y; }), ContainsSubstring("balance"));
        CHECK_THAT(with([](auto& s, double) { s.velocity = std::abs(s.velocity); }), ContainsSubstring("two sides"));
        // The temperature of the gas alone, without C_s': the law sees it at any M^2 of the window.
        CHECK_THAT(with([&](auto& s, double) {
                       const double lambda = given.rho0 / s.density;
                       s.temperature = s.pressure * std::pow(lambda, given.k + 1) / (given.k * given.c_v);
                   }),
                   ContainsSubstring("law"));
        // gamma = k + 1 + 1e-6; both sides' energy.
        ElasticBlast other = given;
        other.k += 1e-6;
        ClaimedElasticBlast neighbour = claim_of(other);
        neighbour.given = given;
        CHECK_THAT(ringing(neighbour), ContainsSubstring("law"));
        ClaimedElasticBlast two_sided = claim_of(softer(given, 1e5));
        two_sided.given.energy *= 2;
        CHECK(std::abs(limit_errors(two_sided, 1).total) > 0.4);
    }
}

TEST_CASE("sedov_nonlinear_elastic: random materials keep the law within the window", "[property]") {
    Random random(31415);
    Tally tally;
    for (int round = 0; round < fuzz_rounds(300); ++round) {
        const ElasticBlast given{.E = random.log_uniform(1e-6, 1e6),
                                 .rho0 = random.log_uniform(1e-3, 1e3),
                                 .c_v = random.log_uniform(1e-3, 1e3),
                                 .k = random.log_uniform(0.03, 20),
                                 .material = static_cast<Material>(random.whole(0, 2)),
                                 .energy = random.log_uniform(1e-6, 1e6)};
        const double m2_min = random.log_uniform(8, 1e6);
        INFO(name_of(given) << ", m2_min = " << m2_min << ", round " << round);
        std::optional<Exact> exact;
        try {
            exact = bound(given_of(given, m2_min));
        } catch (const InputError&) {
            // Below the floor, or the elastic stress at lambda2 is over a tenth of p2 = 2 rho0 U^2 / (k + 2).
            const double lambda2 = given.k / (given.k + 2);
            const double slope =
                (energy_of(given, lambda2 * (1 + 1e-6), 0) - energy_of(given, lambda2 * (1 - 1e-6), 0)) /
                (2e-6 * lambda2);
            REQUIRE((m2_min < 10 || -slope / given.E * (given.k + 2) / 2 > 0.0999 * m2_min));
            ++tally.refused;
            continue;
        }
        const double t = exact->times.high * random.log_uniform(1e-6, 1);
        exact->check({}, t, "");
        const double R = exact->jumps(t).back();
        const double x = R * random.uniform(-1, 1);
        const std::vector<double> at{x, -x, 1.01 * R};
        std::vector<double> rows(21);
        exact->sample(at, t, rows);
        const auto &u = rows[0], &rho = rows[1], &sigma = rows[2], &p = rows[3], &T = rows[4], &e = rows[5];
        REQUIRE((rho >= 0 && p > 0 && sigma == -p && rows[7] == -u));
        if (rho > 1e-200 * given.rho0 && std::isfinite(T)) {
            REQUIRE((T > 0 && e > 0));
            const double lambda = given.rho0 / rho;
            CHECK(std::abs(given.rho0 * e / energy_of(given, lambda, T) - 1) <= 1e-11);
            CHECK(rows[6] == Approx(lambda - 1).epsilon(1e-13).margin(1e-14));
        }
        const auto& away = rows[14];
        CHECK((away == 0 && rows[15] == given.rho0));
        ++tally.checked;
    }
    CHECK(tally.mostly_checked());
    const Exact exact = bound({});
    std::vector<double> centre(7);
    const double zero = 0;
    exact.sample({&zero, 1}, 1, centre);
    CHECK((centre[0] == 0 && centre[1] == 0 && centre[3] > 0));
    CHECK((std::isnan(centre[4]) && std::isnan(centre[5]) && std::isnan(centre[6])));
}
