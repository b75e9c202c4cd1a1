// The line, for each medium there is.
#include "solvers/rrm/line.hpp"

#include "solvers/rrm/chop_out.hpp"
#include "solvers/rrm/events.hpp"
#include "solvers/rrm/find.hpp"
#include "solvers/rrm/flatten.hpp"
#include "solvers/rrm/put_back.hpp"
#include "solvers/rrm/show.hpp"
#include "solvers/rrm/storage.hpp"
#include "solvers/rrm/waves.hpp"

namespace ordo::solvers::rrm {

template class Line<IdealGas>;
template class Line<ElasticMedium<HookeEnergy>>;
template class Line<ElasticMedium<RubberEnergy>>;
template class Line<ElasticMedium<ReciprocalEnergy>>;
template class Line<ElasticMedium<LogarithmicEnergy>>;

}  // namespace ordo::solvers::rrm
