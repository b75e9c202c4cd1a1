#include "oracles/free_flight.hpp"

#include <algorithm>

namespace ordo::oracles {
namespace {

Exact bind(const Values& values) {
    const FreeFlight flight{.dim = values.whole("dim"), .v0 = values.number("v0"), .g = values.number("g")};
    const auto edges = static_cast<std::size_t>(flight.dim);
    const auto one_point = [flight](std::span<const double>, double t, std::span<double> values) {
        std::fill(values.begin(), values.end(), 0.0);
        for (int axis = 0; axis < flight.dim; ++axis) {
            values[static_cast<std::size_t>(axis)] = flight.displacement(axis, t);
            values[static_cast<std::size_t>(flight.dim + axis)] = flight.velocity(axis, t);
        }
    };
    return {.dim = flight.dim,
            .coordinates = Coordinates::material,
            .lower = std::vector<double>(edges, 0.0),
            .upper = std::vector<double>(edges, values.number("L")),
            .fields = standard_fields(),
            .sample = pointwise(edges, 2 * edges + 2 * edges * edges, one_point),
            .jumps = no_jumps,
            .features = no_features};
}

}  // namespace

double FreeFlight::displacement(int axis, double t) const {
    return (axis == 0 ? v0 * t : 0.0) + (axis == dim - 1 ? 0.5 * g * t * t : 0.0);
}

double FreeFlight::velocity(int axis, double t) const {
    return (axis == 0 ? v0 : 0.0) + (axis == dim - 1 ? g * t : 0.0);
}

Oracle free_flight() {
    return {.name = "free_flight",
            .about = "Rigid translation of a free body under a constant force per mass, in 1, 2 or 3 dimensions",
            .source = {"Newton1687"},
            .explanation = "u(X, t) = v0 t e_first + g t^2 / 2 e_last;  the body does not deform, nothing depends on x",
            .example = "free_flight --set dim=2 --t 0.5 --x 0.2:0.3",
            .parameters = {whole("dim", 1, between(1, 3), "space dimension"),
                           number("L", "m", 1, positive, "edge of the body"),
                           number("v0", "m/s", 1, finite, "velocity along the first axis at t = 0"),
                           number("g", "m/s^2", -1, finite, "force per mass along the last axis")},
            .fields = standard_fields(),
            .smoothness = "analytic in t, constant in x",
            .accuracy = "1 ulp of the largest term",
            .bind = bind};
}

}  // namespace ordo::oracles
