#include "reports/plot/ticks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace ordo::reports {
namespace {

/// multiple * 10^decade
struct Tick {
    int multiple = 1;
    int decade = 0;

    double value() const { return multiple * std::pow(10, decade); }
    bool operator==(const Tick&) const = default;
};

std::vector<Tick> ticks_in(const Interval& range, const std::vector<int>& multiples, int decades_apart) {
    std::vector<Tick> ticks;
    const int last = static_cast<int>(std::ceil(std::log10(range.high)));
    for (int decade = static_cast<int>(std::floor(std::log10(range.low))); decade <= last; ++decade) {
        if (decade % decades_apart != 0) continue;
        for (const int multiple : multiples) {
            const Tick tick{multiple, decade};
            if (tick.value() >= range.low && tick.value() <= range.high) ticks.push_back(tick);
        }
    }
    return ticks;
}

const std::vector<int> decades_only{1};
const std::vector<int> every_multiple{1, 2, 3, 4, 5, 6, 7, 8, 9};

/// Decades, else the multiples 1 2 5, else all multiples: whichever first gives three ticks.
std::vector<Tick> labelled_ticks(const Interval& range, int decades_apart) {
    for (const auto& multiples : {decades_only, std::vector<int>{1, 2, 5}}) {
        auto ticks = ticks_in(range, multiples, decades_apart);
        if (ticks.size() >= 3) return ticks;
    }
    return ticks_in(range, every_multiple, decades_apart);
}

/// "0.02" where all labels are short that way, else "2x10^{-5}" as gnuplot's enhanced text.
std::string label(const Tick& tick, bool plain) {
    if (plain) return fmt::format("{:g}", tick.value());
    const std::string times = "\xC3\x97";
    return (tick.multiple == 1 ? "" : std::to_string(tick.multiple) + times) + fmt::format("10^{{{}}}", tick.decade);
}

}  // namespace

std::string log_ticks(const Interval& range) {
    const double decades = std::log10(range.high / range.low);
    const int decades_apart = std::max(1, static_cast<int>(std::ceil(decades / 8)));
    const auto labelled = labelled_ticks(range, decades_apart);
    const bool plain = std::ranges::all_of(labelled, [](const Tick& t) { return t.decade >= -3 && t.decade <= 3; });
    std::string list;
    for (const auto& tick : ticks_in(range, decades_apart == 1 ? every_multiple : decades_only, 1)) {
        const bool major = std::ranges::find(labelled, tick) != labelled.end();
        list += fmt::format("{}'{}' {}e{}{}", list.empty() ? "" : ", ", major ? label(tick, plain) : "", tick.multiple,
                            tick.decade, major ? "" : " 1");
    }
    return "(" + list + ")";
}

}  // namespace ordo::reports
