// How a sweep is cut into sections, who works on them, and what they have told.
#include <algorithm>

#include "solvers/mpm/fast/fast.hpp"

namespace ordo::solvers::mpm::fast {

/// Sections by the blocks alone, whatever the threads. Each goes on until the nodes of the one before it lie behind.
template <int dim>
void FastMpm<dim>::cut() {
    for (auto& section : sections_) slots_.stock(section.pool, 0);
    const auto& blocks = slots_.blocks();
    const long count = static_cast<long>(order_.size());
    const auto block = [&](long k) { return order_[static_cast<std::size_t>(k)]; };
    const auto node = [&](long k) { return blocks[static_cast<std::size_t>(block(k))].node; };
    long reach = 2 * lanes;
    for (int axis = 1; axis < dim; ++axis) reach += grid_.degree * slots_.row_of_nodes(axis);
    const long wanted = count / section_;
    const long length = wanted < fewest ? count : (count + wanted - 1) / wanted;
    std::size_t n = 0;
    for (long begin = 0, behind = 0; begin < count || n == 0; ++n) {
        long end = std::min(begin + length, count);
        while (end < count && node(end) < behind) ++end;
        if (count - end < length / 2) end = count;
        behind = begin < end ? node(end - 1) + reach : 0;
        if (n == sections_.size()) sections_.emplace_back();
        Section<dim>& section = sections_[n];
        section.begin = begin;
        section.end = begin = end;
    }
    sections_.resize(n);
    for (auto& section : sections_) {
        section.first = n == 1 ? 0 : block(section.begin);
        section.last = n == 1 ? static_cast<int>(blocks.size()) - 1 : block(section.end - 1);
    }
    if (n > 1 && !team_ && options_.threads > 1) team_ = std::make_shared<Team>(options_.threads);
}

/// What a section has told, after those whom it could not seat are seated.
template <int dim>
void FastMpm<dim>::hear(Section<dim>& section, Pass pass, Told<dim>& all) {
    Told<dim>& told = section.told;
    for (const auto& who : section.later) seat(who, pass, told, slots_.pool());
    section.later.clear();
    on_face_ = on_face_ || told.on_face;
    dirty_ = dirty_ || told.dirty;
    missed_ = missed_ || told.missed;
    lost_ = std::min(lost_, told.lost);
    crossings_ += told.crossings;
    load_ += told.load;
    all.finite = all.finite && told.finite;
    all.inverted = std::min(all.inverted, told.inverted);
    told = {};
}

template class FastMpm<1>;
template class FastMpm<2>;
template class FastMpm<3>;

}  // namespace ordo::solvers::mpm::fast
