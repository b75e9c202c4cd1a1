#include "oracles/lines/shock_collision.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "core/text.hpp"
#include "oracles/riemann/gas_record.hpp"

namespace ordo::oracles {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The waves of a Riemann problem, but for a contact between equal gases and the vacuum.
std::vector<GasWave> true_waves(const RiemannGas& problem) {
    auto list = problem.waves();
    std::erase_if(list, [&](const GasWave& wave) {
        return wave.kind == GasWave::Kind::vacuum ||
               (wave.kind == GasWave::Kind::contact && problem.star().left.rho == problem.star().right.rho);
    });
    return list;
}

bool is_shock(const GasWave& wave) { return wave.kind == GasWave::Kind::shock; }

/// How long the gap between two places lasts that move with the speeds a (left) and b (right).
double closing_time(double gap, double a, double b) { return a > b ? gap / (a - b) : infinity; }

const Gas& ordered(const Gas& gas, double x_L, double x_R) {
    if (!(x_L < x_R))
        throw InputError("oracle shock_collision", "x_R = " + shortest(x_R) + ", but must be > x_L = " + shortest(x_L) +
                                                       "; nearest: " + shortest(x_L + 1));
    return gas;
}

}  // namespace

ShockCollision::ShockCollision(const Gas& left, const Gas& middle, const Gas& right, double x_L, double x_R)
    : x_L_(x_L),
      x_R_(x_R),
      gamma_(middle.gamma),
      left_(ordered(left, x_L, x_R), middle, x_L),
      right_(middle, right, x_R) {
    const auto l = true_waves(left_), r = true_waves(right_);
    if (l.empty()) return;
    inner_ = l.back().head;
    if (r.empty()) return;
    t_c_ = t_end_ = closing_time(x_R - x_L, inner_, r.front().head);
    if (t_c_ == infinity) return;
    x_c_ = left_.position(inner_, t_c_);
    if (is_shock(l.back()) && is_shock(r.front())) let_shocks_meet(l, r);
}

void ShockCollision::let_shocks_meet(const std::vector<GasWave>& l, const std::vector<GasWave>& r) {
    const auto behind = [&](const GasSide::Behind& side, const GasStar& star) {
        return Gas{.rho = side.rho, .v = star.v, .p = star.p, .gamma = gamma_};
    };
    after_.emplace(behind(left_.star().right, left_.star()), behind(right_.star().left, right_.star()), x_c_);
    const auto between = true_waves(*after_);
    outer_ = {between.front().head, between.back().head};
    t_end_ = infinity;
    if (l.size() > 1) {
        const GasWave& next = l[l.size() - 2];
        const double gap = x_c_ - left_.position(next.tail, t_c_);
        t_end_ = t_c_ + closing_time(gap, next.tail, outer_.left);
    }
    if (r.size() > 1) {
        const GasWave& next = r[1];
        const double gap = right_.position(next.tail, t_c_) - x_c_;
        t_end_ = std::min(t_end_, t_c_ + closing_time(gap, outer_.right, next.tail));
    }
}

ShockCollision::Borders ShockCollision::borders(double t) const {
    if (met(t)) return {after_->position(outer_.left, t - t_c_), after_->position(outer_.right, t - t_c_)};
    const double border = inner_ == -infinity ? inner_ : left_.position(inner_, t);
    return {border, border};
}

GasFields ShockCollision::at(double x, double t) const {
    const auto [left, right] = borders(t);
    if (x < left) return left_.at(x, t);
    return x < right ? after_->at(x, t - t_c_) : right_.at(x, t);
}

GasFields ShockCollision::mean(double a, double b, double t) const {
    const auto [left, right] = borders(t);
    if (!(a < b)) return at(a, t);
    if (b <= left) return left_.mean(a, b, t);
    if (a >= right) return right_.mean(a, b, t);
    GasFields sum{};
    const auto add = [&](const RiemannGas& problem, double from, double to, double time) {
        if (from < to) sum.add((to - from) / (b - a), problem.mean(from, to, time));
    };
    add(left_, a, left, t);
    if (met(t)) add(*after_, std::max(a, left), std::min(b, right), t - t_c_);
    add(right_, std::max(a, right), b, t);
    return sum;
}

std::vector<Wave> ShockCollision::waves(double t) const {
    auto l = true_waves(left_), r = true_waves(right_);
    std::vector<Wave> list;
    if (met(t)) {
        l.pop_back();
        r.erase(r.begin());
    }
    for (const auto& wave : l) list.push_back(wave_at(wave, x_L_, t));
    if (met(t)) {
        for (const auto& wave : true_waves(*after_)) list.push_back(wave_at(wave, x_c_, t - t_c_));
    }
    for (const auto& wave : r) list.push_back(wave_at(wave, x_R_, t));
    return list;
}

std::vector<double> ShockCollision::jumps(double t) const {
    auto l = left_.jumps(t), r = right_.jumps(t);
    if (met(t)) {
        l.pop_back();
        r.erase(r.begin());
        const auto between = after_->jumps(t - t_c_);
        l.insert(l.end(), between.begin(), between.end());
    }
    l.insert(l.end(), r.begin(), r.end());
    return l;
}

}  // namespace ordo::oracles
