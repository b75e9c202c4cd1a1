#pragma once
// What is true of a Riemann problem of gases, said without the oracle's wave curves: conservation laws in jump,
// differential and integral form, the gas law, and which way waves may go. Functions over claims, so that faulty
// solutions can be passed too.
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <string>
#include <vector>

#include "tests/oracles/differences.hpp"
#include "tests/oracles/riemann/riemann_gas_claim.hpp"

namespace ordo::oracles::gate {

/// Rankine-Hugoniot in the frame of every shock, contact and edge: mass, momentum and energy go in as they come out.
/// At the ends of a fan it says that the fields go on.
inline Defect jump_conditions(const GasClaim& claim) {
    Defect defect;
    for (const double s : claim.places()) {
        const auto before = claim.at(std::nextafter(s, -infinity)), after = claim.at(s);
        if (before.density < tiny && after.density < tiny) continue;
        const auto a = conserved(before, s), b = conserved(after, s);
        const auto scale = scales(claim, {before, after});
        for (std::size_t k = 0; k < 3; ++k) {
            if (scale[k] > tiny && scale[k] < 1 / tiny)
                defect.add(b.flux[k] - a.flux[k], claim.roundoff(s) * scale[k], scale[k]);
        }
    }
    return defect;
}

/// (F - xi q)' + q = 0 inside every fan by differences: the Euler equations for functions of x / t. In the frame of the
/// gas that is there.
inline Defect equations_in_fans(const GasClaim& claim) {
    Defect defect;
    for (const auto& wave : claim.waves) {
        if (wave.kind != GasWave::Kind::rarefaction) continue;
        const Gas& gas = wave.side == GasWave::Side::left ? claim.left : claim.right;
        const double width = wave.tail - wave.head;
        if (std::abs(width) < 1e-3 * claim.speed()) continue;  // differences would see round-off only
        for (const double share : {0.11, 0.37, 0.52, 0.89}) {
            const double xi = wave.head + share * width;
            const auto here = claim.at(xi);
            const double a = sound(gas, here.density, here.pressure);
            if (here.density < 1e-100 * gas.rho || a < 1e-3 * claim.speed()) continue;
            const auto in_frame = [&](double place) {
                auto f = claim.at(place);
                f.velocity -= here.velocity;
                return conserved(f, 0);
            };
            // Relative round-off: of a position, as it acts through rho' / rho = O(1 / a), and of the stiff energy.
            const double force = std::abs(here.pressure) + here.density * std::abs(here.energy);
            const std::array scale{here.density, here.density * a, force};
            const double noise = 8 * eps * claim.speed() / a * std::max(1.0, force / (here.density * a * a));
            if (noise > 1e-11) continue;  // as before
            for (std::size_t k = 0; k < 3; ++k) {
                const auto F = [&](double place) {
                    const auto c = in_frame(place);
                    return c.flux[k] - (place - here.velocity) * c.q[k];
                };
                const auto dF = first_derivative(F, xi, 0.02 * std::min(std::abs(width), a), noise * scale[k] * a);
                defect.add(dF.value + in_frame(xi).q[k], dF.error + noise * scale[k], scale[k]);
            }
        }
    }
    return defect;
}

/// Edges of cells between waves, across them and over the ends of fans; wide and narrow.
inline std::vector<double> cells_over(const GasClaim& claim) {
    const double reach = 1.25 * claim.speed();
    std::vector<double> edges{-reach, -0.41 * reach, 0.13 * reach, 0.72 * reach, reach};
    for (const auto& wave : claim.waves) {
        for (const double share : {-0.07, 0.07, 0.5, 0.93, 1.07})
            edges.push_back(wave.head + share * (wave.tail - wave.head));
        edges.push_back(wave.head + 1e-3 * reach);
        edges.push_back(wave.tail - 1e-6 * reach);
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
}

template <class Visit>
void over_cells_of(const GasClaim& claim, Visit&& visit) {
    const auto edges = cells_over(claim);
    const auto places = claim.places();
    for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
        std::vector<double> cuts{edges[i]};
        for (const double place : places) {
            if (place > cuts.back() && place < edges[i + 1]) cuts.push_back(place);
        }
        cuts.push_back(edges[i + 1]);
        std::vector<GasFields> states;
        for (const double cut : cuts) {
            states.push_back(claim.at(cut));
            states.push_back(claim.at(std::nextafter(cut, -infinity)));
        }
        visit(cuts, scales(claim, states));
    }
}

/// What is in the cell (a, b) at t = 1 came in through sides that left one point at t = 0: [xi q - F(q)]. Cell means
/// against point values.
inline Defect cell_balance(const GasClaim& claim) {
    Defect defect;
    over_cells_of(claim, [&](const std::vector<double>& cuts, const std::array<double, 3>& scale) {
        const double a = cuts.front(), b = cuts.back();
        if (scale[0] < tiny * claim.speed()) return;
        const auto mean = claim.mean(a, b);
        const auto at_a = conserved(claim.at(a), 0), at_b = conserved(claim.at(b), 0);
        const std::array means{mean.density, mean.momentum, mean.total_energy};
        for (std::size_t k = 0; k < 3; ++k) {
            const double brought = (b * at_b.q[k] - at_b.flux[k]) - (a * at_a.q[k] - at_a.flux[k]);
            const double tolerance = (claim.roundoff(a) + claim.roundoff(b)) * scale[k];
            if (scale[k] > tiny && scale[k] < 1 / tiny) defect.add((b - a) * means[k] - brought, tolerance, scale[k]);
        }
    });
    return defect;
}

/// The means of velocity, pressure and energy are the quadrature of their samples, cut at the waves; none where a part
/// has no value. (Cell balance sees to the other three.)
inline Defect mean_of_samples(const GasClaim& claim) {
    using Rule = boost::math::quadrature::gauss_kronrod<double, 31>;
    Defect defect;
    over_cells_of(claim, [&](const std::vector<double>& cuts, const std::array<double, 3>&) {
        const double width = cuts.back() - cuts.front();
        const auto mean = claim.mean(cuts.front(), cuts.back()).row();
        for (const std::size_t field : {1, 2, 3}) {
            double sum = 0, size = 0, error = 0;
            for (std::size_t i = 0; i + 1 < cuts.size() && !std::isnan(sum); ++i) {
                const double length = cuts[i + 1] - cuts[i];
                const auto f = [&](double share) { return claim.at(cuts[i] + share * length).row()[field]; };
                double part_error = 0, part_size = 0;
                sum += length / width * Rule::integrate(f, 0, 1, 8, 1e-13, &part_error, &part_size);
                size += length / width * part_size;
                error += length / width * part_error;
            }
            const double scale = field == 1 ? claim.speed() : size + std::max(claim.left.p_inf, claim.right.p_inf);
            if (error > 1e-10 * scale) continue;  // quadrature of 1 / rho beside a cavity says nothing
            if (std::isnan(sum)) defect.add(std::isnan(mean[field]) ? 0 : 1, 0, 1);
            else if (scale > 0) defect.add(mean[field] - sum, error + 1e-12 * scale, scale);
        }
    });
    return defect;
}

/// rho e = (p + gamma p_inf) / (gamma - 1) in the gas whose it is; momentum and total energy are what they are called.
inline Defect gas_law(const GasClaim& claim) {
    Defect defect;
    for (const double xi : cells_over(claim)) {
        const auto f = claim.at(xi);
        const Gas& gas = claim.gas_at(xi);
        if (f.density == 0) {
            defect.add(f.momentum == 0 && std::isnan(f.velocity) == std::isnan(f.energy) ? 0 : 1, 0, 1);
            continue;
        }
        const double inner = f.density * f.energy;
        const double kinetic = 0.5 * f.density * f.velocity * f.velocity;
        if (f.density < tiny || inner < tiny) continue;
        defect.add((gas.gamma - 1) * inner - (f.pressure + gas.gamma * gas.p_inf),
                   32 * eps * (gas.gamma * (std::abs(f.pressure) + gas.p_inf)), gas.gamma * inner);
        defect.add(f.momentum - f.density * f.velocity, 4 * eps * std::abs(f.momentum), f.density * claim.speed());
        defect.add(f.total_energy - (inner + kinetic), 32 * eps * (inner + kinetic), inner + kinetic);
    }
    return defect;
}

/// Waves come in order, the data hold outside them, p and v go on at a contact, heads of fans run at the speed of
/// sound, and shocks compress: they overtake the sound ahead and are overtaken by the sound behind (Lax).
inline Defect admissible(const GasClaim& claim) {
    Defect defect;
    const double speed = claim.speed();
    const auto demand = [&](bool right) { defect.add(right ? 0 : 1, 0, 1); };
    const auto places = claim.places();
    demand(std::is_sorted(places.begin(), places.end()));
    const auto is = [&](const GasFields& f, const Gas& gas) {
        demand(gas.rho == 0 ? f.density == 0 : f.density == gas.rho && f.velocity == gas.v && f.pressure == gas.p);
    };
    is(claim.at(-2 * speed), claim.left);
    is(claim.at(2 * speed), claim.right);
    for (const auto& wave : claim.waves) {
        // Two waves may run at one double: a hair of gas against a cold one. Nothing can be seen between them.
        if (std::count(places.begin(), places.end(), wave.head) > 1) continue;
        const auto before = claim.at(std::nextafter(wave.head, -infinity)), after = claim.at(wave.head);
        const double outwards = wave.side == GasWave::Side::left ? -1 : 1;
        const Gas& gas = outwards < 0 ? claim.left : claim.right;
        const double a = sound(gas, gas.rho, gas.p);
        if (wave.kind == GasWave::Kind::contact) {
            defect.add(after.velocity - before.velocity, 4 * eps * speed, speed);
            defect.add(after.velocity - wave.head, 4 * eps * speed, speed);
            demand(after.pressure == before.pressure);
        } else if (wave.kind == GasWave::Kind::rarefaction) {
            defect.add(wave.head - (gas.v + outwards * a), 4 * eps * speed, speed);
            demand(outwards * (wave.head - wave.tail) >= 0);
        } else if (wave.kind == GasWave::Kind::shock) {
            const auto& behind = outwards < 0 ? after : before;
            if (behind.pressure + gas.p_inf < 1e-9 * gas.p_inf) continue;  // p no longer shows it
            const double a_behind = sound(gas, behind.density, behind.pressure);
            demand(behind.pressure > gas.p || behind.pressure + gas.p_inf <= (gas.p + gas.p_inf) * (1 + 4 * eps));
            demand(behind.density >= gas.rho * (1 - 4 * eps));
            demand(outwards * (wave.head - gas.v) >= a - 8 * eps * speed);
            demand(outwards * (wave.head - behind.velocity) <= a_behind + 8 * eps * speed);
        }
    }
    return defect;
}

struct GasGate {
    std::string name;
    Defect (*defect)(const GasClaim&);
};
inline const std::vector<GasGate> gas_gates{{"jump conditions", jump_conditions},
                                            {"equations in fans", equations_in_fans},
                                            {"cell balance", cell_balance},
                                            {"mean of samples", mean_of_samples},
                                            {"gas law", gas_law},
                                            {"admissible", admissible}};

}  // namespace ordo::oracles::gate
