#pragma once
// What an exact solution is, for everyone who asks by name. Each one is also a plain struct in its own header.
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "core/field.hpp"
#include "core/parameter.hpp"

namespace ordo::oracles {

/// Which positions an exact solution is a function of: those in the undeformed body, or those in space now.
enum class Coordinates { material, spatial };

struct Constant;
using Constants = std::vector<Constant>;

/// One thing that does not depend on x: a number, a word, or a list of records such as the waves of a Riemann problem.
struct Constant {
    std::string name;
    std::variant<double, std::string, std::vector<Constants>> value;
};

/// A wave of an exact solution on a line: shocks and contacts are at one place, a fan lies between its two edges.
struct Wave {
    enum class Kind { shock, contact, fan };
    Kind kind = Kind::shock;
    double left = 0;   ///< [m]
    double right = 0;  ///< [m]
};

/// A place where a field of an exact solution on a line is not smooth, by what carries it.
struct Feature {
    enum class Kind {
        shock,       ///< its characteristics run into it, so that it stays steep
        contact,     ///< matter of two kinds side by side: it moves with them
        linear,      ///< a wave of a linear law; nothing steepens it
        fan_corner,  ///< the edge of a fan
        singular     ///< a power of the distance, or the edge of a vacuum
    };
    Kind kind = Kind::shock;
    double x = 0;        ///< [m]
    int derivative = 0;  ///< the lowest one that jumps: 0 the field itself, 1 its slope (a kink), 2 its curvature

    bool operator==(const Feature&) const = default;
};

/// An exact solution with its numbers filled in.
struct Exact {
    /// All fields at n points in one call: x holds n x dim coordinates [m], t is the time [s], values receives
    /// n x width() numbers, a row a point, the fields' components in the order of `fields`. NaN where a field has no
    /// value, as velocity in a vacuum. Throws InputError for a point of the box that is not of the body.
    using Sample = std::function<void(std::span<const double> x, double t, std::span<double> values)>;
    using Features = std::function<std::vector<Feature>(const std::string& field, double t)>;

    int dim = 1;
    Coordinates coordinates = Coordinates::material;
    std::string abscissa{};     ///< what x is where it is no position: "iteration"
    std::vector<double> lower;  ///< box in which it holds, dim entries [m]
    std::vector<double> upper;
    Range times = at_least(0);  ///< when it holds [s]
    std::vector<FieldInfo> fields;
    Sample sample;
    Sample averages{};  ///< means over n cells in 1D; x holds their n + 1 rising edges. Empty when it offers none
    std::function<std::vector<double>(double t)> jumps;  ///< where a field is discontinuous at time t (1D) [m]
    std::function<std::vector<Wave>(double t)>
        waves{};  ///< where its waves are at t, from left to right; empty: unknown
    /// What is not smooth in a field at t > 0; all else is analytic in x. Empty where it is not told.
    Features features{};
    std::function<Constants(std::optional<double> t)> constants{};  ///< empty when there are none

    std::size_t width() const;                                          ///< numbers a point
    std::optional<std::size_t> offset(const std::string& field) const;  ///< of its first component in a row

    /// Throws InputError, opened by `where`, when t is outside `times` or one of the n x dim coordinates outside the
    /// box.
    void check(std::span<const double> x, double t, const std::string& where) const;
};

/// A Sample from a function f(x, t, values) of one point: x has dim entries, values has width.
template <class F>
Exact::Sample pointwise(std::size_t dim, std::size_t width, F f) {
    return [=](std::span<const double> x, double t, std::span<double> values) {
        for (std::size_t i = 0; i * dim < x.size(); ++i)
            f(x.subspan(i * dim, dim), t, values.subspan(i * width, width));
    };
}

/// A Sample in one dimension from a function f(x, t) that returns the fields of one point as a std::array.
template <class F>
Exact::Sample along_a_line(F f) {
    return [=](std::span<const double> x, double t, std::span<double> values) {
        auto out = values.begin();
        for (const double place : x) {
            for (const double value : f(place, t)) *out++ = value;
        }
    };
}

/// Averages from a function f(a, b, t) that returns the fields' means over [a, b] as a std::array.
template <class F>
Exact::Sample over_cells(F f) {
    return [=](std::span<const double> edges, double t, std::span<double> values) {
        auto out = values.begin();
        for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
            for (const double value : f(edges[i], edges[i + 1], t)) *out++ = value;
        }
    };
}

/// `jumps` of a solution that has none.
inline std::vector<double> no_jumps(double) { return {}; }

/// `features` of a solution that is analytic in x.
inline std::vector<Feature> no_features(const std::string&, double) { return {}; }

/// One line of the catalogue: name, declarations, and how to fill in the numbers.
struct Oracle {
    std::string name;
    std::string about;
    std::vector<std::string> source;  ///< keys of docs/references.bib
    std::string explanation;          ///< lines: equations, formula, conventions, what is refused, constants
    std::string example;              ///< arguments of a working call of `ordo oracle`
    std::vector<Parameter> parameters;
    std::vector<FieldInfo> fields;
    std::string smoothness;                    ///< "analytic", or what jumps where
    std::string accuracy;                      ///< stated error of every value, with its scale
    std::function<Exact(const Values&)> bind;  ///< throws InputError where theory has no solution
};

/// All exact solutions, one line each in catalogue.cpp.
const std::vector<Oracle>& all_oracles();

/// The exact solution of that name. Throws InputError with the nearest name.
const Oracle& oracle_named(const std::string& name, const std::string& where);

}  // namespace ordo::oracles
