#include "oracles/blasts/similarity.hpp"

#include <algorithm>
#include <cmath>

namespace ordo::oracles {
namespace {

using Numbers = std::array<double, 4>;

constexpr double endless = 1e300;  // a q at which e^-q is 0, and of which no coefficient makes NaN

double dot(const Numbers& a, const Numbers& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3]; }

/// -ln(1 - r z) / r with 1 - r z = A, of which neither r near 0 nor r z near 1 takes digits away.
double divided_log(double r, double z, double A) {
    const double rz = r * z;
    if (rz >= 0.5) return -std::log(A) / r;
    return rz == 0 ? z : -std::log1p(-rz) / r;
}

}  // namespace

Similarity::Similarity(int j, double gamma, double omega) : j_(j) {
    // What the numbers given leave of D, B and S counts to the last bit: differences of nearly equal numbers.
    using Extended = long double;
    const Extended wide_D = 2 * (Extended{gamma} - 1) + j - Extended{gamma} * omega;
    const Extended wide_B = j * (2 - Extended{gamma}) - omega;
    const auto D = static_cast<double>(wide_D);
    const auto B = static_cast<double>(wide_B);
    auto S = static_cast<double>(wide_D + wide_B);
    // Singular is what some singular pair (gamma, omega) rounds to.
    if (std::abs(S) <= 0x1p-53 * (gamma * std::abs(2 - j - omega) + std::abs(omega) * (gamma + 1))) S = 0;
    kind_ = S > 0 ? BlastKind::standard : S < 0 ? BlastKind::vacuum : BlastKind::singular;
    const bool to_centre = S >= 0;
    k_ = to_centre ? 1 : 2;
    const double Y = to_centre ? D : -B;
    const double n = j + 2 - omega;
    const double Q = 2 + j * (gamma - 1);
    const double share = (gamma - 1) / (gamma + 1);
    const double s = std::abs(S) / Y;
    r_ = {n * (gamma - 1) / (2 * Y), D / Y, share * Q / Y, -B / Y};
    s_ = {s / 2, to_centre ? 0 : s, s * (to_centre ? gamma : 1) / (gamma + 1), to_centre ? s : 0};
    rate_ = (gamma - 1) / Y;
    density_ = {-omega * rate_, (gamma * omega - j) / Y, 2 * share * (j - 1) / Y, (omega * (gamma + 1) - 2 * j) / Y};
    pressure_ = {-j * rate_, 0, 2 * gamma * share * (j - 1) / Y, -gamma * (j - omega) / Y};
    energy_ = {(omega - j) * rate_, (j - gamma * omega) / Y, 2 * share * (gamma - 1) * (j - 1) / Y, B / Y};
    mass_ = {(j - omega) * rate_, -gamma * (j - omega) / Y, 0, -gamma * (j - omega) / Y};
    decay_ = to_centre ? j * rate_ : gamma * (j - omega) / Y;
    last_ = to_centre ? endless : divided_log(r_[2], 1, s_[2]);
    core_ = to_centre ? 0 : std::exp(log_lambda(terms(place_of_q(endless))));
}

Similarity::Place Similarity::place_of_q(double q) const {
    q = std::min(q, endless);
    const double e = std::exp(-q);
    return {q, e, e < 0.5 ? 1 - e : -std::expm1(-q)};
}

/// Of the unknown of the inversion: M_2 is q; 1 - r_3 z = e^(-r_3 M_3).
Similarity::Place Similarity::place_of(double M_k) const {
    if (k_ == 1) return place_of_q(M_k);
    const double e = s_[2] / r_[2] * std::expm1(r_[2] * (last_ - M_k));
    if (e < 0.5) return {e > 0 ? -std::log(e) : endless, e, 1 - e};
    const double z = -std::expm1(-r_[2] * M_k) / r_[2];
    return {-std::log1p(-z), 1 - z, z};
}

Similarity::Terms Similarity::terms(const Place& place) const {
    Terms result;
    for (std::size_t i = 0; i < 4; ++i) {
        result.A[i] = s_[i] + r_[i] * place.e;
        result.M[i] = s_[i] == 0 ? place.q : divided_log(r_[i], place.z, result.A[i]);
    }
    return result;
}

double Similarity::log_lambda(const Terms& at) const { return rate_ * (at.M[0] - at.M[1] - at.M[2]); }

/// dM_i / dM_k.
double Similarity::ratio(const Terms& at, std::size_t i) const {
    return i == k_ || s_[2] == 0 ? 1 : at.A[k_] / at.A[i];
}

Similarity::Profile Similarity::profile(const Terms& at, double lambda) const {
    const double x1 = s_[2] == 0 ? 1 : at.A[0] / at.A[2];
    return {lambda * x1, std::exp(dot(density_, at.M)), std::exp(dot(pressure_, at.M)), std::exp(dot(energy_, at.M))};
}

Similarity::Profile Similarity::profile(double lambda) const {
    if (lambda > 0) return profile(terms(place_of_lambda(lambda)), lambda);
    if (kind_ == BlastKind::singular) return {0, j_ == 2 ? 1.0 : 0.0, 0, 0};  // lambda, lambda^(j - 2), lambda^j
    return profile(terms(place_of_q(endless)), 0);
}

double Similarity::enclosed_mass(double lambda) const {
    return lambda > 0 ? std::exp(dot(mass_, terms(place_of_lambda(lambda)).M)) : 0;
}

Similarity::Shell Similarity::shell(double q) const {
    const Place place = place_of_q(q);
    const Terms at = terms(place);
    const double slope = rate_ * (ratio(at, 1) + ratio(at, 2) - ratio(at, 0));  // -d ln(lambda) / dM_k
    // One exponential for powers that grow and powers that fall. M_2 is q; dM_3/dq = e^-q / A_3.
    const double volume = j_ * log_lambda(at) - (k_ == 1 ? 0 : place.q);
    const double thickness = slope / (k_ == 1 ? 1 : at.A[2]);
    const double mass = thickness * std::exp(dot(density_, at.M) + volume);
    const double f = profile(at, std::exp(log_lambda(at))).velocity;
    return {mass, mass * f * f, thickness * std::exp(dot(pressure_, at.M) + volume)};
}

/// By Halley's method in M_k, of which M_1 - M_2 - M_3 is so nearly a linear function that the root lies within a
/// factor 2 of its tangent's at the shock: its slope stays between -1 and -0.82 with k = 2, and between -1 and -1/2
/// with k = 3. The derivatives cost no logarithm, dM_i/dM_k = A_k / A_i, d^2 M_i/dM_k^2 = A_k / A_i (r_i A_k / A_i -
/// r_k).
Similarity::Place Similarity::place_of_lambda(double lambda) const {
    const double target = std::log(lambda) / rate_;
    const double lowest = std::min(-target, last_);
    const double highest = std::min(-2 * target, last_);
    double unknown = lowest;
    bool settled = kind_ == BlastKind::singular;
    for (int i = 0; i < 60 && !settled; ++i) {
        const Terms at = terms(place_of(unknown));
        double excess = -target, slope = 0, bend = 0;
        for (std::size_t m = 0; m < 3; ++m) {
            const double sign = m == 0 ? 1 : -1;
            const double rise = ratio(at, m);
            excess += sign * at.M[m];
            slope += sign * rise;
            bend += sign * rise * (r_[m] * rise - r_[k_]);
        }
        const double newton = -excess / slope;
        const double change = newton / (1 + 0.5 * newton * bend / slope);
        unknown = std::clamp(unknown + change, lowest, highest);
        settled = !(std::abs(change) > 1e-6 * unknown);  // the next change would be its cube
    }
    return place_of(unknown);
}

}  // namespace ordo::oracles
