#include "solvers/godunov/active.hpp"

#include <algorithm>

namespace ordo::solvers::godunov {
namespace {

/// Whether cells i - 1 and i are not the same; so too for NaN.
bool differ(const Columns& q, std::size_t i) { return !(q[i - 1] == q[i]); }

}  // namespace

Active::Active(const Stretch& cells, std::size_t ghosts, std::size_t reach)
    : cells_(cells), ghosts_(ghosts), reach_(reach), stretches_{cells} {}

void Active::find(const Columns& q) {
    stretches_ = {{cells_.from, cells_.from}};
    for (std::size_t i = 1; i < q.size(); ++i) {
        if (differ(q, i)) append(stretches_, around(i, i));
    }
    append(stretches_, {cells_.to, cells_.to});
}

/// The cells that differences at faces `first` to `last` reach; face i lies between cells i - 1 and i.
Stretch Active::around(std::size_t first, std::size_t last) const {
    return {std::clamp(first, cells_.from + reach_, cells_.to) - reach_,
            std::clamp(last, cells_.from, cells_.to - reach_) + reach_};
}

void Active::follow(const Columns& q) {
    for (Stretch& s : stretches_) tighten(s, q);
    const auto gone = [&](const Stretch& s) { return s.size() == 0 && s.from != cells_.from && s.to != cells_.to; };
    std::erase_if(stretches_, gone);
    unite_near(stretches_);
}

void Active::tighten(Stretch& s, const Columns& q) const {
    if (s == cells_) return;
    const bool at_begin = s.from == cells_.from;
    const bool at_end = s.to == cells_.to;
    std::size_t low = at_begin ? 1 : s.from;
    std::size_t high = at_end ? cells_.to + ghosts_ - 1 : s.to;
    while (low <= high && !differ(q, low)) ++low;
    while (low < high && !differ(q, high)) --high;
    const std::size_t nowhere = at_end ? cells_.to : s.from;
    const Stretch wave = low > high ? Stretch{nowhere, nowhere} : around(low, high);
    s = {at_begin ? cells_.from : wave.from, at_end ? cells_.to : wave.to};
}

}  // namespace ordo::solvers::godunov
