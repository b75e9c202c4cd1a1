#include "oracles/numerics/ode.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <algorithm>
#include <cmath>
#include <new>

#include "oracles/numerics/gsl.hpp"

namespace ordo::oracles {

/// GSL's driver keeps a pointer to the system, so that both live at one address.
struct Ode::Engine {
    gsl_odeiv2_system system;
    gsl_odeiv2_driver* driver;
};

void Ode::Release::operator()(Engine* engine) const {
    if (engine->driver != nullptr) gsl_odeiv2_driver_free(engine->driver);
    delete engine;
}

Ode::Ode(const OdeSystem& system, double first_step, double tolerance)
    : engine_(new Engine{{system.slopes, nullptr, system.size, system.context}, nullptr}) {
    constexpr unsigned long most_steps = 20000;
    quiet_gsl();
    engine_->driver =
        gsl_odeiv2_driver_alloc_y_new(&engine_->system, gsl_odeiv2_step_rk8pd, first_step, tolerance, tolerance);
    if (engine_->driver == nullptr) throw std::bad_alloc();
    gsl_odeiv2_driver_set_nmax(engine_->driver, most_steps);
}

bool Ode::advance(double& x, double to, std::span<double> y) {
    if (y.size() != engine_->system.dimension || !std::isfinite(to)) return false;
    if (x != to && gsl_odeiv2_driver_apply(engine_->driver, &x, to, y.data()) != GSL_SUCCESS) return false;
    return std::ranges::all_of(y, [](double value) { return std::isfinite(value); });  // GSL steps through NaN
}

}  // namespace ordo::oracles
