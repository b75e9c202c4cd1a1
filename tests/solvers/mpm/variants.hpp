#pragma once
// The family in few words: every word of every option at least once, alone or with what it needs.
#include <string>
#include <vector>

#include "tests/solvers/mpm/bodies.hpp"

namespace ordo::solvers::mpm::test {

/// Options off the default.
struct Variant {
    Given options;

    Given with(Given more) const {
        more.insert(options.begin(), options.end());
        return more;
    }
    std::string name() const {
        std::string text = "mpm";
        for (const auto& [option, value] : options) text += ", " + option + " " + text_of(value);
        return text;
    }
};

/// Of the updated frame, on a grid that stands still, for any law and dimension.
inline const std::vector<Variant> updated_variants{
    {{}},
    {{{"stress_update", "usf"}}},
    {{{"stress_update", "usl"}}},
    {{{"stress_update", "usavg"}}},
    {{{"position_update", "accelerated"}}},
    {{{"volume", "fixed"}}},
    {{{"placement", "gauss"}}},
    {{{"placement", "even_interior"}}},
    {{{"placement", "body_centred"}}},
    {{{"time", "leapfrog"}}},
    {{{"time", "leapfrog"}, {"stress_update", "usl"}}},
    {{{"time", "yoshida4"}}},
    {{{"time", "yoshida6"}, {"transfer", "blend"}}},
    {{{"basis", "quadratic"}}},
    {{{"basis", "cubic"}}},
    {{{"basis", "quartic"}}},
    {{{"basis", "ugimp"}}},
    {{{"basis", "cpgimp"}}},
    {{{"basis", "cpdi"}}},
    {{{"basis", "cpdi2"}}},
    {{{"basis", "ddmp"}}},
    {{{"mass", "fmpm"}}},
    {{{"mass", "fmpm"}, {"k", 2.0}, {"transfer", "fmpm"}, {"stress_update", "usl"}}},
    {{{"transfer", "pic"}}},
    {{{"transfer", "blend"}, {"flip_share", 0.9}}},
    {{{"transfer", "xpic"}, {"stress_update", "usl"}}},
    {{{"transfer", "xpic"}, {"stress_update", "usavg"}, {"k", 2.0}, {"basis", "quadratic"}}},
    {{{"transfer", "tpic"}}},
    {{{"transfer", "apic"}, {"basis", "quadratic"}}},
    {{{"transfer", "mls"}, {"basis", "cubic"}}}};

/// Of the total frame.
inline const std::vector<Variant> total_variants{
    {{{"frame", "total"}}},
    {{{"frame", "total"}, {"stress_update", "usf"}}},
    {{{"frame", "total"}, {"stress_update", "usl"}, {"time", "leapfrog"}}},
    {{{"frame", "total"}, {"stress_update", "usavg"}, {"basis", "ugimp"}}},
    {{{"frame", "total"}, {"time", "yoshida4"}, {"basis", "quadratic"}}},
    {{{"frame", "total"}, {"mass", "consistent"}, {"basis", "quadratic"}, {"placement", "gauss"}}},
    {{{"frame", "total"}, {"mass", "consistent"}, {"transfer", "pic"}}},
    {{{"frame", "total"}, {"mass", "consistent"}, {"transfer", "fmpm"}, {"stress_update", "usl"}}},
    {{{"frame", "total"}, {"mass", "fmpm"}, {"basis", "cubic"}}},
    {{{"frame", "total"}, {"mass", "fmpm"}, {"k", 1.0}, {"transfer", "fmpm"}, {"stress_update", "usl"}}},
    {{{"frame", "total"}, {"transfer", "xpic"}, {"stress_update", "usl"}}},
    {{{"frame", "total"}, {"transfer", "apic"}, {"basis", "cubic"}}},
    {{{"frame", "total"}, {"transfer", "mls"}, {"basis", "quadratic"}}},
    {{{"frame", "total"}, {"transfer", "tpic"}}},
    {{{"frame", "total"}, {"basis", "cpdi"}}},
    {{{"frame", "total"}, {"basis", "ddmp"}}},
    {{{"frame", "total"}, {"basis", "cpdi2"}, {"volume", "fixed"}}}};

/// One dimension: grids that move and reconstructed fields, all with conserved momentum.
inline const std::vector<Variant> line_variants{
    {{{"beyond_grid", "follow"}}},
    {{{"beyond_grid", "follow"}, {"mass", "consistent"}, {"basis", "quadratic"}}},
    {{{"strain_increment", "moved_mesh"}}},
    {{{"stress_from", "F"}}},
    {{{"reconstruction", "cubic_spline"}, {"conservative", true}, {"beyond_grid", "follow"}}},
    {{{"reconstruction", "tls"}, {"basis", "quadratic"}, {"conservative", true}, {"beyond_grid", "follow"}}},
    {{{"reconstruction", "mls"},
      {"degree", 2.0},
      {"conservative", true},
      {"mass", "consistent"},
      {"beyond_grid", "follow"}}},
    {{{"reconstruction", "impm"}, {"conservative", true}, {"stress_update", "usl"}, {"beyond_grid", "follow"}}}};

inline std::vector<Variant> joined(const std::vector<std::vector<Variant>>& lists) {
    std::vector<Variant> all;
    for (const auto& list : lists) all.insert(all.end(), list.begin(), list.end());
    return all;
}

}  // namespace ordo::solvers::mpm::test
