// THE list of exact solutions: one include and one line each.
#include "core/named.hpp"
#include "oracles/bars/bar_traction.hpp"
#include "oracles/bars/bar_vibration.hpp"
#include "oracles/bars/oedometer.hpp"
#include "oracles/bars/oedometer_static.hpp"
#include "oracles/blasts/noh.hpp"
#include "oracles/blasts/sedov.hpp"
#include "oracles/blasts/sedov_linear_elastic.hpp"
#include "oracles/blasts/sedov_nonlinear_elastic.hpp"
#include "oracles/elastic_constants.hpp"
#include "oracles/free_flight.hpp"
#include "oracles/lines/density_pulse.hpp"
#include "oracles/lines/elastic_end.hpp"
#include "oracles/lines/gas_piston.hpp"
#include "oracles/lines/shock_collision.hpp"
#include "oracles/manufactured/axis_aligned_mms.hpp"
#include "oracles/manufactured/bar_mms.hpp"
#include "oracles/manufactured/periodic_bar_mms.hpp"
#include "oracles/manufactured/ring_mms.hpp"
#include "oracles/manufactured/vortex_mms.hpp"
#include "oracles/plasticity/j2_rotating_stress.hpp"
#include "oracles/plasticity/j2_simple_shear.hpp"
#include "oracles/plasticity/j2_uniaxial_strain.hpp"
#include "oracles/riemann/riemann_gas.hpp"
#include "oracles/riemann/riemann_linear_elastic.hpp"
#include "oracles/riemann/riemann_nonlinear_elastic.hpp"
#include "oracles/scalar_root_convergence.hpp"

namespace ordo::oracles {

const std::vector<Oracle>& all_oracles() {
    static const std::vector<Oracle> list{
        bar_vibration(),
        bar_traction(),
        oedometer(),
        oedometer_static(),
        bar_mms(),
        periodic_bar_mms(),
        axis_aligned_mms(),
        ring_mms(),
        vortex_mms(),
        riemann_gas(),
        riemann_linear_elastic(),
        riemann_nonlinear_elastic(),
        shock_collision(),
        gas_piston(),
        elastic_end(),
        density_pulse(),
        sedov(),
        sedov_nonlinear_elastic(),
        sedov_linear_elastic(),
        noh(),
        j2_uniaxial_strain(),
        j2_simple_shear(),
        j2_rotating_stress(),
        elastic_constants_oracle(),
        free_flight(),
        scalar_root_convergence(),
    };
    return list;
}

const Oracle& oracle_named(const std::string& name, const std::string& where) {
    return named(all_oracles(), name, where, "there is no exact solution");
}

}  // namespace ordo::oracles
