#pragma once
// Root of an increasing function with known slope: GSL's Newton step, kept inside a bracket, without allocation.
#include <type_traits>

namespace ordo::oracles {

struct ValueAndSlope {
    double value;
    double slope;
};

/// A function of one variable with its slope, and its context. It must not throw.
struct FunctionWithSlope {
    ValueAndSlope (*at)(double x, void* context);
    void* context;
};

/// The root of f in [low, high], where f rises through zero; an end that is not finite is not asked.
/// Newton's step from `start`, halving where it would leave the bracket. Done when |f| <= noise, the level below which
/// f is round-off, or when a step is shorter than `last_step` of x, since the error left is of its square.
/// NaN where f is NaN.
double newton_root(FunctionWithSlope f, double low, double high, double start, double noise, double last_step = 1e-8);

template <class F>
double newton_root(F&& f, double low, double high, double start, double noise, double last_step = 1e-8) {
    const auto call = [](double x, void* context) { return (*static_cast<std::remove_reference_t<F>*>(context))(x); };
    return newton_root(FunctionWithSlope{call, const_cast<void*>(static_cast<const void*>(&f))}, low, high, start,
                       noise, last_step);
}

}  // namespace ordo::oracles
