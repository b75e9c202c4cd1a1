#pragma once
// The studies that are broken, with fewer levels: as few as still prove the study's orders.
#include "tests/mutations/mutation.hpp"

namespace ordo::tests::shipped {

inline const Shipped mpm_bar{"wobbes_tielen_2015/vibrating_bar_fixed", {"cells=4,8,16,32"}};
inline const Shipped mpm_manufactured{"nguyen_2023/mpm_small", {"cells=8,16,32,64"}};
inline const Shipped mpm_total{"nguyen_2023/tlmpm_large", {"cells=16,32,64,128"}};
inline const Shipped mpm_gauss_2{"bspline_baselines/gauss_total_p1", {"cells=8,16,32,64"}};  ///< second order
inline const Shipped mpm_gauss_3{"bspline_baselines/gauss_total_p2", {"cells=8,16,32,64"}};  ///< third order
inline const Shipped mpm_bases{"steffen_2008b/periodic_bar", {"cells=28,60,84,172"}};
inline const Shipped mpm_flight{"capabilities/free_flight_dt", {"dt=0.04,0.02,0.01"}};
inline const Shipped fem_bar{"wobbes_tielen_2015/vibrating_bar_fem", {"cells=4,8,16,32,64"}};
inline const Shipped fem_column{"wobbes_tielen_2015/oedometer_fem_fine", {"cells=16,32,64,128,256"}};
inline const Shipped gas_tube{"walker_2012/sod", {"delta=1e-3,3e-4,1e-4,3e-5,1e-5", "cells=200,400,800,1600"}};
inline const Shipped gas_contact{"walker_2012/contact", {"delta=1e-3,1e-4,1e-5", "cells=100,200,400"}};
inline const Shipped gas_wall{"toro_2009/wall_reflection", {"delta=1e-3,3e-4,1e-4,3e-5", "cells=100,200,400,800,1600"}};
inline const Shipped elastic_line{"walker_2017/linear_1", {"delta=1e-3,3e-4,1e-4,3e-5", "cells=100,200,400,800"}};
inline const Shipped elastic_wall{"walker_2017/linear_wall", {"delta=1e-4,3e-5,1e-5"}};
inline const Shipped newton{"scalar_roots/newton", {"iterations=3,4,5,6"}};
inline const Shipped secant{"scalar_roots/secant", {"iterations=5,6,7,8,9"}};

}  // namespace ordo::tests::shipped
