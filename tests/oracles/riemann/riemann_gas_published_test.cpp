// Star states and wave speeds of the problems that everybody computes.
#include <cmath>
#include <string>
#include <vector>

#include "oracles/riemann/riemann_gas.hpp"
#include "tests/catch.hpp"

using namespace ordo::oracles;

namespace {

struct Row {
    std::string name;
    Gas left, right;
    double p, v, rho_L, rho_R;
    std::vector<double> speeds;  ///< heads and tails, rising, without the contact; as printed, 14 digits
};

const std::vector<Row> rows{{"Sod",
                             {1, 0, 1},
                             {0.125, 0, 0.1},
                             0.30313017805064682,
                             0.92745262004894995,
                             0.42631942817849519,
                             0.26557371170530706,
                             {-1.1832159566199, -0.070272812561183, 1.7521557320302}},
                            {"modified Sod",
                             {1, 0.75, 1},
                             {0.125, 0, 0.1},
                             0.46629356683985561,
                             1.3609055190925576,
                             0.57986668748032415,
                             0.33970023490190745,
                             {-0.43321595661992, 0.29987066629115, 2.1532343675649}},
                            {"123",
                             {1, -2, 0.4},
                             {1, 2, 0.4},
                             0.001893873420054763,
                             0,
                             0.021852118206812831,
                             0.021852118206812831,
                             {-2.7483314773548, -0.34833147735479, 0.34833147735479, 2.7483314773548}},
                            {"left blast",
                             {1, 0, 1000},
                             {1, 0, 0.01},
                             460.89378749138354,
                             19.597451388723052,
                             0.57506229847655549,
                             5.999240704796234,
                             {-37.416573867739, -13.899632201272, 23.517536966903}},
                            {"right blast",
                             {1, 0, 0.01},
                             {1, 0, 100},
                             46.095044248867966,
                             -6.1963282497870359,
                             5.9924168635152249,
                             0.5751127897824123,
                             {-7.4374762586943, 4.3965656664548, 11.832159566199}},
                            {"collision",
                             {5.99924, 19.5975, 460.894},
                             {5.99242, -6.19633, 46.0950},
                             1691.6469553991261,
                             8.6897744116323806,
                             14.282349951978402,
                             31.042601641619876,
                             {0.78959391926444, 12.250778123084}},
                            {"stationary contact",
                             {1, -19.59745, 1000},
                             {1, -19.59745, 0.01},
                             460.89378749138354,
                             1.3887230524412268e-06,
                             0.57506229847655549,
                             5.999240704796234,
                             {-57.014023867739, -33.497082201272, 3.9200869669032}},
                            {"Lax",
                             {0.445, 0.698, 3.528},
                             {0.5, 0, 0.571},
                             2.4660979192073567,
                             1.528723026632884,
                             0.34456847418960951,
                             1.3040845320261996,
                             {-2.63356507406, -1.6366974421006, 2.4793214809898}},
                            {"Le Blanc",
                             {1, 0, 2.0 / 3 * 0.1, 5.0 / 3},
                             {1e-3, 0, 2.0 / 3 * 1e-10, 5.0 / 3},
                             5.1557792765096986e-4,
                             0.62183867139173445,
                             0.054079335349316236,
                             0.0039999980604299968,
                             {-1.0 / 3, 0.49578489518898, 0.82911836253347}},
                            {"two gammas",
                             {1, 0, 2, 2},
                             {0.125, 0, 0.1, 1.4},
                             0.43033193719712803,
                             1.2757096812798173,
                             0.46385985879203216,
                             0.32537956050342696,
                             {-2, -0.086435478080274, 2.0715179451534}},
                            {"slow shock",
                             {3.857143, -0.810631, 10.33333},
                             {1, -3.44, 1},
                             10.333332511232149,
                             -0.8106313361783799,
                             3.8571436695519097,
                             3.8571427492870112,
                             {-2.7472819020561, 0.1096477308993}},
                            {"two shocks",
                             {1, 0.5, 1},
                             {1.25, -0.5, 1},
                             1.8137499744302834,
                             -0.027864045000420607,
                             1.5207166706723398,
                             1.9008958383404247,
                             {-1.0415900782362, 0.87884008335016}},
                            {"Noh, 5/3",
                             {1, 1, 1e-6, 5.0 / 3},
                             {1, -1, 1e-6, 5.0 / 3},
                             1.3333355833321615,
                             0,
                             3.9999887500527341,
                             3.9999887500527341,
                             {-0.33333458333216, 0.33333458333216}},
                            {"Noh, 1.4",
                             {1, 1, 1e-6},
                             {1, -1, 1e-6},
                             1.2000021666655324,
                             0,
                             5.9999708335318273,
                             5.9999708335318273,
                             {-0.20000116666553, 0.20000116666553}},
                            {"Sod with p_R = 0.125",
                             {1, 0, 1},
                             {0.125, 0, 0.125},
                             0.32489594044694684,
                             0.87778927030186675,
                             0.44796689211361462,
                             0.24122982102564572,
                             {-1.1832159566199, -0.12986883225768, 1.8218125667287}}};

std::vector<double> speeds_of(const RiemannGas& problem) {
    std::vector<double> speeds;
    for (const auto& wave : problem.waves()) {
        if (wave.kind == GasWave::Kind::contact) continue;
        speeds.push_back(std::min(wave.head, wave.tail));
        if (wave.spread()) speeds.push_back(std::max(wave.head, wave.tail));
    }
    return speeds;
}

}  // namespace

TEST_CASE("riemann_gas: star states to 1e-13 and wave speeds to the printed digits", "[published]") {
    for (const auto& row : rows) {
        INFO(row.name);
        const RiemannGas problem(row.left, row.right);
        const auto& star = problem.star();
        const double scale = std::abs(row.left.v) + std::abs(row.right.v) + GasSide(row.left).a + GasSide(row.right).a;
        CHECK(std::abs(star.p - row.p) <= 1e-13 * row.p);
        CHECK(std::abs(star.v - row.v) <= 1e-13 * scale);
        if (row.v == 0) CHECK(star.v == 0);
        CHECK(std::abs(star.left.rho - row.rho_L) <= 1e-13 * row.rho_L);
        CHECK(std::abs(star.right.rho - row.rho_R) <= 1e-13 * row.rho_R);
        const auto speeds = speeds_of(problem);
        REQUIRE(speeds.size() == row.speeds.size());
        for (std::size_t k = 0; k < speeds.size(); ++k)
            CHECK(std::abs(speeds[k] - row.speeds[k]) <= 6e-14 * std::max(1.0, std::abs(row.speeds[k])));
    }
}

TEST_CASE("riemann_gas: the digits that [Toro2009] prints in its chapter 4", "[published]") {
    struct Printed {
        std::size_t row;
        double p, v, rho_L, rho_R, half;  // half: half a unit of the sixth digit, relative
    };
    const std::vector<Printed> table{{0, 0.30313, 0.92745, 0.42632, 0.26557, 2e-5},
                                     {2, 0.00189, 0.0, 0.02185, 0.02185, 3e-3},
                                     {3, 460.894, 19.5975, 0.57506, 5.99924, 1e-5},
                                     {4, 46.0950, -6.19633, 5.99242, 0.57511, 1e-5},
                                     {5, 1691.64, 8.68975, 14.2823, 31.0426, 1e-5}};
    for (const auto& printed : table) {
        const auto& row = rows[printed.row];
        INFO(row.name);
        const auto star = RiemannGas(row.left, row.right).star();
        CHECK(star.p == Approx(printed.p).epsilon(printed.half));
        CHECK(star.v == Approx(printed.v).epsilon(printed.half).margin(5e-6));
        CHECK(star.left.rho == Approx(printed.rho_L).epsilon(printed.half));
        CHECK(star.right.rho == Approx(printed.rho_R).epsilon(printed.half));
    }
}

TEST_CASE("riemann_gas: vacuum formed and the cold collision in closed form", "[published]") {
    const RiemannGas parted({1, -6, 0.4}, {1, 6, 0.4});
    CHECK(parted.star().vacuum);
    CHECK(parted.star().p == 0);
    const std::vector<double> edges{-6.7483314773548, -2.2583426132261, 2.2583426132261, 6.7483314773548};
    const auto waves = parted.waves();
    REQUIRE(waves.size() == 3);
    CHECK((waves[1].kind == GasWave::Kind::vacuum && waves[1].side == GasWave::Side::middle));
    const std::vector<double> found{waves[0].head, waves[1].head, waves[1].tail, waves[2].head};
    for (std::size_t k = 0; k < 4; ++k) CHECK(std::abs(found[k] - edges[k]) <= 5e-14);

    // The limit that the Noh-like rows approach: p* = 4/3, rho* = 4, shocks at 1/3.
    const RiemannGas cold({1, 1, 0, 5.0 / 3}, {1, -1, 0, 5.0 / 3});
    CHECK(cold.star().p == Approx(4.0 / 3).epsilon(1e-14));
    CHECK(cold.star().v == 0);
    CHECK(cold.star().left.rho == Approx(4).epsilon(1e-14));
    CHECK(cold.waves().front().head == Approx(-1.0 / 3).epsilon(1e-14));
}
