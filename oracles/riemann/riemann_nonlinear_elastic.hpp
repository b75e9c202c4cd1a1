#pragma once
// The Riemann problem of nonlinear elastic materials with heat.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "core/error.hpp"
#include "oracles/oracle.hpp"
#include "oracles/riemann/elastic_star.hpp"

namespace ordo::oracles {

/// Two uniform states of an elastic line that meet at x0 at t = 0.
///
///   rho_t + (rho v)_x = 0,   (rho v)_t + (rho v^2 - sigma)_x = 0,   e_t + ((e - sigma) v)_x = 0
///   rho = rho0 / lambda,   e = rho v^2 / 2 + C / lambda,   C = C_s(lambda) + c_v g(lambda) T,   sigma = C_lambda
///
/// Two acoustic waves, each a shock or a rarefaction, and a contact between them at v*. Where sigma_lambda > 0 and
/// sigma_lambda_lambda < 0, as for all materials here, there is one solution and it is this one; T is constant along
/// particle paths but for shocks, where it rises.
///
/// M        a material: elastic::Material<NeoHookean | Reciprocal | Logarithmic | your own>
/// x        position in space [m];   t   time [s];   at a jump the state on the right
/// accurate 1e-13 of the sound speeds and impedances of the data  (gate: tests/oracles/riemann)
/// source   [Toro2009], [Walker2017] for the equations; the material is a plug-in
template <class M>
class RiemannNonlinearElastic {
public:
    using State = elastic::State;

    /// Throws InputError where the law has no solution: vacuum that it does not describe, or numbers out of reach.
    RiemannNonlinearElastic(const M& material, const State& left, const State& right, double x0 = 0)
        : material_(material), x0_(x0), left_(left), right_(right), star_(elastic::star_state(material, left, right)) {
        star_left_ = {star_.left.stretch.to.lambda, star_.v, star_.left.T};
        star_right_ = {star_.right.stretch.to.lambda, star_.v, star_.right.T};
        const State states[] = {left_, star_left_, star_right_, right_};
        for (std::size_t i = 0; i < 4; ++i) rows_[i] = elastic::fields_of(material_, states[i]);
        refuse_what_is_not_a_number();
        if (star_.left.pressure_rise < 0) left_fan_.emplace(fan(star_.left, left_.T));
        if (star_.right.pressure_rise < 0) right_fan_.emplace(fan(star_.right, right_.T));
        speeds_[0] = left_.v - star_.left.speed;
        speeds_[1] = left_fan_ ? std::min(star_.v, left_.v + left_fan_->tail()) : speeds_[0];
        speeds_[2] = star_.v;
        speeds_[4] = right_.v + star_.right.speed;
        speeds_[3] = right_fan_ ? std::max(star_.v, right_.v - right_fan_->tail()) : speeds_[4];
    }

    const elastic::Star& star() const { return star_; }
    const State& star_left() const { return star_left_; }
    const State& star_right() const { return star_right_; }
    /// Speeds in space: left head and tail, contact, right tail and head. A shock's head is its tail.
    const std::array<double, 5>& speeds() const { return speeds_; }

    /// At equal stress the two stretches differ only where the temperatures do.
    bool has_contact() const { return star_left_.T != star_right_.T; }

    /// Velocity, density, stress, strain, temperature, energy, momentum, total energy: elastic::fields().
    elastic::Row fields(double x, double t) const {
        const auto passed = [&](std::size_t wave) { return !(x < x0_ + speeds_[wave] * t); };
        if (passed(2)) {
            if (!passed(3)) return rows_[2];
            return passed(4) ? rows_[3] : elastic::fields_of(material_, in_fan(right_side(), (x - x0_) / t));
        }
        if (passed(1)) return rows_[1];
        return passed(0) ? elastic::fields_of(material_, in_fan(left_side(), (x - x0_) / t)) : rows_[0];
    }

    /// Means over [a, b]: uniform pieces exactly, fans by Gauss-Legendre on pieces that leave no error.
    elastic::Row averages(double a, double b, double t) const {
        elastic::Row sum{};
        double from = a;
        for (std::size_t piece = 0; piece < 6 && from < b; ++piece) {
            const double to = piece < 5 ? std::clamp(x0_ + speeds_[piece] * t, from, b) : b;
            if (to > from) add_piece(sum, piece, from, to, t, (to - from) / (b - a));
            from = to;
        }
        return sum;
    }

    /// Where a field is discontinuous at time t: shocks and the contact.
    std::vector<double> jumps(double t) const {
        std::vector<double> places;
        if (star_.left.pressure_rise > 0) places.push_back(x0_ + speeds_[0] * t);
        if (has_contact()) places.push_back(x0_ + speeds_[2] * t);
        if (star_.right.pressure_rise > 0) places.push_back(x0_ + speeds_[4] * t);
        return places;
    }

    /// Shocks, fans and the contact at time t, from left to right.
    std::vector<Wave> waves(double t) const {
        std::vector<Wave> list;
        const auto add = [&](Wave::Kind kind, std::size_t left, std::size_t right) {
            list.push_back({kind, x0_ + speeds_[left] * t, x0_ + speeds_[right] * t});
        };
        if (star_.left.pressure_rise != 0) add(left_fan_ ? Wave::Kind::fan : Wave::Kind::shock, 0, 1);
        if (has_contact()) add(Wave::Kind::contact, 2, 2);
        if (star_.right.pressure_rise != 0) add(right_fan_ ? Wave::Kind::fan : Wave::Kind::shock, 3, 4);
        return list;
    }

private:
    elastic::Fan<M> fan(const elastic::Wave& wave, double T) const {
        return {material_, {wave.stretch.from, T}, wave.stretch.log};
    }

    /// A fan with the state that it starts from, and which way it looks: eta = sign (xi - v).
    struct Side {
        const elastic::Fan<M>& fan;
        const State& origin;
        double sign;
    };
    Side left_side() const { return {*left_fan_, left_, 1}; }
    Side right_side() const { return {*right_fan_, right_, -1}; }

    State in_fan(const Side& side, double xi) const {
        return in_fan(side, xi, side.fan.stretch(side.sign * (xi - side.origin.v)));
    }
    /// The same where h is known too.
    State in_fan(const Side& side, double xi, double h) const {
        const auto& [lambda, v, T] = side.origin;
        const elastic::Stretch s = elastic::stretched({elastic::stretch(lambda), T}, h);
        return {s.lambda, xi + side.sign * material_.sound_speed(s, material_.at(s, T)), T};
    }

    /// Adds share * mean over [from, to], which lies in one of: left state, fan, star, star, fan, right state.
    void add_piece(elastic::Row& sum, std::size_t piece, double from, double to, double t, double share) const {
        if (piece == 1) return add_fan(sum, left_side(), (from - x0_) / t, (to - x0_) / t, share);
        if (piece == 4) return add_fan(sum, right_side(), (from - x0_) / t, (to - x0_) / t, share);
        add(sum, rows_[piece < 3 ? piece / 2 : (piece + 1) / 2], share);
    }

    /// The same over speeds [from, to] in a fan, as an integral over h: there the fields are analytic, and panels half
    /// as wide as the strip in which they are leave no error to 15 nodes. The weights are made to sum to 1.
    void add_fan(elastic::Row& sum, const Side& side, double from, double to, double share) const {
        using Gauss = boost::math::quadrature::gauss<double, 15>;
        const double first = side.fan.stretch(side.sign * (from - side.origin.v));
        const double last = side.fan.stretch(side.sign * (to - side.origin.v));
        if (first == last) return add(sum, elastic::fields_of(material_, in_fan(side, from, first)), share);
        const int panels = std::max(1, static_cast<int>(std::ceil(std::abs(last - first) / half_strip())));
        const double half = 0.5 * (last - first) / panels;
        elastic::Row fan{};
        double weights = 0;
        const auto add_node = [&](double h, double node_weight) {
            const auto [eta, spread] = side.fan.at(h);
            const double xi = side.origin.v + side.sign * eta;
            weights += node_weight * spread;
            add(fan, elastic::fields_of(material_, in_fan(side, xi, h)), node_weight * spread);
        };
        for (int panel = 0; panel < panels; ++panel) {
            const double middle = first + (2 * panel + 1) * half;
            for (std::size_t i = 0; i < Gauss::abscissa().size(); ++i) {
                add_node(middle + half * Gauss::abscissa()[i], Gauss::weights()[i]);
                if (i > 0) add_node(middle - half * Gauss::abscissa()[i], Gauss::weights()[i]);
            }
        }
        add(sum, fan, share / weights);
    }

    double half_strip() const { return 0.5 * material_.analytic_strip(); }
    static void add(elastic::Row& sum, const elastic::Row& row, double weight) {
        for (std::size_t k = 0; k < row.size(); ++k) sum[k] += weight * row[k];
    }

    void refuse_what_is_not_a_number() const {
        bool sound = std::isfinite(star_.sigma) && std::isfinite(star_.left.speed) && std::isfinite(star_.right.speed);
        for (const auto& row : rows_) {
            for (const double value : row) sound = sound && std::isfinite(value);
        }
        if (!sound)
            throw InputError("oracle riemann_nonlinear_elastic",
                             "these states part or collide beyond the law's numbers: vacuum where the law has none, or "
                             "a stretch that no double holds; nearest: less difference between v_L and v_R");
    }

    M material_;
    double x0_;
    State left_;
    State right_;
    elastic::Star star_;
    State star_left_{};
    State star_right_{};
    std::optional<elastic::Fan<M>> left_fan_;
    std::optional<elastic::Fan<M>> right_fan_;
    std::array<double, 5> speeds_{};
    std::array<elastic::Row, 4> rows_{};  ///< left, left star, right star, right
};

Oracle riemann_nonlinear_elastic();

}  // namespace ordo::oracles
