#pragma once
// The waves of an elastic Riemann problem as constants of the catalogue.
#include <optional>
#include <string>

#include "oracles/oracle.hpp"

namespace ordo::oracles::elastic {

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
