#include "solvers/rrm/options.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "core/text.hpp"

namespace ordo::solvers::rrm {
namespace {

/// A temperature that is little for a medium: a thousandth of what holds as much energy as its stiffness.
constexpr auto coldest = []<class M>(const M& medium) {
    if constexpr (M::has_temperature) return 1e-3 * medium.E / medium.c_v;
    else return 1.0;
};

/// Sizes of the watched fields in the initial data and at the ends, the same for every observer that moves uniformly.
Watched sizes(const LineScene& scene) {
    Watched size{};
    double slowest = std::numeric_limits<double>::infinity();
    double fastest = -slowest;
    double sound = 0;
    std::vector<Contents> states = scene.pieces;
    for (const LineEnd& end : scene.ends) {
        if (end.kind == LineEnd::Kind::prescribed) states.push_back(end.outside);
        if (end.kind != LineEnd::Kind::wall) continue;
        slowest = std::min(slowest, end.velocity);
        fastest = std::max(fastest, end.velocity);
    }
    for (const Contents& q : states) {
        const Flow f = std::visit([&](const auto& medium) { return medium.flow(q); }, scene.medium);
        slowest = std::min(slowest, f.v);
        fastest = std::max(fastest, f.v);
        sound = std::max(sound, f.a);
        size[0] = std::max(size[0], f.rho);
        size[2] = std::max(size[2], f.rho * f.a * f.a);
        size[3] = std::max(size[3], std::abs(f.T));
    }
    size[1] = std::max(sound, fastest - slowest);
    size[3] = std::max(size[3], std::visit(coldest, scene.medium));
    return size;
}

const std::array<const char*, 4> changes{"density_change", "velocity_change", "pressure_change", "temperature_change"};

Parameter change(const char* name, const char* unit, const char* field) {
    return without_default(number(name, unit, 1, positive,
                                  std::string("flattening error of the ") + field +
                                      " that a chop-out may make at delta = 1; absent: its size in the data "
                                      "times a tenth of the line's length"));
}

}  // namespace

std::vector<Parameter> declared_options() {
    return {word("keep", "waves",
                 {{"nothing", "flatten each interval to one cell, closest to the papers [Walker2012]"},
                  {"contacts", "keep contacts: two cells that share a velocity [ToroSpruceSpeares1994]"},
                  {"waves", "put back the waves that two cells send along, where a front would soon be chopped out"}},
                 "what a chop-out keeps sharp"),
            word("speeds", "davis",
                 {{"davis", "the extremes of both cells [Davis1988]"},
                  {"own", "those of each edge's own cell: exact for linear elasticity, too slow for gas"}},
                 "how fast the edges of a disturbed interval run"),
            change(changes[0], "kg", "density"),
            change(changes[1], "m^2/s", "velocity"),
            change(changes[2], "J", "pressure"),
            change(changes[3], "K m", "temperature"),
            number("most_events", "-", 1e8, at_least(1), "more chop-outs and unions than these end a run")};
}

std::vector<Parameter> declared_resolution() {
    return {number("delta", "-", 1e-3, positive, "error control: factor of all flattening errors that are allowed")};
}

void check(const LineScene& scene) {
    const auto refuse = [](const std::string& why) { throw InputError("solver rrm", why); };
    for (std::size_t i = 0; i + 1 < scene.edges.size(); ++i) {
        if (!(scene.edges[i] < scene.edges[i + 1]))
            refuse("the pieces' borders must rise, but " + shortest(scene.edges[i + 1]) + " follows " +
                   shortest(scene.edges[i]));
    }
    const auto physical = [&](const Contents& q) {
        return std::visit([&](const auto& medium) { return medium.flow(q).physical(); }, scene.medium);
    };
    for (const Contents& q : scene.pieces) {
        if (!physical(q))
            refuse("needs matter with positive density and speed of sound everywhere: no vacuum, no cold gas");
    }
    for (const LineEnd& end : scene.ends) {
        if (end.kind == LineEnd::Kind::prescribed && !physical(end.outside))
            refuse("the state prescribed at an end must have positive density and speed of sound");
    }
    for (const LineEnd& end : scene.ends) {
        if (end.kind == LineEnd::Kind::free && std::holds_alternative<IdealGas>(scene.medium))
            refuse(
                "a gas has no free end: it would expand into the vacuum; nearest: a piece of thin gas and a reservoir");
    }
    const auto periodic = [&](std::size_t side) { return scene.ends[side].kind == LineEnd::Kind::periodic; };
    if (periodic(0) != periodic(1)) refuse("one end is periodic, so the other one must be");
}

Options options_from(const LineScene& scene, const Values& options, const Values& resolution) {
    const auto& keep = options.word("keep");
    Options chosen{.keep = keep == "nothing"    ? Keep::nothing
                           : keep == "contacts" ? Keep::contacts
                                                : Keep::waves,
                   .speeds = options.word("speeds") == "own" ? Speeds::own : Speeds::davis,
                   .allowed = sizes(scene),
                   .most_events = options.number("most_events")};
    const double length = scene.edges.back() - scene.edges.front();
    for (std::size_t k = 0; k < changes.size(); ++k) {
        const double at_one = options.has(changes[k]) ? options.number(changes[k]) : 0.1 * length * chosen.allowed[k];
        chosen.allowed[k] = resolution.number("delta") * at_one;
    }
    return chosen;
}

}  // namespace ordo::solvers::rrm
