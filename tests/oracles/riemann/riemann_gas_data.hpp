#pragma once
// Data for Riemann problems of gases: seeded and random, every kind of wave pattern in its turn.
#include <cstdio>
#include <string>
#include <utility>

#include "oracles/riemann/riemann_gas.hpp"
#include "tests/oracles/fuzz.hpp"

namespace ordo::oracles::gate {

using GasPair = std::pair<Gas, Gas>;

/// Two gases `decades` apart at most, of one kind or two, ideal or stiffened, that meet or part at speeds around that
/// of sound. Some are the same gas with a weak disturbance, some are cold, some have nothing beside them, and some are
/// under tension.
inline GasPair random_gases(Random& random, double decades) {
    const auto any = [&] { return std::exp(random.uniform(-0.5, 0.5) * decades * std::log(10.0)); };
    const auto gamma = [&] { return 1 + random.log_uniform(0.02, 5); };
    Gas l{.rho = any(), .v = 0, .p = any(), .gamma = gamma()};
    Gas r{.rho = any(), .v = 0, .p = any(), .gamma = random.coin() ? gamma() : l.gamma};
    if (random.whole(0, 2) == 0) l.p_inf = any() * random.log_uniform(0.1, 100);
    if (l.p_inf > 0) r.p_inf = random.coin() ? l.p_inf : random.coin() ? l.p_inf * random.uniform(0.1, 3) : 0;
    if (random.whole(0, 3) == 0) {
        r = l;
        const double weak = random.log_uniform(1e-13, 0.1);
        r.p *= 1 + weak * random.uniform(-1, 1);
        r.rho *= 1 + weak * random.uniform(-1, 1);
    }
    const double a = GasSide(l).a + GasSide(r).a;
    r.v = a * random.uniform(-3, 3) * (random.coin() ? 1 : random.log_uniform(1e-12, 1));
    if (random.coin()) l.v = r.v * random.uniform(-1, 1);
    switch (random.whole(0, 15)) {
        case 0: l.p = -l.p_inf; break;
        case 1: r.p = -r.p_inf; break;
        case 2: l = {.rho = 0, .v = 0, .p = 0}; break;
        case 3: r = {.rho = 0, .v = 0, .p = 0}; break;
        case 4: l.p = -l.p_inf * random.uniform(0, 1); break;
        default: break;
    }
    return {l, r};
}

inline std::string text_of(const GasPair& pair) {
    char line[400];
    const auto& [l, r] = pair;
    std::snprintf(line, sizeof line, "{%.17g, %.17g, %.17g, %.17g, %.17g}, {%.17g, %.17g, %.17g, %.17g, %.17g}", l.rho,
                  l.v, l.p, l.gamma, l.p_inf, r.rho, r.v, r.p, r.gamma, r.p_inf);
    return line;
}

}  // namespace ordo::oracles::gate
