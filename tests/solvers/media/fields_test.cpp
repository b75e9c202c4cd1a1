// The fields of a line by name: their values in closed form, and which medium has which.
#include "solvers/media/fields.hpp"

#include <cmath>

#include "core/error.hpp"
#include "tests/catch.hpp"

using namespace ordo;
using namespace ordo::solvers;

namespace {

double value(const Medium& medium, const std::string& name, const Contents& q) {
    const std::vector<std::string> names{name};
    const Field field = field_of_cells(medium, line_fields(medium, names)[0], 1, [&](std::size_t) { return q; });
    CHECK(field.name == name);
    CHECK(field.components == 1);
    return field.values[0];
}

const ElasticMedium<RubberEnergy> rubber{.E = 2, .rho0 = 1.5, .c_v = 0.7, .k = 1};

}  // namespace

TEST_CASE("line fields: a gas has the fields of its state", "[unit]") {
    const IdealGas gas{1.3};
    const Contents q = gas.contents(0.7, -0.4, 2);
    CHECK(value(gas, "density", q) == 0.7);
    CHECK(value(gas, "velocity", q) == Approx(-0.4).epsilon(1e-15));
    CHECK(value(gas, "pressure", q) == Approx(2).epsilon(1e-15));
    CHECK(value(gas, "energy", q) == Approx(2 / (0.3 * 0.7)).epsilon(1e-15));
    CHECK(value(gas, "momentum", q) == Approx(-0.28).epsilon(1e-15));
    CHECK(value(gas, "total_energy", q) == Approx(2 / 0.3 + 0.35 * 0.16).epsilon(1e-15));
}

TEST_CASE("line fields: an elastic line has the fields of its state", "[unit]") {
    // C = (E/3)(l^2/2 + 1/l - 3/2) + c_v T / l, stress dC/dl, at l = 0.8 and T = 0.4.
    const Contents q = rubber.contents(0.8, 0.3, 0.4);
    const double C = 2.0 / 3 * (0.32 + 1.25 - 1.5) + 0.7 * 0.4 / 0.8;
    const double rho = 1.5 / 0.8;
    CHECK(value(rubber, "density", q) == Approx(rho).epsilon(1e-15));
    CHECK(value(rubber, "strain", q) == Approx(-0.2).epsilon(1e-14));
    CHECK(value(rubber, "temperature", q) == Approx(0.4).epsilon(1e-14));
    CHECK(value(rubber, "stress", q) == Approx(2.0 / 3 * (0.8 - 1 / 0.64) - 0.7 * 0.4 / 0.64).epsilon(1e-14));
    CHECK(value(rubber, "energy", q) == Approx(C / 1.5).epsilon(1e-14));
    CHECK(value(rubber, "momentum", q) == Approx(0.3 * rho).epsilon(1e-15));
    CHECK(value(rubber, "total_energy", q) == Approx(C / 0.8 + 0.5 * rho * 0.09).epsilon(1e-14));
}

TEST_CASE("line fields: rises are differences between the ends of cells", "[unit]") {
    const IdealGas gas;
    const std::vector<LineField> fields{LineField::density, LineField::pressure};
    const auto rises = rises_over_cells(
        gas, fields, 2, [&](std::size_t i) { return gas.contents(1, 0.5, 1 + double(i)); },
        [&](std::size_t i) { return gas.contents(2, -1, 4 - double(i)); });
    CHECK(rises[0].name == "density");
    CHECK(rises[0].values[1] == Approx(1).epsilon(1e-14));
    const Field& rise = rises[1];
    CHECK(rise.name == "pressure");
    CHECK(rise.values[0] == Approx(3).epsilon(1e-14));
    CHECK(rise.values[1] == Approx(1).epsilon(1e-14));
}

TEST_CASE("line fields: what a medium lacks is refused with what it has", "[unit]") {
    const auto ask = [](const Medium& medium, const std::string& name) {
        return line_fields(medium, std::vector<std::string>{"density", name});
    };
    CHECK_THROWS_WITH(ask(IdealGas{}, "strain"), ContainsSubstring("a gas has no field 'strain'") &&
                                                     ContainsSubstring("density, velocity, pressure"));
    CHECK_THROWS_AS(ask(IdealGas{}, "temperature"), InputError);
    CHECK_THROWS_WITH(ask(rubber, "pressure"), ContainsSubstring("an elastic line has no field 'pressure'"));
    CHECK_THROWS_AS(ask(rubber, "displacement"), InputError);
    CHECK(ask(rubber, "strain") == std::vector<LineField>{LineField::density, LineField::strain});
}
