// Walls, pistons, free and prescribed ends, and rings, against exact solutions.
#include "tests/solvers/rrm/lines.hpp"

using namespace ordo;
using namespace ordo::solvers;
using namespace ordo::solvers::rrm;
using namespace ordo::solvers::rrm::test;

namespace {

using Kind = LineEnd::Kind;

const std::vector<std::string> keeps{"nothing", "contacts", "waves"};

/// A field of the cell that holds x.
double value_at(const Snapshot& shot, const std::string& field, double x) {
    const auto after = std::ranges::upper_bound(shot.edges, x);
    return shot.field(field).values[static_cast<std::size_t>(after - shot.edges.begin()) - 1];
}

/// Gas on [0, 2] at velocity v beside a wall that moves with V from x = 0: with its mirror image a Riemann problem.
struct Piston {
    double v, V, t;
    oracles::Gas gas{.rho = 0.9, .v = v, .p = 1.1};

    LineScene scene() const {
        const IdealGas medium;
        return {medium, {0, 2}, {medium.contents(gas.rho, v, gas.p)}, {LineEnd{Kind::wall, V}, LineEnd{}}};
    }
    Row errors(const Snapshot& shot) const {
        oracles::Gas image = gas;
        image.v = 2 * V - v;
        const oracles::RiemannGas exact(image, gas);
        std::vector<double> places;
        for (const auto& wave : exact.waves()) {
            for (const double speed : {wave.head, wave.tail}) places.push_back(speed * t);
        }
        std::ranges::sort(places);
        const auto error = [&](std::size_t k, auto field) {
            return l1(
                shot, k, [&](double x) { return exact.at(x, t).*field; }, places, V * t, 2);
        };
        return {error(0, &oracles::GasFields::density), error(1, &oracles::GasFields::velocity),
                error(2, &oracles::GasFields::pressure), 0};
    }
};

}  // namespace

TEST_CASE("rrm: pistons, and walls that a gas runs into, send an exact shock", "[property]") {
    for (const Piston& piston : {Piston{0, 0.8, 0.6}, Piston{-1.5, 0, 0.5}, Piston{0.2, 3, 0.3}}) {
        const auto shot = at(piston.t, piston.scene(), {}, 1e-3);
        CAPTURE(piston.v, piston.V);
        CHECK(shot.edges.front() == Approx(piston.V * piston.t).margin(1e-15));
        for (const double error : piston.errors(shot)) CHECK(error < 1e-13);
    }
}

TEST_CASE("rrm: pistons converge whatever is kept", "[convergence]") {
    // Flattened shocks are of the first order in delta, fans between 0.33 and 0.5 of it; kept fans of the first. At a
    // wall the half-interval has its own speed, so that a shock there loses a tenth of its order; which events come
    // first scatters an error by a tenth and more, that is 0.1 of an order over the one decade here.
    for (const auto& keep : keeps) {
        for (const Piston& piston :
             {Piston{0, 0.8, 0.6}, Piston{-1.5, 0, 0.5}, Piston{0.5, 0, 0.6}, Piston{0, -0.6, 0.6}}) {
            const bool shock = piston.V > piston.v;
            const auto error = [&](double delta) {
                return piston.errors(at(piston.t, piston.scene(), {{"keep", keep}}, delta));
            };
            const Row coarse = error(1e-3);
            const Row fine = error(1e-4);
            CAPTURE(keep, piston.v, piston.V, coarse[1], fine[1], coarse[2], fine[2]);
            const double least = keep == "waves" ? 0.9 : shock ? 0.75 : 0.33;
            for (const std::size_t k : {1u, 2u}) CHECK(fine[k] < 1e-13 + coarse[k] * std::pow(0.1, least));
            CHECK(fine[2] < 0.03);
        }
    }
}

TEST_CASE("rrm: a shock that a wall sends back leaves the gas at rest", "[published]") {
    // A shock into gas at rest with p2/p1 = z comes back with
    // p3/p2 = ((3 gamma - 1) z - (gamma - 1)) / ((gamma - 1) z + gamma + 1) [Toro2009, section 3.1, jump conditions].
    const double z = 4, gamma = 1.4;
    const double rho = ((gamma + 1) * z + gamma - 1) / ((gamma - 1) * z + gamma + 1);
    const double v = std::sqrt((z - 1) * (1 - 1 / rho));
    const IdealGas gas{gamma};
    const LineScene scene{gas, {-3, 0, 1}, {gas.contents(rho, v, z), gas.contents(1, 0, 1)}, {LineEnd{}, {Kind::wall}}};
    const double p3 = z * ((3 * gamma - 1) * z - (gamma - 1)) / ((gamma - 1) * z + gamma + 1);
    for (const auto& keep : keeps) {
        const auto shot = at(0.8, scene, {{"keep", keep}}, 1e-4);
        CAPTURE(keep);
        const double close = keep == "waves" ? 1e-6 : 1e-3;  // close to the wall even a kept shock is flattened
        CHECK(value_at(shot, "pressure", 0.9) == Approx(p3).epsilon(close));
        CHECK(std::abs(value_at(shot, "velocity", 0.9)) < close);
    }
}

TEST_CASE("rrm: a stretched linear bar between free ends is let go exactly", "[property]") {
    // Outside a free end there is no stress: each sends a wave that takes the strain away and gives the end velocity.
    const ElasticMedium<HookeEnergy> bar{.E = 2, .rho0 = 1.5};
    const double lambda = 1.2;
    const LineScene scene{bar, {0, 1.2}, {bar.contents(lambda, 0, 0.3)}, {LineEnd{Kind::free}, LineEnd{Kind::free}}};
    const double c = std::sqrt(2 / 1.5);  // in the reference, where the bar is 1 long
    for (const Given& way : {Given{{"keep", std::string("waves")}},
                             Given{{"keep", std::string("contacts")}, {"speeds", std::string("own")}}}) {
        const double t = 0.3 / c;
        const auto shot = at(t, scene, way, 1e-2);
        const double v = c * (lambda - 1);
        CHECK(std::abs(shot.edges.front() - v * t) < 1e-14);
        CHECK(std::abs(shot.edges.back() - (1.2 - v * t)) < 1e-14);
        CHECK(std::abs(value_at(shot, "velocity", v * t + 0.01) - v) < 1e-13);
        CHECK(std::abs(value_at(shot, "stress", v * t + 0.01)) < 1e-13);
        CHECK(std::abs(value_at(shot, "velocity", 0.6)) < 1e-13);
        CHECK(std::abs(value_at(shot, "density", 0.6) - 1.5 / lambda) < 1e-13);
        // At t = 1 / c the waves have passed each other and met the other end: the bar is as short as it was long.
        const auto later = at(0.98 / c, scene, {{"keep", std::string("waves")}}, 1e-3);
        CHECK(std::abs(later.edges.back() - later.edges.front() - (1.2 - 2 * 0.98 * 0.2)) < 1e-3);
    }
}

TEST_CASE("rrm: a contact goes twice round a ring", "[property]") {
    const IdealGas gas;
    const LineScene scene{gas,
                          {0, 0.3, 0.55, 1},
                          {gas.contents(1, 0.5, 1), gas.contents(0.2, 0.5, 1), gas.contents(1, 0.5, 1)},
                          {LineEnd{Kind::periodic}, LineEnd{Kind::periodic}}};
    for (const std::string keep : {"contacts", "waves"}) {
        for (const double t : {4.0, 4.2, 5.1}) {
            const auto shot = at(t, scene, {{"keep", keep}}, 1e-2);
            const double from = 0.3 + 0.5 * t - std::floor(0.3 + 0.5 * t);
            const auto rho = [&](double x) { return x - from - std::floor(x - from) < 0.25 ? 0.2 : 1; };
            std::vector<double> places{from, from + 0.25 - std::floor(from + 0.25)};
            std::ranges::sort(places);
            CAPTURE(keep, t);
            // Some thousand unions, each with its roundings.
            CHECK(l1(shot, 0, rho, places, 0, 1) < 1e-12);
            CHECK(l1(
                      shot, 1, [](double) { return 0.5; }, places, 0, 1) < 1e-12);
            CHECK(l1(
                      shot, 2, [](double) { return 1; }, places, 0, 1) < 1e-12);
        }
    }
}

TEST_CASE("rrm: gas that rushes in at both ends [Walker2012, fig. 41]", "[published]") {
    // Star states of the two ends and of the shocks' collision, to the digits of an exact solver.
    const IdealGas gas;
    LineScene scene{gas, {-5, 5}, {gas.contents(0.1, 0, 0.2)}, {LineEnd{Kind::prescribed}, LineEnd{Kind::prescribed}}};
    scene.ends[0].outside = gas.contents(0.3, 0.6, 0.4);
    scene.ends[1].outside = gas.contents(0.6, -0.6, 0.5);
    for (const auto& keep : keeps) {
        CAPTURE(keep);
        const Given options{
            {"keep", keep}, {"density_change", 1e-4}, {"velocity_change", 1e-3}, {"pressure_change", 1e-3}};
        const double close = keep == "waves" ? 2e-6 : 2e-3;  // the digits, and what flattening leaves of them
        const double close_rho = keep == "waves" ? 5e-6 : 0.02;
        const auto before = at(2, scene, options, 1);
        CHECK(value_at(before, "pressure", -3) == Approx(0.3546039).epsilon(close));
        CHECK(value_at(before, "velocity", -3) == Approx(0.7165542).epsilon(close));
        CHECK(value_at(before, "pressure", 3) == Approx(0.3798924).epsilon(close));
        CHECK(value_at(before, "velocity", 3) == Approx(-0.8078459).epsilon(close));
        CHECK(value_at(before, "density", -1) == Approx(0.149725).epsilon(close_rho));
        CHECK(value_at(before, "density", 1) == Approx(0.156932).epsilon(close_rho));
        const auto after = at(3.5, scene, options, 1);
        CHECK(value_at(after, "pressure", -0.3) == Approx(0.640986).epsilon(10 * close));
        CHECK(std::abs(value_at(after, "velocity", -0.3) + 0.090927) < 10 * close);
    }
}

TEST_CASE("rrm: the whole line between its ends is shown, however few fronts it has", "[property]") {
    const IdealGas gas;
    const ElasticMedium<LogarithmicEnergy> bar;
    const std::vector<LineScene> scenes{
        {gas, {0, 5}, {gas.contents(1, -0.2, 1)}, {LineEnd{Kind::wall}, LineEnd{}}},
        {gas, {-5, 0}, {gas.contents(1, 0.2, 1)}, {LineEnd{}, LineEnd{Kind::wall}}},
        {bar, {0, 5}, {bar.contents(3.9, 0, 1)}, {LineEnd{Kind::free}, LineEnd{}}},
        {bar, {0, 5}, {bar.contents(1.5, 0, 0)}, {LineEnd{Kind::free}, LineEnd{}}}};  // cold: no temperature to compare
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        for (const auto& keep : keeps) {
            for (const double delta : {1.0, 1e-3}) {
                CAPTURE(i, keep, delta);
                const Snapshot shot = at(0.3, scenes[i], {{"keep", keep}}, delta);
                const bool left = scenes[i].ends[0].kind != Kind::reservoir;
                CHECK((left ? shot.edges.back() : shot.edges.front()) == (left ? 5 : -5));
                if (i < 2) CHECK((left ? shot.edges.front() : shot.edges.back()) == Approx(0).margin(1e-14));
            }
        }
    }
}
