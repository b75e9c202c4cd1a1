#include "solvers/rrm/line.hpp"

#include "solvers/rrm/chop_out.hpp"
#include "solvers/rrm/find.hpp"
#include "solvers/rrm/flatten.hpp"
#include "solvers/rrm/put_back.hpp"
#include "solvers/rrm/show.hpp"
#include "solvers/rrm/storage.hpp"
#include "solvers/rrm/waves.hpp"

namespace ordo::solvers::rrm {

template <class M>
Line<M>::Line(const M& medium, const LineScene& scene, const Options& options)
    : medium_(medium),
      options_(options),
      ends_(scene.ends),
      bounds_{scene.edges.front(), scene.edges.back()},
      length_(scene.edges.back() - scene.edges.front()) {
    fill(scene);
}

template <class M>
void Line<M>::advance_to(double t, const Interrupt& interrupt) {
    constexpr long between_questions = 4096;
    while (schedule_.first_time() <= t) {
        if (events_++ % between_questions == 0 && interrupt()) throw Interrupted("interrupted");
        if (static_cast<double>(events_) > options_.most_events)
            throw Diverged("more than " + shortest(options_.most_events) +
                           " events by t = " + shortest(schedule_.first_time()) + " s; allow more, or a larger delta");
        const int id = schedule_.first();
        const std::size_t unused = unused_fronts_.size();
        const Front& f = front(id);
        if (f.t_chop <= f.t_vanish) chop_out(id, f.t_chop);
        else use_up(f.right, f.t_vanish);
        for (std::size_t i = unused; i < unused_fronts_.size(); ++i) schedule_.set(unused_fronts_[i], Schedule::never);
    }
}

template class Line<IdealGas>;
template class Line<ElasticMedium<HookeEnergy>>;
template class Line<ElasticMedium<RubberEnergy>>;
template class Line<ElasticMedium<ReciprocalEnergy>>;
template class Line<ElasticMedium<LogarithmicEnergy>>;

}  // namespace ordo::solvers::rrm
