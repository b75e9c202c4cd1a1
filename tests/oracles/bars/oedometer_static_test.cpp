#include "oracles/bars/oedometer_static.hpp"

#include <map>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "tests/catch.hpp"
#include "tests/oracles/bars/oedometer_gate.hpp"
#include "tests/oracles/fuzz.hpp"

using namespace ordo;
using namespace ordo::oracles;
using namespace ordo::oracles::gate;
using namespace ordo::oracles::gate::loaded;

namespace {

using Law = OedometerStatic::Law;
const std::vector<std::pair<Law, std::string>> laws{{Law::nominal, "E(F-1)"},
                                                    {Law::reciprocal, "E(1-1/F)"},
                                                    {Law::logarithmic, "E ln F"},
                                                    {Law::kirchhoff, "E ln F / F"},
                                                    {Law::neo_hookean, "E(F-1/F)/2"}};

/// Tiny and large strains, with and without weight, pulled and pressed.
std::vector<OedometerStatic> columns() {
    std::vector<OedometerStatic> list;
    for (const auto& [law, name] : laws) {
        list.push_back({.law = law});
        list.push_back({.H = 0.3, .E = 2.1e11, .rho = 7850, .g = 9.81, .p0 = -3e3, .law = law});
        list.push_back({.H = 2, .E = 10, .rho = 3, .g = 1.1, .p0 = 3.1, .law = law});
        list.push_back({.H = 2, .E = 10, .rho = 3, .g = 0, .p0 = 3.4, .law = law});
        list.push_back({.H = 2, .E = 10, .rho = 3, .g = 1e-9, .p0 = -2, .law = law});
    }
    list.push_back({.H = 2, .E = 10, .rho = 3, .g = 30, .p0 = 2, .law = Law::reciprocal});  // F down to 1/18
    list.push_back({.H = 2, .E = 10, .rho = 3, .g = 30, .p0 = 20, .law = Law::neo_hookean});
    list.push_back({.H = 2, .E = 10, .rho = 3, .g = 9, .p0 = 20, .law = Law::logarithmic});
    list.push_back({.H = 2, .E = 10, .rho = 3, .g = 4, .p0 = 20, .law = Law::nominal});
    return list;
}

std::string name_of(const OedometerStatic& column) {
    return laws[static_cast<std::size_t>(column.law)].second + ", E = " + std::to_string(column.E) +
           ", g = " + std::to_string(column.g) + ", p0 = " + std::to_string(column.p0);
}

Exact bound(const Given& given) {
    const Oracle oracle = oedometer_static();
    return oracle.bind(resolve(oracle.parameters, given, "", "oedometer_static"));
}

Given given_by(const OedometerStatic& c) {
    return {{"H", c.H}, {"E", c.E},   {"rho", c.rho},
            {"g", c.g}, {"p0", c.p0}, {"law", laws[static_cast<std::size_t>(c.law)].second}};
}

}  // namespace

TEST_CASE("oedometer_static: balance, load, law and integral hold", "[gate]") {
    for (const auto& column : columns()) {
        const Defect defect = column_at_rest(column_of(column));
        INFO(name_of(column) << ": defect " << defect.found << ", allowed " << defect.allowed);
        CHECK(defect.holds());
    }
}

TEST_CASE("oedometer_static: loads and strains of the papers", "[published]") {
    // E(1-1/F), E = 1e5 Pa, no gravity: -ln F = ln(1 + p/E), printed with five digits.
    const std::map<double, double> printed{{5000, 0.04879},  {10000, 0.09531}, {15000, 0.13976},
                                           {20000, 0.18232}, {25000, 0.22314}, {30000, 0.26236}};
    for (const auto& [load, strain] : printed) {
        const OedometerStatic column{.H = 1, .E = 1e5, .g = 0, .p0 = -load, .law = Law::reciprocal};
        CHECK(std::abs(-column.log_stretch(0.3) - strain) <= 0.5001e-5);
    }
    // The same law under its own weight: y = (E / rho g) ln[(1 + rho g H / E) / (1 + rho g (H - X) / E)].
    const OedometerStatic heavy{.H = 25, .E = 1e5, .rho = 1e3, .g = 9.81, .law = Law::reciprocal};
    const double w = 1e3 * 9.81 / 1e5;
    for (const double X : {3.0, 11.0, 25.0})
        CHECK(X + heavy.displacement(X) == Approx(std::log((1 + w * 25) / (1 + w * (25 - X))) / w).epsilon(1e-14));
    // The compacted column: Cauchy stress -rho g (l0 - Y).
    CHECK(OedometerStatic{}.stress(12.5) == -800 * 37.5);
}

TEST_CASE("oedometer_static: small loads meet the linear column", "[gate]") {
    for (const auto& [law, name] : laws) {
        const OedometerStatic column{.H = 2, .E = 1e7, .rho = 3, .g = 1.1, .p0 = 0.7, .law = law};
        for (const double X : {0.3, 1.1, 2.0}) {
            const double linear = (0.7 * X - 3 * 1.1 * (2 * X - X * X / 2)) / 1e7;
            const double second_order = 2 * 1e-6 * 1e-6 * 2;  // F - 1 = p + O(p^2), |p| < 1e-6
            CHECK(std::abs(column.displacement(X) - linear) <= second_order);
        }
    }
}

TEST_CASE("oedometer_static: what has no stretch is refused, and the last that has is not", "[unit]") {
    const auto given = [](const std::string& law, double p0, double g = 0) {
        return Given{{"law", law}, {"p0", p0}, {"g", g}, {"E", 10.0}, {"H", 2.0}, {"rho", 1.0}};
    };
    CHECK_THROWS_WITH(
        bound(given("E(1-1/F)", 10)),
        ContainsSubstring("oracle oedometer_static: P = 10 Pa at the base") && ContainsSubstring("P < E only, E = 10"));
    CHECK_THROWS_WITH(bound(given("E(1-1/F)", 11, 1)), ContainsSubstring("P = 11 Pa at the top"));
    CHECK_THROWS_WITH(bound(given("E(F-1)", 1, 5.5)), ContainsSubstring("P = -10 Pa at the base"));
    CHECK_THROWS_WITH(bound(given("E ln F / F", 3.6788)), ContainsSubstring("P <= E / e"));
    CHECK_THROWS_WITH(bound(given("E ln F", 3001)), ContainsSubstring("[-300, 300]"));
    CHECK_THROWS_WITH(bound({{"p0", 1e308}, {"E", 1e-5}}), ContainsSubstring("out of the range of numbers"));
    const auto top_strain = [](const Exact& exact) {
        const double X = 2;
        std::array<double, 3> row{};
        exact.sample({&X, 1}, 0, row);
        return row[1];
    };
    CHECK(top_strain(bound(given("E ln F / F", 3.6787944117144233))) == Approx(std::exp(1.0) - 1).epsilon(1e-15));
    CHECK(top_strain(bound(given("E(1-1/F)", 9.999))) == Approx(9999).epsilon(1e-11));
    CHECK(top_strain(bound(given("E(F-1)", -9.999))) == Approx(-0.9999).epsilon(1e-15));
    CHECK(bound(given("E ln F", 1)).constants({}).size() == 4);
}

TEST_CASE("oedometer_static: the gate rings for seeded faults", "[alarm]") {
    for (const auto& column : columns()) {
        if (column.g < 1) continue;
        INFO(name_of(column));
        const Column good = column_of(column);
        REQUIRE(column_at_rest(good).holds());
        for (auto member : {&OedometerStatic::g, &OedometerStatic::E, &OedometerStatic::rho, &OedometerStatic::H}) {
            OedometerStatic faulty = column;
            faulty.*member *= 1 + 1e-6;
            Column wrong = column_of(faulty);
            wrong.data = column;
            CHECK_FALSE(column_at_rest(wrong).holds());
        }
        for (const auto& [law, name] : laws) {  // a law that is another's
            OedometerStatic faulty = column;
            faulty.law = law;
            if (law == column.law || !std::isfinite(faulty.strain(0) + faulty.strain(column.H))) continue;
            if (std::abs(faulty.strain(0)) < 1e-6) continue;  // steel: one linear law
            Column wrong = column_of(faulty);
            wrong.data = column;
            CHECK_FALSE(column_at_rest(wrong).holds());
        }
        Column upside_down = good;
        upside_down.stress = [good](double X) { return good.stress(good.data.H - X); };
        CHECK_FALSE(column_at_rest(upside_down).holds());
        Column logarithmic = good;  // ln F for F - 1
        logarithmic.strain = [good](double X) { return std::log1p(good.strain(X)); };
        if (std::abs(good.strain(0)) > 1e-3) CHECK_FALSE(column_at_rest(logarithmic).holds());
        Column shifted = good;
        shifted.displacement = [good](double X) { return good.displacement(X) * (1 + 1e-6); };
        CHECK_FALSE(column_at_rest(shifted).holds());
        Column broken = good;
        broken.strain = [](double) { return std::nan(""); };
        CHECK_FALSE(column_at_rest(broken).holds());
    }
}

TEST_CASE("oedometer_static: random columns obey their law, and only what it cannot bear is refused", "[property]") {
    Random random(20263);
    Tally tally;
    const Oracle oracle = oedometer_static();
    const int rounds = fuzz_rounds(2000);
    for (int round = 0; round < rounds; ++round) {
        const auto& [law, name] = laws[static_cast<std::size_t>(random.whole(0, 4))];
        OedometerStatic column{.H = random.log_uniform(1e-4, 1e4),
                               .E = random.log_uniform(1e-4, 1e12),
                               .rho = random.log_uniform(1e-4, 1e4),
                               .law = law};
        const double weight = random.coin() ? random.log_uniform(1e-9, 3) : 0;  // rho g H / E
        column.g = weight * column.E / (column.rho * column.H);
        column.p0 = random.uniform(-1.2, 1.2) * (random.coin() ? 1 : 1e-6) * column.E;
        const double low = (column.p0 - column.rho * column.g * column.H) / column.E, high = column.p0 / column.E;
        try {
            const Exact exact = oracle.bind(resolve(oracle.parameters, given_by(column), "", "oedometer_static"));
            const double X = random.uniform(0, 1) * column.H;
            const std::array places{0.0, X, column.H};
            std::array<double, 9> rows{};
            exact.sample(places, 0, rows);
            for (const double value : rows) REQUIRE(std::isfinite(value));
            REQUIRE(rows[0] == 0);
            const double F = 1 + rows[4];
            REQUIRE(F > 0);
            const double load = std::max(std::abs(low), std::abs(high));
            const double stiffness =
                std::abs(nominal_stress(column, F * (1 + 1e-6)) - nominal_stress(column, F)) / 1e-6;
            const double rounding = 2e-15 * (stiffness * (1 + 1 / F) + column.E * (load + 1 + 1 / F));
            INFO(name_of(column) << ", H = " << column.H << ", X / H = " << X / column.H);
            REQUIRE(std::abs(nominal_stress(column, F) - rows[5]) <= rounding);
            // u grows with X, and its means lie between the strains at the ends.
            const double least = rows[1], most = rows[7];
            const double slack = 1e-14 * std::max(std::abs(least), std::abs(most));
            REQUIRE((rows[3] >= (least - slack) * X && rows[3] <= (most + slack) * X));
            REQUIRE((rows[6] - rows[3] >= (rows[4] - slack) * (column.H - X) - slack * column.H &&
                     rows[6] - rows[3] <= (most + slack) * (column.H - X) + slack * column.H));
            ++tally.checked;
        } catch (const InputError&) {
            const double margin = 1e-15 * (1 + weight);
            REQUIRE(((law == Law::nominal && low <= -1 + margin) || (law == Law::reciprocal && high >= 1 - margin) ||
                     (law == Law::kirchhoff && high >= std::exp(-1.0) - margin)));
            ++tally.refused;
        }
    }
    CHECK(tally.mostly_checked());
}
