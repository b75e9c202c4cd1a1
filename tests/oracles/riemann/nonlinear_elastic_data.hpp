#pragma once
// Data for the Riemann problem of nonlinear elastic materials, and what the catalogue's oracle says of them.
#include <cmath>
#include <string>
#include <vector>

#include "oracles/riemann/riemann_nonlinear_elastic.hpp"
#include "tests/oracles/fuzz.hpp"
#include "tests/oracles/riemann/elastic_gate.hpp"

namespace ordo::oracles::gate::elastic {

struct Data {
    ElasticLaw law;
    ElasticState left, right;
};

inline Exact exact_of(const Data& data) {
    static const Oracle oracle = riemann_nonlinear_elastic();
    const auto& [law, L, R] = data;
    const Given given{{"lambda_L", L.lambda},
                      {"v_L", L.v},
                      {"T_L", L.T},
                      {"lambda_R", R.lambda},
                      {"v_R", R.v},
                      {"T_R", R.T},
                      {"E", law.E},
                      {"rho0", law.rho0},
                      {"c_v", law.c_v},
                      {"k", law.k},
                      {"material", std::string(1, law.material)}};
    return oracle.bind(resolve(oracle.parameters, given, "", oracle.name));
}

inline ElasticSolution solve(const Data& data) { return solution_of(exact_of(data), data.law, data.left, data.right); }

/// The four published pairs of states, in which E = rho0 = c_v = k = 1.
inline std::vector<Data> suite(char material) {
    const ElasticLaw law{material, 1, 1, 1, 1};
    return {{law, {0.5, 0, 1}, {1, 0, 0.2}},
            {law, {1, 0.4, 0.5}, {1, -0.4, 0.5}},
            {law, {1, -0.4, 0.5}, {1, 0.4, 0.5}},
            {law, {0.8, 0.3, 0.4}, {1.25, -0.1, 0.9}}};
}

/// Any material, units over decades, cold, equal, weak, strong and mirror-symmetric data.
inline Data any_data(Random& random) {
    const char material = "ABC"[random.whole(0, 2)];
    const double k = random.whole(0, 4) == 0 ? 0 : random.uniform(0, 3);
    const ElasticLaw law{material, random.log_uniform(1e-3, 1e3), random.log_uniform(1e-2, 1e4),
                         random.log_uniform(1e-2, 1e2), k};
    const double c = std::sqrt(law.E / law.rho0);
    const auto state = [&] {
        const double T = random.whole(0, 4) == 0 ? 0 : random.log_uniform(1e-4, 3) * law.E / law.c_v;
        return ElasticState{random.log_uniform(0.2, 4), random.uniform(-2, 2) * c, T};
    };
    Data data{law, state(), state()};
    if (material == 'C' && k < 0.1) data.left.v = data.right.v = 0;  // it crushes to nothing at a few times c
    const int kind = random.whole(0, 9);
    if (kind == 0) data.right = {data.left.lambda, -data.left.v, data.left.T};
    if (kind == 1) data.right = {data.left.lambda * (1 + 1e-7 * random.uniform(-1, 1)), data.left.v, data.left.T};
    if (kind == 2 && !(material == 'C' && k < 0.1)) data.right.v += 20 * c * random.uniform(-1, 1);
    return data;
}

inline std::string text_of(const Data& data) {
    const auto state = [](const ElasticState& s) {
        return std::to_string(s.lambda) + ", " + std::to_string(s.v) + ", " + std::to_string(s.T);
    };
    return std::string(1, data.law.material) + ", k = " + std::to_string(data.law.k) +
           ", E = " + std::to_string(data.law.E) + ", rho0 = " + std::to_string(data.law.rho0) +
           ", c_v = " + std::to_string(data.law.c_v) + ": " + state(data.left) + " | " + state(data.right);
}

}  // namespace ordo::oracles::gate::elastic
