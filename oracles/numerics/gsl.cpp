#include "oracles/numerics/gsl.hpp"

#include <gsl/gsl_errno.h>

namespace ordo::oracles {

void quiet_gsl() {
    static const auto before = gsl_set_error_handler_off();
    static_cast<void>(before);
}

}  // namespace ordo::oracles
