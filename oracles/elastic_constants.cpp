#include "oracles/elastic_constants.hpp"

#include "core/elastic_constants.hpp"

namespace ordo::oracles {
namespace {

constexpr const char* where = "oracle elastic_constants";

Exact bind(const Values& values) {
    const auto fallback = ordo::elastic_constants({Elastic::E, 1}, {Elastic::nu, 0.3}, where);
    const auto all = ordo::elastic_constants(values, fallback, where);
    return {.dim = 1,
            .coordinates = Coordinates::material,
            .lower = {0},
            .upper = {0},
            .fields = {},
            .sample = [](std::span<const double>, double, std::span<double>) {},
            .jumps = no_jumps,
            .features = no_features,
            .constants =
                [all](std::optional<double>) {
                    return Constants{{"E", all.E}, {"nu", all.nu},         {"K", all.K},
                                     {"G", all.G}, {"lambda", all.lambda}, {"M", all.M}};
                }};
}

}  // namespace

Oracle elastic_constants_oracle() {
    return {.name = "elastic_constants",
            .about = "Any two of E, nu, K, G, lambda, M of an isotropic elastic solid give the others",
            .source = {"Mavko1998"},
            .explanation =
                "stress = lambda tr(strain) I + 2 G strain;  K = lambda + 2 G/3,  M = lambda + 2 G,\n"
                "E = G (3 lambda + 2 G) / (lambda + G),  nu = lambda / (2 (lambda + G))\n"
                "Give exactly two, or none for E = 1, nu = 0.3. There are no fields: ask with --constants.\n"
                "E and M belong to two solids; the one with nu >= 0 is taken. Refused: what no solid with K > 0 and\n"
                "G > 0 has, such as E >= 9 K, and lambda = nu = 0, which leaves E open.\n"
                "Constants: E nu K G lambda M",
            .example = "elastic_constants --set K=2 --set G=1 --constants",
            .parameters = elastic_parameters("E 1, nu 0.3"),
            .fields = {},
            .smoothness = "constant",
            .accuracy =
                "4 ulp times (1 + condition) of each constant; the condition of y from a and b, of their relative "
                "errors, is (|r(y)-r(b)| + |r(y)-r(a)|) / |r(a)-r(b)| with r = d ln / d nu at constant E",
            .bind = bind};
}

}  // namespace ordo::oracles
