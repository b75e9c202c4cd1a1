#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "oracles/blasts/sedov.hpp"
#include "tests/catch.hpp"
#include "tests/oracles/blasts/sedov_blasts.hpp"

using namespace ordo;
using namespace ordo::oracles;
using namespace ordo::oracles::gate;
using namespace ordo::oracles::gate::point_blast;

TEST_CASE("sedov: what theory has no answer for is refused in one line", "[unit]") {
    const Oracle oracle = sedov();
    const auto bound = [&](const Given& given) {
        return oracle.bind(resolve(oracle.parameters, given, "", "oracle sedov"));
    };
    const auto message = [&](const Given& given) -> std::string {
        try {
            bound(given);
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    };
    using std::string;
    // omega_2 = 2 = j for the cylinder: the special exponent lies beyond the mass limit.
    CHECK_THAT(message({{"geometry", string("cylindrical")}, {"omega", 2.0}}),
               ContainsSubstring("omega = 2, but must be < 2") && ContainsSubstring("infinite mass"));
    CHECK_THAT(message({{"geometry", string("planar")}, {"omega", 1.0}}), ContainsSubstring("must be < 1"));
    CHECK_THAT(message({{"omega", 3.5}}), ContainsSubstring("must be < 3"));
    for (const double gamma : {1.0, 0.9, -2.0, std::nan("")})
        CHECK_THAT(message({{"gamma", gamma}}), ContainsSubstring("'gamma'") && ContainsSubstring("> 1"));
    CHECK_THAT(message({{"energy", 0.0}}), ContainsSubstring("'energy'"));
    CHECK_THAT(message({{"rho0", -1.0}}), ContainsSubstring("'rho0'"));
    CHECK_THAT(message({{"geometry", string("sphere")}}), ContainsSubstring("spherical"));
    CHECK_THAT(message({{"energy", 1e308}, {"rho0", 1e-308}, {"omega", 2.9}}), ContainsSubstring("range of a double"));
    CHECK_THAT(message({{"gamma", 1e300}}), ContainsSubstring("range of a double"));
    CHECK_THAT(message({{"gamma", 1e300}, {"omega", 2.999}}), ContainsSubstring("range of a double"));
    CHECK_THAT(message({{"omega", -1e300}}), ContainsSubstring("range of a double"));
    const Exact exact = bound({});
    CHECK_THROWS_AS(exact.check({}, 0, ""), InputError);
    CHECK_THROWS_AS(exact.check({}, -1, ""), InputError);
    const double outside = -0.1;
    CHECK_THROWS_AS(exact.check({&outside, 1}, 1, ""), InputError);
    CHECK_THROWS_AS(SedovBlast({.gamma = 1}), InputError);
    CHECK_THROWS_AS(SedovBlast({.energy = -1}), InputError);
    CHECK_THROWS_AS(SedovBlast({.rho0 = std::nan("")}), InputError);
}

TEST_CASE("sedov: the catalogue binds the same numbers to the same bits", "[gate]") {
    const Oracle oracle = sedov();
    constexpr std::array words{"", "planar", "cylindrical", "spherical"};
    for (const auto& given : blasts()) {
        const SedovBlast blast(given);
        const Exact exact =
            oracle.bind(resolve(oracle.parameters,
                                {{"geometry", std::string(words[static_cast<std::size_t>(given.geometry)])},
                                 {"gamma", given.gamma},
                                 {"omega", given.omega},
                                 {"energy", given.energy},
                                 {"rho0", given.rho0}},
                                "", "oracle sedov"));
        CHECK((exact.dim == 1 && exact.coordinates == Coordinates::spatial && exact.width() == 4));
        const double t = 0.8;
        const auto front = blast.front(t);
        const std::vector<double> x{0.37 * front.r, 0.91 * front.r, front.r, 2 * front.r};
        std::vector<double> rows(4 * x.size());
        exact.sample(x, t, rows);
        for (std::size_t i = 0; i < x.size(); ++i) {
            const auto [u, rho, p, e] = blast.at(x[i], t);
            const std::array expected{u, rho, p, e};
            for (std::size_t k = 0; k < 4; ++k)
                CHECK((rows[4 * i + k] == expected[k] || (std::isnan(rows[4 * i + k]) && std::isnan(expected[k]))));
        }
        CHECK(exact.jumps(t).back() == front.r);
        const auto constant = [&](const Constants& list, const std::string& name) {
            for (const auto& [known, value] : list) {
                if (known == name) return std::get<double>(value);
            }
            return std::nan("");
        };
        CHECK(constant(exact.constants({}), "alpha") == blast.integrals().alpha);
        CHECK(constant(exact.constants({}), "J2") == blast.integrals().J2);
        CHECK(std::isnan(constant(exact.constants({}), "r_shock")));
        CHECK(constant(exact.constants(t), "r_shock") == front.r);
        const bool vacuum = blast.profiles().kind() == BlastKind::vacuum;
        CHECK(exact.jumps(t).size() == (vacuum ? 2 : 1));
        CHECK(std::isnan(constant(exact.constants(t), "r_vacuum")) == !vacuum);
    }
}
