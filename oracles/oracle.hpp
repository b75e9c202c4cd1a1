#pragma once
// What an exact solution is, for everyone who asks by name. Each one is also a plain struct in its own header.
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/field.hpp"
#include "core/parameter.hpp"

namespace ordo::oracles {

/// Which positions an exact solution is a function of: those in the undeformed body, or those in space now.
enum class Coordinates { material, spatial };

/// An exact solution with its numbers filled in.
struct Exact {
    /// One field at one point: x has dim entries [m], t is the time [s], value receives the field's components.
    using Evaluate = std::function<void(std::span<const double> x, double t, std::span<double> value)>;
    struct Entry {
        FieldInfo field;
        Evaluate evaluate;
    };
    int dim = 1;
    Coordinates coordinates = Coordinates::material;
    std::vector<double> lower;  ///< box in which it holds, dim entries [m]
    std::vector<double> upper;
    std::vector<Entry> fields;
    std::function<std::vector<double>(double t)> jumps;  ///< where a field is discontinuous at time t (1D) [m]

    const Entry* find(const std::string& field) const;  ///< nullptr when it has no such field
};

/// One line of the catalogue: name, declarations, and how to fill in the numbers.
struct Oracle {
    std::string name;
    std::string about;
    std::vector<std::string> source;  ///< keys of docs/references.bib
    std::vector<Parameter> parameters;
    std::vector<FieldInfo> fields;
    std::string smoothness;  ///< "analytic", or what jumps where
    std::string accuracy;    ///< stated error of every value, with its scale
    std::function<Exact(const Values&)> bind;
};

/// All exact solutions, one line each in catalogue.cpp.
const std::vector<Oracle>& all_oracles();

/// The exact solution of that name. Throws InputError with the nearest name.
const Oracle& oracle_named(const std::string& name, const std::string& where);

}  // namespace ordo::oracles
