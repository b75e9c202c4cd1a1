#pragma once
// What is true of a flow of gas or of an elastic line, said without an oracle's formulas: conservation of mass,
// momentum and energy in integral form and across jumps, and means against samples. Over claims, so that faulty flows
// can be passed too.
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "oracles/oracle.hpp"
#include "tests/oracles/differences.hpp"

namespace ordo::oracles::gate::line {

using Three = std::array<double, 3>;  ///< of mass, momentum and energy

/// A claimed flow whose waves leave x0 at t = 0, and the data that it was claimed for.
struct Claim {
    Exact exact;
    double x0 = 0;
    double rho = 1;              ///< size of its densities [kg/m^3]
    double speed = 1;            ///< size of its speeds, sound included [m/s]
    std::vector<double> places;  ///< x at t = 1 between which the balance is drawn, x0 = 0
    std::function<double(const Exact&, double x, double t)>
        law;  ///< relative defect of the law of the medium, 0 where it holds

    Three scale() const { return {rho, rho * speed, rho * speed * speed}; }
};

inline constexpr double tolerance = 1e-11;  ///< relative to the scales; the oracles' own is 1e-13 of larger ones
inline constexpr std::array times{0.2, 1.0, 7.3};

inline double field(const Exact& exact, const std::string& name, const std::vector<double>& row) {
    return row[*exact.offset(name)];
}

inline std::vector<double> row_at(const Exact& exact, double x, double t) {
    std::vector<double> row(exact.width());
    exact.sample({&x, 1}, t, row);
    return row;
}

inline double at(const Exact& exact, const std::string& name, double x, double t) {
    return field(exact, name, row_at(exact, x, t));
}

inline std::vector<double> mean_over(const Exact& exact, double a, double b, double t) {
    std::vector<double> row(exact.width());
    exact.averages(std::array{a, b}, t, row);
    return row;
}

inline Three contents(const Exact& exact, const std::vector<double>& row) {
    return {field(exact, "density", row), field(exact, "momentum", row), field(exact, "total_energy", row)};
}

/// What passes a place at rest; nothing passes where nothing is.
inline Three flux(const Exact& exact, const std::vector<double>& row) {
    const auto [mass, momentum, energy] = contents(exact, row);
    if (mass == 0) return {0, 0, 0};
    const double v = field(exact, "velocity", row);
    const double p = exact.offset("pressure") ? field(exact, "pressure", row) : -field(exact, "stress", row);
    return {momentum, momentum * v + p, (energy + p) * v};
}

/// Edges of the waves at t, from left to right.
inline std::vector<double> wave_edges(const Exact& exact, double t) {
    std::vector<double> edges;
    for (const auto& wave : exact.waves(t)) {
        edges.push_back(wave.left);
        if (wave.right > wave.left) edges.push_back(wave.right);
    }
    return edges;
}

/// A flow that depends on xi = (x - x0) / t only: the content of a < x < b is [(x - x0) q - t F] between its ends.
inline Defect balance(const Claim& claim) {
    Defect defect;
    const auto& exact = claim.exact;
    for (const double t : times) {
        const auto brought = [&](double x) {
            const auto row = row_at(exact, x, t);
            const Three q = contents(exact, row), F = flux(exact, row);
            Three sum;
            for (std::size_t k = 0; k < 3; ++k) sum[k] = (x - claim.x0) * q[k] - t * F[k];
            return sum;
        };
        for (std::size_t i = 0; i + 1 < claim.places.size(); ++i) {
            const double a = claim.x0 + claim.places[i] * t, b = claim.x0 + claim.places[i + 1] * t;
            const Three content = contents(exact, mean_over(exact, a, b, t));
            const Three from = brought(a), to = brought(b);
            for (std::size_t k = 0; k < 3; ++k) {
                const double size = claim.scale()[k] * claim.speed * t;
                defect.add((b - a) * content[k] - (to[k] - from[k]), tolerance * size, size);
            }
        }
    }
    return defect;
}

/// [F] = s [q] at every jump, with s from where it is at two times; and the waves are where the jumps are.
inline Defect jump_conditions(const Claim& claim) {
    Defect defect;
    const auto& exact = claim.exact;
    for (const double t : times) {
        const auto now = exact.jumps(t), later = exact.jumps(1.5 * t);
        std::vector<double> sharp;
        for (const auto& wave : exact.waves(t)) {
            if (wave.kind != Wave::Kind::fan) sharp.push_back(wave.left);
        }
        defect.add(now.size() == later.size() && now == sharp ? 0 : 1, 0, 1);
        for (std::size_t i = 0; i < std::min(now.size(), later.size()); ++i) {
            const double s = (later[i] - now[i]) / (0.5 * t);
            const double beside = 1e-9 * claim.speed * t;
            const auto before = row_at(exact, now[i] - beside, t), after = row_at(exact, now[i] + beside, t);
            const Three F = flux(exact, before), G = flux(exact, after);
            const Three q = contents(exact, before), r = contents(exact, after);
            for (std::size_t k = 0; k < 3; ++k) {
                const double size = claim.scale()[k] * claim.speed;
                defect.add(G[k] - F[k] - s * (r[k] - q[k]), tolerance * size, size);
            }
            defect.add(
                std::abs(r[0] - q[0]) > 1e-6 * claim.rho || std::abs(r[2] - q[2]) > 1e-6 * claim.scale()[2] ? 0 : 1, 0,
                1);  // something does jump
        }
    }
    return defect;
}

/// Means of all fields are the quadrature of their samples, cut at the waves.
inline Defect mean_of_samples_at(const Claim& claim, double t) {
    using Rule = boost::math::quadrature::gauss_kronrod<double, 31>;
    Defect defect;
    const auto& exact = claim.exact;
    for (std::size_t i = 0; i + 1 < claim.places.size(); ++i) {
        const double a = claim.x0 + claim.places[i] * t, b = claim.x0 + claim.places[i + 1] * t;
        std::vector<double> cuts{a};
        for (const double edge : wave_edges(exact, t)) {
            if (edge > a && edge < b) cuts.push_back(edge);
        }
        cuts.push_back(b);
        const auto mean = mean_over(exact, a, b, t);
        for (const auto& info : exact.fields) {
            double sum = 0, size = 0, error = 0;
            for (std::size_t j = 0; j + 1 < cuts.size(); ++j) {
                const auto f = [&](double x) { return at(exact, info.name, x, t); };
                double part_error = 0, part_size = 0;
                sum += Rule::integrate(f, cuts[j], cuts[j + 1], 10, 1e-13, &part_error, &part_size);
                size += part_size;
                error += part_error;
            }
            if (size > 0) defect.add((b - a) * field(exact, info.name, mean) - sum, error + tolerance * size, size);
        }
    }
    return defect;
}

inline Defect mean_of_samples(const Claim& claim) {
    Defect defect;
    for (const double t : times) {
        const Defect now = mean_of_samples_at(claim, t);
        defect.add(now.found, now.allowed, 1);
    }
    return defect;
}

/// The law of the medium; momentum and total energy are what they are called.
inline Defect law(const Claim& claim) {
    Defect defect;
    const auto& exact = claim.exact;
    for (const double t : times) {
        for (std::size_t i = 0; i + 1 < claim.places.size(); ++i) {
            const double x = claim.x0 + 0.5 * (claim.places[i] + claim.places[i + 1]) * t;
            const auto row = row_at(exact, x, t);
            const double rho = field(exact, "density", row), v = field(exact, "velocity", row);
            defect.add(claim.law(exact, x, t), 1e-8, 1);  // elastic laws are tested by differences
            defect.add(field(exact, "momentum", row) - rho * v, tolerance * claim.scale()[1], claim.scale()[1]);
            defect.add(field(exact, "total_energy", row) - rho * (field(exact, "energy", row) + 0.5 * v * v),
                       tolerance * claim.scale()[2], claim.scale()[2]);
        }
    }
    return defect;
}

struct Gate {
    std::string name;
    std::function<Defect(const Claim&)> defect;
};
inline const std::vector<Gate> gates{
    {"balance", balance}, {"jump conditions", jump_conditions}, {"means", mean_of_samples}, {"law", law}};

/// Names of the gates that the claim does not pass, joined.
inline std::string ringing(const Claim& claim, const std::vector<Gate>& asked = gates) {
    std::string names;
    for (const auto& [name, defect] : asked) {
        if (!defect(claim).holds()) names += name + "; ";
    }
    return names;
}

/// The same flow with change(row, x, t) made to every sample and, at the middle of a cell, to every mean.
template <class F>
Claim changed(Claim claim, F change) {
    const auto with = [change, width = claim.exact.width()](Exact::Sample given, bool cells) {
        return [=](std::span<const double> x, double t, std::span<double> rows) {
            given(x, t, rows);
            for (std::size_t i = 0; i * width < rows.size(); ++i)
                change(rows.subspan(i * width, width), cells ? 0.5 * (x[i] + x[i + 1]) : x[i], t);
        };
    };
    claim.exact.sample = with(claim.exact.sample, false);
    claim.exact.averages = with(claim.exact.averages, true);
    return claim;
}

/// The oracle of that name with these parameters, the rest at their defaults.
inline Exact bound(const Oracle& oracle, const Given& given) {
    return oracle.bind(resolve(oracle.parameters, given, "test", oracle.name));
}

inline double constant(const Exact& exact, const std::string& name, std::optional<double> t = {}) {
    for (const auto& [own, value] : exact.constants(t)) {
        if (own == name) return std::get<double>(value);
    }
    return std::numeric_limits<double>::quiet_NaN();
}

/// What an oracle says when it refuses; empty when it does not.
inline std::string refusal(const Oracle& oracle, const Given& given) {
    try {
        bound(oracle, given);
    } catch (const std::exception& error) {
        return error.what();
    }
    return "";
}

}  // namespace ordo::oracles::gate::line
