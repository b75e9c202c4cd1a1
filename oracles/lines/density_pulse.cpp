#include "oracles/lines/density_pulse.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/text.hpp"
#include "oracles/features.hpp"
#include "oracles/riemann/gas_record.hpp"

namespace ordo::oracles {
namespace {

/// x in [0, L).
double wrapped(double x, double L) {
    const double rest = std::fmod(x, L);
    const double positive = rest < 0 ? rest + L : rest;
    return positive < L ? positive : 0;
}

std::vector<Wave> contacts(const DensityPulse& pulse, double t) {
    std::vector<Wave> list;
    for (const double x : pulse.jumps(t)) list.push_back({Wave::Kind::contact, x, x});
    return list;
}

DensityPulse pulse_from(const Values& values) {
    const DensityPulse pulse{.stream = gas_from(values, ""),
                             .rho_pulse = values.number("rho_pulse"),
                             .begin = values.number("begin"),
                             .width = values.number("width"),
                             .L = values.number("L")};
    const auto refuse = [&](const std::string& name, double value, const std::string& rule, double nearest) {
        throw InputError("oracle density_pulse",
                         name + " = " + shortest(value) + ", but must be " + rule + "; nearest: " + shortest(nearest));
    };
    if (!(pulse.width < pulse.L)) refuse("width", pulse.width, "< L = " + shortest(pulse.L), 0.5 * pulse.L);
    if (!(pulse.begin < pulse.L))
        refuse("begin", pulse.begin, "< L = " + shortest(pulse.L), wrapped(pulse.begin, pulse.L));
    return pulse;
}

Exact bind(const Values& values) {
    const DensityPulse pulse = pulse_from(values);
    Exact exact{.dim = 1,
                .coordinates = Coordinates::spatial,
                .lower = {0},
                .upper = {pulse.L},
                .fields = gas_fields(),
                .sample = along_a_line([pulse](double x, double t) { return pulse.at(x, t).row(); }),
                .averages = over_cells([pulse](double a, double b, double t) { return pulse.mean(a, b, t).row(); }),
                .jumps = [pulse](double t) { return pulse.jumps(t); },
                .waves = [pulse](double t) { return contacts(pulse, t); },
                .constants = [pulse](std::optional<double> t) -> Constants {
                    if (!t) return {{"period", std::abs(pulse.L / pulse.stream.v)}};
                    return {{"period", std::abs(pulse.L / pulse.stream.v)}, {"x_begin", pulse.place(*t)}};
                }};
    exact.features = features_of_waves(exact);
    return exact;
}

}  // namespace

double DensityPulse::place(double t) const { return wrapped(begin + stream.v * t, L); }

GasFields DensityPulse::fields(bool inside) const {
    Gas gas = stream;
    if (inside) gas.rho = rho_pulse;
    return fields_of(gas, gas.p);
}

GasFields DensityPulse::at(double x, double t) const {
    const double from = place(t);
    const double here = wrapped(x, L);
    return fields(here >= from ? here < from + width : here < from + width - L);
}

GasFields DensityPulse::mean(double a, double b, double t) const {
    if (!(a < b)) return at(a, t);
    const double from = place(t);
    const auto common = [&](double begin, double end) {
        return std::max(0.0, std::min(b, end) - std::max(a, begin)) / (b - a);
    };
    const double share = common(from, from + width) + common(from - L, from + width - L);
    GasFields sum{};
    sum.add(share, fields(true));
    sum.add(1 - share, fields(false));
    return sum;
}

std::vector<double> DensityPulse::jumps(double t) const {
    if (rho_pulse == stream.rho) return {};
    std::vector<double> places{place(t), wrapped(place(t) + width, L)};
    std::sort(places.begin(), places.end());
    return places;
}

Oracle density_pulse() {
    return {
        .name = "density_pulse",
        .about =
            "A square pulse of density in a uniform stream of gas, in a periodic domain: transport and nothing else",
        .source = {"Toro2009"},
        .explanation =
            "Ideal gas in the periodic domain [0, L): density rho_pulse on begin <= x < begin + width, rho elsewhere,\n"
            "velocity v and pressure p the same everywhere. The Euler equations then say\n"
            "  rho(x, t) = rho(x - v t, 0),   v and p constant\n"
            "x is the position in space, 0 <= x <= L. At a jump the state on its right holds. energy is internal, per "
            "mass.\n"
            "Refused: a pulse as wide as the domain, or that begins outside. Means over cells are exact in all "
            "fields.\n"
            "constants: period (infinite for a gas at rest); with t x_begin, where the pulse begins",
        .example = "density_pulse --t 0.4 --grid 0:1:21",
        .parameters = appended(gas_parameters("", {.rho = 1, .v = 1, .p = 1}, "of the stream"),
                               {gamma_parameter(), number("rho_pulse", "kg/m^3", 2, positive, "density of the pulse"),
                                number("begin", "m", 0.25, at_least(0), "where the pulse begins at t = 0, < L"),
                                number("width", "m", 0.5, positive, "of the pulse, < L"),
                                number("L", "m", 1, positive, "period of the domain")}),
        .fields = gas_fields(),
        .smoothness = "density, energy, momentum and total_energy jump where the pulse begins and ends; else constant",
        .accuracy = "2 ulp of each value; places 4 ulp of |v t| + L",
        .bind = bind};
}

}  // namespace ordo::oracles
