// The second route to the star state and to points in fans: the textbook's formulas in 50 digits.
#include <boost/math/quadrature/gauss.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <string>

#include "oracles/riemann/riemann_nonlinear_elastic.hpp"
#include "tests/catch.hpp"
#include "tests/oracles/riemann/elastic_gate.hpp"
#include "tests/oracles/riemann/nonlinear_elastic_data.hpp"

using namespace ordo;
using namespace ordo::oracles;
using namespace ordo::oracles::gate;
using namespace ordo::oracles::gate::elastic;

namespace {

using Real = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;

/// ElasticLaw again, in 50 digits.
struct Law {
    char material;
    Real E, rho0, c_v, k;

    Real C(const Real& l, const Real& T) const {
        const Real heat = c_v * pow(l, -k) * T;
        if (material == 'A') return E / 3 * (l * l / 2 + 1 / l - Real(3) / 2) + heat;
        if (material == 'B') return E / 2 * (l * l / 2 - log(l) - Real(1) / 2) + heat;
        return E * (l * log(l) - l + 1) + heat;
    }
    Real p(const Real& l, const Real& T) const {
        const Real heat = k * c_v * pow(l, -k - 1) * T;
        if (material == 'A') return heat - E / 3 * (l - 1 / (l * l));
        if (material == 'B') return heat - E / 2 * (l - 1 / l);
        return heat - E * log(l);
    }
    Real a(const Real& l, const Real& T) const {
        const Real heat = k * (k + 1) * c_v * pow(l, -k - 2) * T;
        if (material == 'A') return l * sqrt((E / 3 * (1 + 2 / (l * l * l)) + heat) / rho0);
        if (material == 'B') return l * sqrt((E / 2 * (1 + 1 / (l * l)) + heat) / rho0);
        return l * sqrt((E / l + heat) / rho0);
    }
    /// From the Hugoniot relation, linear in T.
    Real T_shocked(const Real& l, const Real& lK, const Real& TK) const {
        const Real cold = C(l, 0);
        const Real mean_cold = (p(l, 0) + p(lK, TK)) / 2;
        const Real per_T = c_v * pow(l, -k) * (1 + k * (l - lK) / (2 * l));
        return (C(lK, TK) - cold - mean_cold * (l - lK)) / per_T;
    }
    Real integral(const Real& from, const Real& to, const Real& T) const {  // of a d ln lambda
        constexpr int panels = 6;
        const Real width = log(to / from) / panels;
        Real sum = 0;
        for (int i = 0; i < panels; ++i) {
            const auto f = [&](const Real& h) { return a(from * exp(h), T); };
            sum += boost::math::quadrature::gauss<Real, 30>::integrate(f, Real(i * width), Real((i + 1) * width));
        }
        return sum;
    }
};

/// The root near a good first guess, by secants.
template <class F>
Real secant(F&& f, Real x, const Real& nearby) {
    Real y = nearby;
    Real fx = f(x);
    Real fy = f(y);
    for (int i = 0; i < 12 && fx != fy && abs(x - y) > abs(x) * Real("1e-40"); ++i) {
        const Real next = x - fx * (x - y) / (fx - fy);
        y = x;
        fy = fx;
        x = next;
        fx = f(x);
    }
    return x;
}

struct Side {
    Law law;
    Real lambda, T;
    Real guess;  ///< of lambda*

    struct Star {
        Real lambda, T, push;
    };
    Star at(const Real& p) const {
        const Real p_K = law.p(lambda, T);
        const bool shock = p > p_K;
        const auto T_of = [&](const Real& l) { return shock ? law.T_shocked(l, lambda, T) : T; };
        const Real l = secant([&](const Real& trial) { return law.p(trial, T_of(trial)) - p; }, guess,
                              guess * (1 + Real("1e-13")));
        const Real push = shock ? Real(sqrt((p - p_K) * (lambda - l) / law.rho0)) : Real(-law.integral(lambda, l, T));
        return {l, T_of(l), push};
    }
};

const std::vector<Data> cases{
    {{'A', 1, 1, 1, 1}, {0.5, 0, 1}, {1, 0, 0.2}},                       // fan, shock
    {{'B', 2.7, 0.4, 1.9, 0.3}, {1, -0.4, 0.5}, {1.1, 0.4, 0.2}},        // two fans
    {{'C', 1, 1, 1, 1.7}, {0.8, 0.3, 0.4}, {1.25, -0.1, 0.9}},           // two shocks
    {{'A', 2.1e11, 7850, 3.6e6, 2}, {0.4, 2000, 0}, {2.5, -3000, 300}},  // steel-like units, cold left
    {{'B', 1, 1, 1, 0}, {0.3, 0, 0}, {2.5, 0, 0}},                       // heat that is only stored, absolute zero
    {{'A', 1, 1, 1, 1}, {1, 1e4, 1e-3}, {1, -1.1e4, 2}},                 // Mach 1e4
    {{'C', 1, 1, 1, 1}, {0.5, -15, 1}, {0.7, 15, 0.5}},                  // stretched a hundredfold
    {{'B', 1, 1, 1, 2}, {0.02, 0, 1}, {1, 0, 1e-3}},                     // pressures 1e6 apart
    {{'C', 1, 1, 1, 0.01}, {1, 2, 0.1}, {0.6, -1, 0.3}},                 // nearly crushed
    {{'A', 1, 1, 1, 1.3}, {0.8, 0.3, 0.4}, {0.8 * (1 + 1e-9), 0.3 - 1e-8, 0.4}}};  // weak

}  // namespace

TEST_CASE("riemann_nonlinear_elastic: star states and fans are those of 50 digits", "[gate]") {
    for (const auto& data : cases) {
        const auto& [law, L, R] = data;
        const ElasticSolution s = solve(data);
        INFO(law.material << ", k = " << law.k << ": " << L.lambda << ", " << L.v << ", " << L.T << " | " << R.lambda
                          << ", " << R.v << ", " << R.T);

        const Law real{law.material, law.E, law.rho0, law.c_v, law.k};
        const Side left{real, L.lambda, L.T, real.rho0 / s.rho_star_L};
        const Side right{real, R.lambda, R.T, real.rho0 / s.rho_star_R};
        const auto misfit = [&](const Real& p) { return left.at(p).push + right.at(p).push + R.v - L.v; };
        const Real scale = s.pressure();
        const Real p = secant(misfit, -s.sigma_star, -s.sigma_star + scale * Real("1e-13"));
        const Side::Star star_L = left.at(p);
        const Side::Star star_R = right.at(p);
        const Real v = (Real(L.v) + R.v + star_R.push - star_L.push) / 2;
        REQUIRE(abs(misfit(p)) < Real("1e-35") * s.speed());

        // Stated: 1e-13; these keep some ulp.
        CHECK(abs(s.sigma_star + p) <= 16 * eps * scale);
        CHECK(abs(s.v_star - v) <= 16 * eps * s.speed());
        CHECK(abs(s.rho_star_L * star_L.lambda / real.rho0 - 1) <= 64 * eps);
        CHECK(abs(s.rho_star_R * star_R.lambda / real.rho0 - 1) <= 64 * eps);
        CHECK(abs(s.T_star_L - star_L.T) <= 256 * eps * star_L.T);
        CHECK(abs(s.T_star_R - star_R.T) <= 256 * eps * star_R.T);

        for (const bool on_left : {true, false}) {
            const ElasticWave* wave = s.wave(on_left ? "left" : "right");
            if (wave == nullptr || wave->kind != "rarefaction") continue;
            const Real sign = on_left ? 1 : -1;
            const Real T = on_left ? L.T : R.T;
            const Real from = on_left ? L.lambda : R.lambda;
            const Real to = on_left ? star_L.lambda : star_R.lambda;
            CHECK(abs(wave->tail - (v - sign * real.a(to, T))) <= 16 * eps * s.speed());
            for (const double share : {0.003, 0.3, 0.71, 0.999}) {
                const Real lambda = from * pow(to / from, Real(share));
                const auto speed = [&](const Real& l) {
                    return Real(on_left ? L.v : R.v) + sign * (real.integral(from, l, T) - real.a(l, T));
                };
                const Real xi = speed(lambda);
                const Real slope = (speed(lambda * (1 + Real("1e-20"))) - xi) / Real("1e-20");  // by ln lambda
                const ElasticRow row = s.at(static_cast<double>(xi));
                CHECK(abs(row[velocity] - (xi + sign * real.a(lambda, T))) <=
                      16 * eps * s.speed() * (1 + real.a(lambda, T) / abs(slope)));
                CHECK(abs(row[density] * lambda / real.rho0 - 1) <= 16 * eps * (1 + s.speed() / abs(slope)));
            }
        }
    }
}
