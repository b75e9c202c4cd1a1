#pragma once
// What is true of three gases whose waves meet, said without the oracle's formulas: what there is in all, jump
// conditions, uniform pieces and means, before the collision and after it.
#include <algorithm>
#include <string>
#include <vector>

#include "oracles/lines/shock_collision.hpp"
#include "tests/oracles/lines/line_gate.hpp"

namespace ordo::oracles::gate::collision {

using namespace line;

using State = std::array<double, 3>;  // rho, v, p

struct Flow {
    State left, middle, right;
    double gamma, x_L, x_R;
};

/// The inrush; strong and unequal shocks; the same mirrored and moved; a shock that meets a fan; fans that meet; gases
/// that part.
inline const Flow inrush{{0.3, 0.6, 0.4}, {0.1, 0, 0.2}, {0.6, -0.6, 0.5}, 1.4, -5, 5};
inline const Flow strong{{2, 3, 40}, {0.7, 0.2, 0.01}, {1.1, -1, 9}, 1.67, 0.3, 1.4};
inline const Flow reversed{{1.1, 1, 9}, {0.7, -0.2, 0.01}, {2, -3, 40}, 1.67, -1.4, -0.3};
inline const Flow shock_fan{{2, 1, 10}, {1, 0, 2}, {0.5, 0, 0.4}, 1.4, 0, 1};
inline const Flow two_fans{{0.5, 0, 0.4}, {1, 0, 2}, {0.5, 0, 0.4}, 1.3, -1, 1};
inline const std::vector<Flow> flows{inrush, strong, reversed, shock_fan, two_fans};

inline Given given(const Flow& flow) {
    Given list{{"gamma", flow.gamma}, {"x_L", flow.x_L}, {"x_R", flow.x_R}};
    const auto add = [&](const std::string& ending, const State& state) {
        list["rho" + ending] = state[0];
        list["v" + ending] = state[1];
        list["p" + ending] = state[2];
    };
    add("_L", flow.left);
    add("_M", flow.middle);
    add("_R", flow.right);
    return list;
}

inline Exact exact_of(const Flow& flow) { return bound(shock_collision(), given(flow)); }

/// Before and after the collision, until the end.
inline std::vector<double> moments(const Flow& flow, const Exact& exact) {
    const double t_c = constant(exact, "t_c"), end = exact.times.high;
    std::vector<double> list{0.5 * t_c, 0.99 * t_c};
    if (end > t_c) {
        for (const double share : {1e-3, 0.3, 0.6, 0.999}) list.push_back(t_c + share * (std::min(end, 2 * t_c) - t_c));
    }
    return flow.x_L < flow.x_R ? list : std::vector<double>{};
}

inline double speed(const Flow& flow) {
    double largest = 0;
    for (const auto& [rho, v, p] : {flow.left, flow.middle, flow.right})
        largest = std::max(largest, std::abs(v) + std::sqrt(flow.gamma * p / rho));
    return 3 * largest;
}

inline Three densities(const Flow& flow, const State& s) {
    return {s[0], s[0] * s[1], s[2] / (flow.gamma - 1) + 0.5 * s[0] * s[1] * s[1]};
}
inline Three flux_of(const Flow& flow, const State& s) {
    const Three q = densities(flow, s);
    return {q[1], q[1] * s[1] + s[2], (q[2] + s[2]) * s[1]};
}
inline Three scales(const Flow& flow) {
    const double rho = flow.left[0] + flow.middle[0] + flow.right[0];
    return {rho, rho * speed(flow), rho * speed(flow) * speed(flow)};
}

/// Ends of an interval that no wave has left, in which every cell is summed: content is what was there and came in.
inline Defect totals(const Exact& exact, const Flow& flow) {
    Defect defect;
    for (const double t : moments(flow, exact)) {
        const double reach = speed(flow) * t + 0.1 * (flow.x_R - flow.x_L);
        const double a = flow.x_L - reach, b = flow.x_R + reach;
        const int cells = 23;
        for (std::size_t k = 0; k < 3; ++k) {
            double content = 0;
            for (int i = 0; i < cells; ++i) {
                const double from = a + (b - a) * i / cells, to = a + (b - a) * (i + 1) / cells;
                content += (to - from) * contents(exact, mean_over(exact, from, to, t))[k];
            }
            const double before = reach * densities(flow, flow.left)[k] + reach * densities(flow, flow.right)[k] +
                                  (flow.x_R - flow.x_L) * densities(flow, flow.middle)[k];
            const double came = t * (flux_of(flow, flow.left)[k] - flux_of(flow, flow.right)[k]);
            const double size = scales(flow)[k] * (b - a);
            defect.add(content - before - came, tolerance * size, size);
        }
    }
    return defect;
}

/// Rankine-Hugoniot at each jump, its speed from where it is a little later; the field is uniform between waves, and
/// goes on at the edges of fans.
inline Defect waves(const Exact& exact, const Flow& flow) {
    Defect defect;
    const auto differ = [&](double x, double y, double t, double s) {
        const auto before = row_at(exact, x, t), after = row_at(exact, y, t);
        const Three q = contents(exact, before), r = contents(exact, after), F = flux(exact, before),
                    G = flux(exact, after);
        for (std::size_t k = 0; k < 3; ++k) {
            const double size = scales(flow)[k] * speed(flow);
            defect.add(G[k] - F[k] - s * (r[k] - q[k]), 1e-9 * size, size);
        }
    };
    const double near = 1e-10 * (flow.x_R - flow.x_L);
    for (const double t : moments(flow, exact)) {
        const double step = 1e-4 * t;
        const auto now = exact.jumps(t), before = exact.jumps(t - step);
        const auto list = exact.waves(t);
        std::vector<double> sharp;
        double last = flow.x_L - speed(flow) * t;
        for (const auto& wave : list) {
            differ(last + near, 0.5 * (last + wave.left), t, 2 * speed(flow));
            differ(0.5 * (last + wave.left), wave.left - near, t, 2 * speed(flow));
            if (wave.kind == Wave::Kind::fan) {
                differ(wave.left - near, wave.left + near, t, 2 * speed(flow));
                differ(wave.right - near, wave.right + near, t, 2 * speed(flow));
            } else {
                sharp.push_back(wave.left);
            }
            last = wave.right;
        }
        defect.add(sharp == now ? 0 : 1, 0, 1);
        if (now.size() != before.size()) continue;  // the collision is between
        for (std::size_t i = 0; i < now.size(); ++i)
            differ(now[i] - near, now[i] + near, t, (now[i] - before[i]) / step);
    }
    return defect;
}

/// rho e (gamma - 1) = p, momentum and total energy are what they are called; pressure and velocity go on at contacts.
inline Defect gas_law(const Exact& exact, const Flow& flow) {
    Defect defect;
    for (const double t : moments(flow, exact)) {
        for (int i = 0; i < 50; ++i) {
            const double x = flow.x_L + (flow.x_R - flow.x_L) * (i * 0.04 - 0.5);
            const auto row = row_at(exact, x, t);
            const double rho = field(exact, "density", row), v = field(exact, "velocity", row),
                         e = field(exact, "energy", row), p = field(exact, "pressure", row);
            defect.add((flow.gamma - 1) * rho * e - p, 1e-13 * p, p);
            defect.add(field(exact, "momentum", row) - rho * v, 1e-13 * scales(flow)[1], scales(flow)[1]);
            defect.add(field(exact, "total_energy", row) - rho * (e + v * v / 2), 1e-13 * scales(flow)[2],
                       scales(flow)[2]);
        }
    }
    return defect;
}

/// Inside the fans of the first two problems, and across all waves: means are quadratures of samples cut at waves.
inline Defect means(const Exact& exact, const Flow& flow) {
    Defect defect;
    for (const double t : moments(flow, exact)) {
        const double reach = speed(flow) * t;
        const Claim claim{exact,
                          0,
                          1,
                          1,
                          {(flow.x_L - reach) / t, flow.x_L / t, 0.5 * (flow.x_L + flow.x_R) / t, flow.x_R / t,
                           (flow.x_R + reach) / t},
                          {}};
        const Defect found = mean_of_samples_at(claim, t);
        defect.add(found.found, found.allowed, 1);
    }
    return defect;
}

inline std::string ringing_of(const Exact& exact, const Flow& flow) {
    return std::string(totals(exact, flow).holds() ? "" : "totals; ") + (waves(exact, flow).holds() ? "" : "waves; ") +
           (gas_law(exact, flow).holds() ? "" : "gas law");
}

}  // namespace ordo::oracles::gate::collision
