#pragma once
// What the elastic Riemann problems say of themselves in the catalogue: the parameters of their states, their waves.
#include <optional>
#include <string>
#include <vector>

#include "oracles/oracle.hpp"

namespace ordo::oracles::elastic {

/// The two states, with the range that their stretches may have. The defaults: compressed on the left.
inline std::vector<Parameter> state_parameters(const Range& stretches) {
    return {number("lambda_L", "-", 0.5, stretches, "stretch on the left"),
            number("v_L", "m/s", 0, finite, "velocity on the left"),
            number("T_L", "K", 1, at_least(0), "temperature on the left"),
            number("lambda_R", "-", 1, stretches, "stretch on the right"),
            number("v_R", "m/s", 0, finite, "velocity on the right"),
            number("T_R", "K", 0.2, at_least(0), "temperature on the right")};
}

/// {kind, side, speed}, and its place x0 + speed t where a time is given.
inline Constants wave_record(const std::string& kind, const std::string& side, double speed, double x0,
                             std::optional<double> t) {
    Constants record{{"kind", kind}, {"side", side}, {"speed", speed}};
    if (t) record.push_back({"x", x0 + speed * *t});
    return record;
}

/// {kind, side, head, tail} of a rarefaction, and their places.
inline Constants fan_record(const std::string& side, double head, double tail, double x0, std::optional<double> t) {
    Constants record{{"kind", "rarefaction"}, {"side", side}, {"head", head}, {"tail", tail}};
    if (t) {
        record.push_back({"x_head", x0 + head * *t});
        record.push_back({"x_tail", x0 + tail * *t});
    }
    return record;
}

}  // namespace ordo::oracles::elastic
