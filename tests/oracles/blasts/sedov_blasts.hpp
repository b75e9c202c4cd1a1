#pragma once
// The blasts that every gate is applied to.
#include <string>
#include <vector>

#include "oracles/blasts/sedov.hpp"

namespace ordo::oracles::gate::point_blast {

using Geometry = Sedov::Geometry;

/// Standard, singular and vacuum blasts, both special exponents, stiff and soft gases, odd energies and densities.
inline std::vector<Sedov> blasts() {
    return {{Geometry::planar, 1.4, 0, 0.0673185, 1},
            {Geometry::planar, 2, 0, 3, 0.7},
            {Geometry::planar, 1.4, 0.6, 1, 1},
            {Geometry::planar, 1.2, 0.9, 2e-3, 5},
            {Geometry::planar, 5.0 / 3, -1.5, 40, 2},
            {Geometry::cylindrical, 1.4, 0, 0.311357, 1},
            {Geometry::cylindrical, 1.4, 1.2, 1, 3},
            {Geometry::cylindrical, 1.4, 5.0 / 3, 2.45749, 1},
            {Geometry::cylindrical, 1.4, 1.7, 2.67315, 1},
            {Geometry::cylindrical, 3, 0.2, 7e4, 1e-3},
            {Geometry::spherical, 1.4, 0, 0.851072, 1},
            {Geometry::spherical, 1.1, 0, 1, 1},
            {Geometry::spherical, 2, 0, 1e3, 8},
            {Geometry::spherical, 7, 0, 1, 1},
            {Geometry::spherical, 12, 0, 1, 1},
            {Geometry::spherical, 1.4, 1.8, 1, 1},
            {Geometry::spherical, 1.4, 7.0 / 3 - 1e-9, 4.9, 1},
            {Geometry::spherical, 1.4, 2.4, 5.4567, 1},
            {Geometry::spherical, 1.6, 2, 2, 2}};
}

inline std::string name_of(const Sedov& given) {
    return "j = " + std::to_string(static_cast<int>(given.geometry)) + ", gamma = " + std::to_string(given.gamma) +
           ", omega = " + std::to_string(given.omega);
}

}  // namespace ordo::oracles::gate::point_blast
