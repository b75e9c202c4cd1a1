#include <cmath>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "tests/catch.hpp"
#include "tests/oracles/fuzz.hpp"
#include "tests/oracles/plasticity/j2_gate.hpp"

using namespace ordo;
using namespace ordo::oracles;
using namespace ordo::oracles::gate;
using namespace ordo::oracles::gate::plasticity;

namespace {

constexpr auto monotonic = StrainPath::Kind::monotonic;
constexpr auto cycle = StrainPath::Kind::cycle;

/// Perfect and hardening, also so hard that cycling ends elastic; one way, to and fro, first into compression; a peak
/// below yield, and one far beyond.
std::vector<History> histories() {
    std::vector<History> list;
    for (const double H_by_G : {0.0, 1e-9, 0.02, 0.7, 3.0, 5.0}) {
        for (const auto& path : {StrainPath{cycle, 1, 0.01}, StrainPath{cycle, -3, 0.004}, StrainPath{cycle, 1e-3, 0.2},
                                 StrainPath{cycle, 2, 1e-3}, StrainPath{monotonic, -0.7, 0.01}}) {
            const J2UniaxialStrain steel{.H = H_by_G * J2UniaxialStrain{}.G, .path = path};
            list.push_back(history_of(steel));
            list.push_back(
                history_of(J2UniaxialStrain{.K = 3, .G = 0.8, .Y0 = 0.006, .H = H_by_G * 0.8, .path = path}));
            list.push_back(history_of(J2SimpleShear{.H = steel.H, .path = path}));
        }
    }
    return list;
}

std::string name_of(const History& history) {
    const auto& [K, G, Y0, H] = history.metal;
    return "G " + std::to_string(G) + ", H/G " + std::to_string(H / G) + ", rate " + std::to_string(history.path.rate) +
           ", peak " + std::to_string(history.path.peak);
}

}  // namespace

TEST_CASE("j2: strain path, integration of the flow rule, consistency and energy balance hold", "[gate]") {
    for (const auto& history : histories()) {
        for (const auto& [name, gate] : gates) {
            const Defect defect = gate(history);
            INFO(name << ": " << name_of(history) << ": defect " << defect.found << ", allowed " << defect.allowed);
            CHECK(defect.holds());
        }
    }
}

// Two steps a leg. Peaks and rates are powers of two, so that the steps end at the reversals to the last bit: what a
// step misses of a peak would be missed on every leg. The integrator's sum p loses half an ulp a step, always the same
// way.
TEST_CASE("j2: a thousand reversals", "[gate]") {
    for (const double H_by_G : {0.0, 1e-12, 1e-4, 0.02, 2.9, 3.0, 3.1}) {
        const double H = H_by_G * J2UniaxialStrain{}.G;
        for (const auto& history : {history_of(J2UniaxialStrain{.H = H, .path = {cycle, -1, 0x1p-7}}),
                                    history_of(J2SimpleShear{.H = H, .path = {cycle, 2, 0x1p-6}})}) {
            Point point;
            Claimed before = history.at(0);
            Defect defect;
            for (int n = 1; n <= 1000; ++n) {
                const double t = history.time_of(n + 0.17);  // within the leg after the n-th reversal
                for (const double time : {history.time_of(n), t}) {
                    const Claimed now = history.at(time);
                    point = backward_euler(history.metal, point, combined(1, now.strain, -1, before.strain));
                    before = now;
                }
                const Tensor off = combined(1, before.stress, -1, point.stress);
                const double slack = 4 * history.accuracy(t) + n * eps * 3 * history.metal.G * point.p;
                defect.add(3 * history.metal.G * (before.p - point.p), slack, history.metal.Y0);
                defect.add(std::sqrt(inner(off, off)), slack, history.metal.Y0);
            }
            INFO(name_of(history) << ": defect " << defect.found << ", allowed " << defect.allowed);
            CHECK(defect.holds());
        }
    }
}

TEST_CASE("j2: printed relations of uniaxial strain in perfect plasticity, read off the answers", "[published]") {
    const J2UniaxialStrain solid{.path = {cycle, 1, 0.01}};
    const auto& [K, G, Y0, H, path] = solid;
    const auto stress = [&](double t) { return solid.at(t).stress; };
    const double tiny = 1e-9 * K * path.peak / 1e-3;  // round-off 8 eps (Y0 + M s), over a span of 1e-3
    // t is the strain up to the peak.
    CHECK((stress(0.0025) - stress(0.0015)) / 1e-3 == Approx(K + 4 * G / 3).margin(tiny));
    CHECK((stress(0.0095) - stress(0.0085)) / 1e-3 == Approx(K).margin(tiny));
    CHECK(stress(0.008) - K * 0.008 == Approx(2 * Y0 / 3).epsilon(1e-13));
    CHECK(solid.at(Y0 / (2 * G) * (1 - 1e-12)).plastic_strain == 0);
    CHECK(solid.at(Y0 / (2 * G) * (1 + 1e-12)).plastic_strain > 0);
    // Down from the peak at t = 0.01: elastic over q / G, then K eps - 2 q / 3.
    const double onset = 0.01 + Y0 / G;
    CHECK((stress(0.012) - stress(0.011)) / 1e-3 == Approx(-(K + 4 * G / 3)).margin(tiny));
    CHECK(solid.at(onset - 1e-12).plastic_strain == solid.at(0.01).plastic_strain);
    CHECK(solid.at(onset + 1e-12).plastic_strain > solid.at(0.01).plastic_strain);
    CHECK(stress(0.018) == Approx(K * solid.at(0.018).strain - 2 * Y0 / 3).epsilon(1e-13));
    CHECK(solid.plastic_slope() == K);
    CHECK(solid.elastic_slope() == Approx(K + 4 * G / 3));
}

TEST_CASE("j2: printed relations of simple shear, read off the answers", "[published]") {
    const J2SimpleShear solid{.H = 5e9, .path = {cycle, 1, 0.02}};
    const auto& [G, Y0, H, path] = solid;
    const double gamma_y = Y0 / (std::sqrt(3.0) * G);
    CHECK(solid.at(gamma_y * (1 - 1e-12)).plastic_strain == 0);
    CHECK(solid.at(gamma_y * (1 + 1e-12)).plastic_strain > 0);
    const auto peak = solid.at(0.02);
    const double onset = 0.02 + 2 * peak.stress / G;  // reverse yield
    CHECK(solid.at(onset - 1e-12).plastic_strain == peak.plastic_strain);
    CHECK(solid.at(onset + 1e-12).plastic_strain > peak.plastic_strain);
    CHECK(solid.at(onset).stress == Approx(-peak.stress).epsilon(1e-13));
    CHECK((solid.at(0.019).stress - solid.at(0.017).stress) / 2e-3 == Approx(solid.plastic_slope()).epsilon(1e-10));
}

TEST_CASE("j2: every leg past the second is elastic where H >= 3 G", "[gate]") {
    const J2UniaxialStrain solid{.H = 4 * J2UniaxialStrain{}.G, .path = {cycle, -1, 0.01}};
    CHECK(solid.at(0.01).plastic_strain < solid.at(0.03).plastic_strain);
    for (const double t : {0.031, 0.04, 0.05, 0.0613, 7.77}) {
        CHECK(solid.at(t).plastic_strain == solid.at(0.03).plastic_strain);
        CHECK(solid.at(t).stress == Approx(solid.at(t + 0.04).stress).epsilon(1e-10));
    }
}

TEST_CASE("j2: the declarations bind the same numbers to the same bits", "[unit]") {
    const Given given{{"K", 7e10},    {"G", 2.6e10},  {"Y0", 3e8},      {"H", 2e9},
                      {"rate", -0.3}, {"peak", 0.02}, {"path", "cycle"}};
    const StrainPath path{cycle, -0.3, 0.02};
    const J2UniaxialStrain strained{7e10, 2.6e10, 3e8, 2e9, path};
    const J2SimpleShear sheared{2.6e10, 3e8, 2e9, path};
    const Oracle uniaxial = j2_uniaxial_strain(), shear = j2_simple_shear();
    const Exact first = uniaxial.bind(resolve(uniaxial.parameters, given, "", "x"));
    const Exact second = shear.bind(resolve(shear.parameters, given, "", "x"));
    REQUIRE((first.width() == 8 && second.width() == 7));
    for (const double t : {0.0, 0.01, 0.1, 0.21, 3.0}) {
        std::vector<double> row(8), other(7);
        first.sample(std::array{-3.0}, t, row);
        second.sample(std::array{1e9}, t, other);
        const auto a = strained.at(t);
        CHECK(row == std::vector{a.strain, a.stress, a.lateral_stress, a.plastic_strain, a.yield_stress,
                                 a.equivalent_stress, a.plastic_work, a.elastic_energy});
        const auto b = sheared.at(t);
        CHECK(other == std::vector{b.strain, b.stress, b.plastic_strain, b.yield_stress, b.equivalent_stress,
                                   b.plastic_work, b.elastic_energy});
    }
    CHECK((first.jumps(1).empty() && !first.times.contains(1e17) && first.times.contains(1e10)));
    CHECK(std::get<double>(first.constants({}).back().value) == strained.plastic_slope());
    CHECK(std::get<double>(second.constants({}).back().value) == sheared.plastic_slope());
    CHECK_THROWS_AS(uniaxial.bind(resolve(uniaxial.parameters, {{"E", 1.0}, {"nu", 0.5}}, "", "x")), InputError);
    CHECK_THROWS_AS(shear.bind(resolve(shear.parameters, {{"H", -1.0}}, "", "x")), InputError);
    CHECK_THROWS_AS(shear.bind(resolve(shear.parameters, {{"Y0", 0.0}}, "", "x")), InputError);
}

// From the answer at one time, one step of backward Euler on the same leg must lead to the answer at a later one.
// Refused is a pair of elastic constants that no solid has.
TEST_CASE("j2: random solids follow the flow rule between any two times of a leg", "[property]") {
    Random random(11);
    Tally tally;
    const std::array oracles{j2_uniaxial_strain(), j2_simple_shear()};
    for (int round = 0; round < fuzz_rounds(4000); ++round) {
        const bool shear = random.coin();
        const double E = random.log_uniform(1e-3, 1e12), nu = random.uniform(-1.1, 0.55);
        const double Y0 = E * random.log_uniform(1e-5, 1), peak = random.log_uniform(1e-5, 1);
        const double rate = random.log_uniform(1e-6, 1e6) * (random.coin() ? 1 : -1);
        const bool wave = random.coin();
        const Given given{{"E", E},
                          {"nu", nu},
                          {"Y0", Y0},
                          {"H", random.coin() ? 0 : E * random.log_uniform(1e-12, 10)},
                          {"rate", rate},
                          {"peak", peak},
                          {"path", wave ? "cycle" : "monotonic"}};
        const Oracle& oracle = oracles[shear ? 1 : 0];
        Exact exact;
        try {
            exact = oracle.bind(resolve(oracle.parameters, given, "", "x"));
        } catch (const InputError&) {
            if (nu > -1 && nu < 0.5) FAIL("refused: nu = " << nu);
            ++tally.refused;
            continue;
        }
        const double G = E / (2 * (1 + nu)), K = E / (3 * (1 - 2 * nu));
        const Metal metal{K, G, Y0, std::get<double>(given.at("H"))};
        const double reversals = std::floor(random.log_uniform(1, 1e5)) - 1;
        const double start = wave && reversals > 0 ? (2 * reversals - 1) * peak / std::abs(rate) : 0;
        const double length = (start > 0 ? 2 : 1) * peak / std::abs(rate);
        const double from = start + length * random.uniform(0.01, 0.5), to = start + length * random.uniform(0.5, 0.99);
        const auto point = [&](double t) {
            std::array<double, 8> row{};
            const std::size_t width = exact.width();
            exact.sample(std::array{0.0}, t, std::span(row).first(width));
            const double strain = row[0], stress = row[1], side = shear ? 0 : row[2], p = row[shear ? 2 : 3];
            return shear ? Claimed{strain, {0, strain / 2, 0, strain / 2}, {0, stress, 0, stress}, p, row[3], row[4], 0,
                                   0}
                         : Claimed{strain, {strain}, {stress, 0, 0, 0, side, 0, 0, 0, side}, p, row[4], row[5], 0, 0};
        };
        const auto [a, b] = std::pair{point(from), point(to)};
        const Point stepped = backward_euler(metal, {a.stress, a.p}, combined(1, b.strain, -1, a.strain));
        const Tensor off = combined(1, b.stress, -1, stepped.stress);
        const double slack = 64 * eps * (Y0 + (K + 4 * G / 3) * std::abs(rate) * to);
        const bool good = std::sqrt(inner(off, off)) <= slack && std::abs(b.p - stepped.p) * 3 * G <= slack &&
                          b.q <= b.Y + slack && b.p >= a.p - slack / (3 * G);
        if (!good)
            FAIL("round " << round << (shear ? " shear" : " uniaxial") << ", nu = " << nu << ", E = " << E
                          << ", Y0/E = " << Y0 / E << ", H/E = " << metal.H / E << ", peak = " << peak << ", reversals "
                          << reversals << ", off " << std::sqrt(inner(off, off)) / slack << ", p " << a.p << ", " << b.p
                          << ", " << stepped.p);
        ++tally.checked;
    }
    CHECK(tally.mostly_checked());
}

TEST_CASE("j2: the gate rings for seeded faults", "[alarm]") {
    for (const History& good : {history_of(J2UniaxialStrain{.H = 3e9, .path = {cycle, 1, 0.01}}),
                                history_of(J2SimpleShear{.H = 3e9, .path = {cycle, -1, 0.02}})}) {
        CHECK(ringing(good).empty());
        const auto with = [&](auto change) {
            History history = good;
            history.at = [good, change](double t) {
                Claimed now = good.at(t);
                change(now, t);
                return now;
            };
            return history;
        };
        const auto& metal = good.metal;
        const auto plastic = [&](const Claimed& now) { return now.p > 0; };
        // Stress, plastic strain, yield stress and strain one part in a million off.
        CHECK_THAT(ringing(with([](Claimed& now, double) { now.stress = combined(1 + 1e-6, now.stress, 0, {}); })),
                   ContainsSubstring("integration") && ContainsSubstring("energy"));
        CHECK_THAT(ringing(with([](Claimed& now, double) { now.p *= 1 + 1e-6; })), ContainsSubstring("integration"));
        CHECK_THAT(ringing(with([](Claimed& now, double) { now.Y *= 1 + 1e-6; })), ContainsSubstring("consistency"));
        CHECK_THAT(ringing(with([](Claimed& now, double) { now.driven *= 1 + 1e-6; })),
                   ContainsSubstring("strain path"));
        CHECK_THAT(ringing(with([](Claimed& now, double) { now.plastic_work *= 1 + 1e-6; })),
                   ContainsSubstring("energy"));
        // Deviator of the wrong sign in the plastic range; hardening that forgets what was accumulated before the leg.
        CHECK_THAT(ringing(with([&](Claimed& now, double) {
                       if (plastic(now)) now.stress = combined(1, now.stress, -2, deviator(now.stress));
                   })),
                   ContainsSubstring("integration") && ContainsSubstring("energy"));
        CHECK_THAT(ringing(with([&](Claimed& now, double t) {
                       if (t > good.time_of(1)) now.p -= good.at(good.time_of(1)).p;
                   })),
                   ContainsSubstring("integration") && ContainsSubstring("consistency"));
        // The answer to another hardening, modulus and yield stress; kinks of the path at the wrong place; NaN.
        const auto other = [&](double G, double Y0, double H, double peak) {
            History history = trace(good.at(0.001).stress) == 0
                                  ? history_of(J2SimpleShear{G, Y0, H, {cycle, good.path.rate, peak}})
                                  : history_of(J2UniaxialStrain{metal.K, G, Y0, H, {cycle, good.path.rate, peak}});
            history.metal = metal;
            history.path = good.path;
            return history;
        };
        const double off = 1 + 1e-6, peak = good.path.peak;
        CHECK(ringing(other(metal.G, metal.Y0, metal.H, peak)).empty());
        CHECK_THAT(ringing(other(metal.G * off, metal.Y0, metal.H, peak)), ContainsSubstring("integration"));
        CHECK_THAT(ringing(other(metal.G, metal.Y0 * off, metal.H, peak)), ContainsSubstring("integration"));
        CHECK_THAT(ringing(other(metal.G, metal.Y0, metal.H * off, peak)), ContainsSubstring("integration"));
        CHECK_THAT(ringing(other(metal.G, metal.Y0, metal.H, peak * off)), ContainsSubstring("strain path"));
        CHECK_THAT(ringing(with([](Claimed& now, double) { now.stress[0] = std::nan(""); })),
                   ContainsSubstring("integration") && ContainsSubstring("consistency"));
    }
}
