#pragma once
// One event after the other.
#include <cmath>
#include <string>

#include "core/text.hpp"
#include "solvers/rrm/line.hpp"

namespace ordo::solvers::rrm {

template <class M>
Line<M>::Line(const M& medium, const LineScene& scene, const Options& options)
    : medium_(medium),
      options_(options),
      ends_(scene.ends),
      bounds_{scene.edges.front(), scene.edges.back()},
      length_(scene.edges.back() - scene.edges.front()) {
    for (std::size_t k = 0; k < per_allowed_.size(); ++k) {
        per_allowed_[k] = 1 / options.allowed[k];
        allowed_square_[k] = options.allowed[k] * options.allowed[k];
    }
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
        const Front& f = front(id);
        if (f.t_chop <= f.t_vanish) chop_out(id, f.t_chop);
        else use_up(f.right, f.t_vanish);
    }
    if (std::isnan(schedule_.first_time())) throw Diverged("the time of an event is not a number");
}

}  // namespace ordo::solvers::rrm
