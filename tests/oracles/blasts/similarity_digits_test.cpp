// The textbook's products of powers of V, whose exponents and arguments are singular at the special exponents, in 50
// digits: what is lost there in doubles leaves 20 to 30.
#include <array>
#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <vector>

#include "oracles/blasts/energy_integrals.hpp"
#include "tests/catch.hpp"

using namespace ordo::oracles;

namespace {

using Digits = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;

/// [KammTimmes2007], with the functions of x_i = 1 + (V - V2) * slope_i.
class Textbook {
public:
    Textbook(int j, double gamma_given, double omega_given) : j_(j), gamma_(gamma_given), omega_(omega_given) {
        // On a special or singular pair itself: beside it, by less than any digit that is looked at.
        const auto B = [&] { return Digits(j_ * (2 - gamma_) - omega_); };
        const auto D = [&] { return Digits(2 * (gamma_ - 1) + j_ - gamma_ * omega_); };
        if (B() == 0 || D() == 0 || B() + D() == 0) omega_ += Digits("1e-24");
        n_ = j + 2 - omega_;
        V0_ = 2 / (n_ * gamma_);
        V2_ = 4 / (n_ * (gamma_ + 1));
        const Digits Vs = 2 / (j_ * (gamma_ - 1) + 2);
        end_ = V2_ < Vs ? V0_ : Digits(2 / n_);
        const Digits al0 = 2 / n_, al2 = -(gamma_ - 1) / D();
        const Digits al1 = n_ * gamma_ / (2 + j_ * (gamma_ - 1)) * (2 * B() / (gamma_ * n_ * n_) - al2);
        const Digits al3 = (j_ - omega_) / D(), al4 = n_ * (j_ - omega_) / B() * al1;
        const Digits al5 = (omega_ * (gamma_ + 1) - 2 * j_) / B();
        slopes_ = {1 / V2_, 1 / (V2_ - V0_), 1 / (V2_ - Vs), 1 / (V2_ - 2 / n_)};
        lambda_ = {-al0, -al2, -al1, 0};
        g_ = {al0 * omega_, al3 + al2 * omega_, al4 + al1 * omega_, al5};
        h_ = {al0 * j_, 0, al4 + al1 * (omega_ - 2), 1 + al5};
    }

    struct Point {
        Digits lambda, f, g, h, lambda_slope;
    };
    /// At V2 + share (end - V2).
    Point at(const Digits& share) const {
        const Digits step = share * (end_ - V2_);
        Digits log_lambda = 0, log_g = 0, log_h = 0, slope = 0, x1 = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            // Near the end, where share is 1 to all digits, x_i is the end's own factor times 1 - share.
            const Digits x = 1 + slopes_[i] * step;
            if (i == 0) x1 = x;
            const Digits log_x = log(x);
            log_lambda += lambda_[i] * log_x;
            log_g += g_[i] * log_x;
            log_h += h_[i] * log_x;
            slope += lambda_[i] * slopes_[i] / x;
        }
        const Digits lambda = exp(log_lambda);
        return {lambda, x1 * lambda, exp(log_g), exp(log_h), lambda * slope * (end_ - V2_)};
    }

    /// (J1 + 2 J2 / (gamma - 1)) (gamma^2 - 1) n^2 / 16, by s in share = 1 - s^12: that takes the singularity from the
    /// end. The tolerance is of the last refinement's change, which squares what is left.
    Digits energy() const {
        boost::math::quadrature::tanh_sinh<Digits> quadrature(9);
        const auto shell = [&](const Digits& s) -> Digits {
            const Digits left = pow(s, 11);
            if (left < Digits("1e-40")) return 0;
            const Point p = at(1 - left * s);
            return -(p.g * p.f * p.f + p.h) * pow(p.lambda, j_ - 1) * p.lambda_slope * 12 * left;
        };
        return quadrature.integrate(shell, Digits(0), Digits(1), Digits("1e-9"));
    }
    /// What alpha is of it.
    Digits alpha() const {
        const Digits share = 8 / ((gamma_ * gamma_ - 1) * n_ * n_) * energy();
        return j_ == 1 ? share : 2 * (j_ - 1) * boost::math::constants::pi<Digits>() * share;
    }

private:
    int j_;
    Digits gamma_, omega_, n_, V0_, V2_, end_;
    std::array<Digits, 4> slopes_, lambda_, g_, h_;
};

struct Case {
    int j;
    double gamma, omega;
};

/// The three kinds; on each special exponent, on the singular one, and from 1e-15 to 1e-6 beside them.
std::vector<Case> cases() {
    std::vector<Case> list{{1, 1.4, 0},    {2, 1.4, 0},   {3, 1.4, 0},        {3, 1.1, 0},      {3, 3, 0},
                           {2, 1.4, 1.7},  {3, 1.4, 2.4}, {3, 20, 0},         {1, 1.4, -4},     {2, 2.5, 1.1},
                           {3, 1.6, 2.05}, {3, 1.4, 2.9}, {1, 5.0 / 3, 0.97}, {3, 1.01, 1.234}, {2, 100, 0.02}};
    for (const Case& special :
         {Case{1, 1.4, 0.6}, Case{2, 1.4, 1.2}, Case{3, 1.4, 1.8}, Case{3, 1.4, 19.0 / 7}, Case{1, 2, 0}, Case{2, 2, 0},
          Case{3, 2, 0}, Case{3, 5.0 / 3, 1}, Case{2, 1.4, 5.0 / 3}, Case{3, 1.4, 7.0 / 3}, Case{3, 7, 0}}) {
        for (const double offset : {0.0, 1e-15, -1e-15, 1e-12, -1e-12, -3e-10, 1e-9, 2e-6, -2e-6})
            list.push_back({special.j, special.gamma, special.omega + offset});
    }
    return list;
}

}  // namespace

TEST_CASE("sedov: profiles agree with fifty digits of the textbook's, special exponents or not", "[gate]") {
    for (const auto& c : cases()) {
        const Textbook textbook(c.j, c.gamma, c.omega);
        const Similarity profiles(c.j, c.gamma, c.omega);
        for (const char* left :
             {"0.999", "0.9", "0.5", "0.2", "3e-2", "1e-3", "1e-5", "1e-9", "1e-14", "1e-20", "1e-28"}) {
            const auto exact = textbook.at(1 - Digits(left));
            const double lambda = static_cast<double>(exact.lambda);
            // Down to 1e-3; and not so near a core that lambda as a double no longer says how near.
            if (lambda < 1e-3 || lambda < profiles.core() * (1 + 1e-3)) break;
            const auto p = profiles.profile(lambda);
            const auto off = [](double found, const Digits& wanted) {
                return std::abs(static_cast<double>(found / wanted - 1));
            };
            INFO("j = " << c.j << ", gamma = " << c.gamma << ", omega = " << c.omega << ", lambda = " << lambda);
            const double most = std::max({off(p.velocity, exact.f), off(p.density, exact.g), off(p.pressure, exact.h),
                                          off(p.energy, exact.h / exact.g)});
            CHECK(most <= 4e-12);  // next to a core; elsewhere 1e-13
        }
    }
}

TEST_CASE("sedov: alpha agrees with fifty digits of the textbook's integrals", "[gate]") {
    for (const auto& c : {Case{3, 2, 0}, Case{1, 1.4, 0.6 + 1e-12}, Case{3, 1.4, 19.0 / 7 - 1e-12}}) {
        const auto found = energy_integrals(Similarity(c.j, c.gamma, c.omega), c.j, c.gamma, c.omega);
        INFO("j = " << c.j << ", gamma = " << c.gamma << ", omega = " << c.omega);
        CHECK(std::abs(static_cast<double>(found.alpha / Textbook(c.j, c.gamma, c.omega).alpha() - 1)) <= 1e-14);
    }
}
