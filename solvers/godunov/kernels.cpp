// The loops over cells and faces. What a run has chosen is a type by then: a loop makes no call, and allocates nothing.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "solvers/godunov/godunov.hpp"
#include "solvers/instruction_set.hpp"

namespace ordo::solvers::godunov {
namespace {

/// In which a cell is linear, besides density and velocity.
template <class M>
double third_of(const Flow& f) {
    if constexpr (M::has_temperature) return f.T;
    else return f.p;
}

template <class M>
Contents contents(const M& medium, double rho, double v, double third) {
    if constexpr (M::has_temperature) return medium.contents(medium.rho0 / rho, v, third);
    else return medium.contents(rho, v, third);
}

/// flux(q) where the third variable is known already.
template <class M>
Contents flux_of(const M& medium, const Contents& q, double v, double third) {
    if constexpr (M::has_temperature) return flux(q, medium.flow(q));
    else return flux(q, {q.mass, v, third, 0, 0});
}

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// `value`, or NaN where one of two numbers is not positive. A count of such places would keep the loop from running
/// several at a time.
double where_positive(double a, double b, double value) { return (a > 0) & (b > 0) ? value : nan; }

/// loop(), made of the widest instructions that the machine has. All that a loop calls is inlined here, so that no
/// function made of them is left for others to call. Contraction is off and every operation rounds by itself: the bits
/// are the same with each.
template <class Loop>
[[gnu::flatten]] void baseline(Loop loop) {
    loop();
}
template <class Loop>
[[gnu::flatten, gnu::target("avx2")]] void avx2(Loop loop) {
    loop();
}
template <class Loop>
[[gnu::flatten, gnu::target("avx512f,avx512dq,prefer-vector-width=512")]] void avx512(Loop loop) {
    loop();
}
template <class Loop>
void run(Loop loop) {
    static const InstructionSet set = instruction_set();
    switch (set) {
        case InstructionSet::avx512: return avx512(loop);
        case InstructionSet::avx2: return avx2(loop);
        case InstructionSet::baseline: return baseline(loop);
    }
}

template <class M>
void measured(const M medium, Stretch stretch, Cells& cells) {
#pragma GCC ivdep
    for (std::size_t i = stretch.from; i < stretch.to; ++i) {
        const Flow f = medium.flow(cells.q[i]);
        cells.v[i] = f.v;
        cells.third[i] = third_of<M>(f);
        cells.speed[i] = where_positive(f.rho, f.a, std::abs(f.v) + f.a);
    }
}

template <class M, class L>
void reconstructed(const M medium, L, double step_by_h, Stretch stretch, Cells& cells) {
    const double ahead = 0.5 * step_by_h;
    const auto& rho = cells.q.mass;
    const auto& v = cells.v;
    const auto& third = cells.third;
#pragma GCC ivdep
    for (std::size_t i = stretch.from; i < stretch.to; ++i) {
        const double half_rho = 0.5 * L::rise(rho[i] - rho[i - 1], rho[i + 1] - rho[i]);
        const double half_v = 0.5 * L::rise(v[i] - v[i - 1], v[i + 1] - v[i]);
        const double half_third = 0.5 * L::rise(third[i] - third[i - 1], third[i + 1] - third[i]);
        const Contents left = contents(medium, rho[i] - half_rho, v[i] - half_v, third[i] - half_third);
        const Contents right = contents(medium, rho[i] + half_rho, v[i] + half_v, third[i] + half_third);
        const Contents rise = ahead * (flux_of(medium, left, v[i] - half_v, third[i] - half_third) -
                                       flux_of(medium, right, v[i] + half_v, third[i] + half_third));
        cells.left.set(i, left + rise);
        cells.right.set(i, right + rise);
    }
}

template <class M, class F, class S>
void passed(const M medium, F, S, const Columns& before, const Columns& behind, Stretch faces, Columns& through) {
#pragma GCC ivdep
    for (std::size_t i = faces.from; i < faces.to; ++i) {
        const Side l{before[i], medium.flow(before[i])};
        const Side r{behind[i + 1], medium.flow(behind[i + 1])};
        Contents q = F::through(l, r, S::between(medium, l, r));
        q.mass = where_positive(l.f.rho, l.f.a, where_positive(r.f.rho, r.f.a, q.mass));
        through.set(i, q);
    }
}

/// The largest of several numbers and 0, and their sum, which is finite only where each of them is.
struct Digest {
    double largest = 0;
    double sum = 0;
};

Digest digest(std::span<const double> values) {
    std::array<Digest, 8> lanes{};  // one alone would make the loop wait for itself
    const auto take = [](Digest& lane, double value) {
        lane.largest = std::max(lane.largest, value);
        lane.sum += value;
    };
    std::size_t i = 0;
    for (; i + lanes.size() <= values.size(); i += lanes.size()) {
        for (std::size_t k = 0; k < lanes.size(); ++k) take(lanes[k], values[i + k]);
    }
    for (; i < values.size(); ++i) take(lanes[0], values[i]);
    Digest all;
    for (const Digest& lane : lanes) all = {std::max(all.largest, lane.largest), all.sum + lane.sum};
    return all;
}

}  // namespace

void measure_cells(const Medium& medium, Stretch cells, Cells& row) {
    std::visit([&](const auto& kind) { run([&] { measured(kind, cells, row); }); }, medium);
}

double fastest_of(std::span<const double> speeds) {
    const Digest all = digest(speeds);
    return std::isfinite(all.sum) ? all.largest : nan;
}

void reconstruct(const Medium& medium, const Limiter& limiter, double step_by_h, Stretch cells, Cells& row) {
    std::visit([&](const auto& kind, auto limit) { run([&] { reconstructed(kind, limit, step_by_h, cells, row); }); },
               medium, limiter);
}

void repair(const Medium& medium, Stretch cells, Cells& row) {
    const auto put_right = [&](const auto& kind) {
        for (std::size_t i = cells.from; i < cells.to; ++i) {
            if (kind.flow(row.left[i]).physical() && kind.flow(row.right[i]).physical()) continue;
            row.left.set(i, row.q[i]);
            row.right.set(i, row.q[i]);
        }
    };
    std::visit(put_right, medium);
}

bool pass_faces(const Medium& medium, const Options& options, const Columns& before, const Columns& behind,
                Stretch faces, Columns& through) {
    const auto pass = [&]<class M, class S>(const M& kind, auto solver, S estimate) {
        if constexpr (Estimates<S, M>) run([&] { passed(kind, solver, estimate, before, behind, faces, through); });
        else throw std::logic_error("this estimate of wave speeds is not for that medium");
    };
    std::visit(pass, medium, options.riemann, options.speeds);
    return std::isfinite(digest(std::span(through.mass).subspan(faces.from, faces.size())).sum);
}

}  // namespace ordo::solvers::godunov
