#pragma once
// Roots of a function of one variable: GSL's bracketing and polishing solvers, owned by RAII.
#include <type_traits>

namespace ordo::oracles {

/// A function of one variable and its context, as GSL wants it. It must not throw.
struct Function {
    double (*value)(double x, void* context);
    void* context;
};

/// The root of f in [low, high] by GSL's Brent-Dekker, to the last bits of x. f must have opposite signs at the two
/// ends (a zero at an end is returned as it is). NaN where it has not, or where f is NaN.
double bracketed_root(Function f, double low, double high);

template <class F>
double bracketed_root(F&& f, double low, double high) {
    const auto call = [](double x, void* context) { return (*static_cast<std::remove_reference_t<F>*>(context))(x); };
    return bracketed_root(Function{call, const_cast<void*>(static_cast<const void*>(&f))}, low, high);
}

}  // namespace ordo::oracles
