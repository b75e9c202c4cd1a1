#pragma once
// Initial value problems of ordinary differential equations: GSL's Runge-Kutta Prince-Dormand (8, 9), owned by RAII.
#include <cstddef>
#include <memory>
#include <span>
#include <type_traits>

namespace ordo::oracles {

/// y' = f(x, y) for `size` unknowns and its context, as GSL wants it. It must not throw.
struct OdeSystem {
    int (*slopes)(double x, const double y[], double slopes[], void* context);
    void* context;
    std::size_t size;
};

/// Steps whose local error GSL keeps below `tolerance` (1 + |y|) for each unknown. The system must outlive it.
class Ode {
public:
    /// first_step has the sign of the direction of integration. Throws std::bad_alloc when memory is out.
    Ode(const OdeSystem& system, double first_step, double tolerance);

    /// From f(x, y, slopes) with y and slopes as pointers to `size` numbers.
    template <class F>
    requires std::is_invocable_v<F&, double, const double*, double*> Ode(F& f, std::size_t size, double first_step,
                                                                         double tolerance)
        : Ode(OdeSystem{[](double x, const double y[], double slopes[], void* context) {
                            (*static_cast<F*>(context))(x, y, slopes);
                            return 0;
                        },
                        &f, size},
              first_step, tolerance) {}

    /// Takes x and y to `to`. False, with x and y where it stopped, when the steps became too small or too many, or no
    /// number came out.
    bool advance(double& x, double to, std::span<double> y);

private:
    struct Engine;
    struct Release {
        void operator()(Engine* engine) const;
    };
    std::unique_ptr<Engine, Release> engine_;
};

}  // namespace ordo::oracles
