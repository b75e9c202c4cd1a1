#include "oracles/plasticity/scalar_j2.hpp"

#include <algorithm>
#include <cmath>

#include "core/elastic_constants.hpp"

namespace ordo::oracles {
namespace {

/// 1 + (1 - h) + (1 - h)^2 + ... with n terms, for h in [0, 1]; a term below 0 counts as none, so that h > 1 gives 1.
double geometric_sum(double h, double n) {
    if (n < 1) return 0;
    if (h >= 1) return 1;
    return n * h < 1e-17 ? n : -std::expm1(n * std::log1p(-h)) / h;
}

}  // namespace

StrainPath::Leg StrainPath::leg(double t) const {
    const double sign = rate < 0 ? -1 : 1;
    const double total = std::abs(rate) * t;
    if (kind == Kind::monotonic || total < peak) return {0, sign, total};
    const double travelled = std::fmod(total + peak, 2 * peak);
    const double reversals = std::round((total + peak - travelled) / (2 * peak));
    return {reversals, std::fmod(reversals, 2) == 0 ? sign : -sign, travelled};
}

double StrainPath::strain(double t) const {
    const auto [reversals, direction, travelled] = leg(t);
    return direction * (reversals == 0 ? travelled : travelled - peak);
}

double StrainPath::last_time() const {
    return 1e15 * (kind == Kind::cycle ? peak : 1) / std::abs(rate);  // infinity where nothing moves
}

double ScalarJ2::plastic_strain_after(double reversals) const {
    const double first = std::max(0.0, k * path.peak - Y0) / (3 * G + H);
    const double second = 2 * first * (3 * G) / (3 * G + H);
    return first + second * geometric_sum(2 * H / (3 * G + H), reversals - 1);
}

ScalarJ2::State ScalarJ2::at(double t) const {
    const auto [reversals, direction, travelled] = path.leg(t);
    const double strain = path.strain(t);
    const bool virgin = reversals == 0;
    const double p = virgin ? 0 : plastic_strain_after(reversals);
    if (!virgin && p == 0) return {strain, k * strain, 0};
    const double Y = Y0 + H * p;
    const double beyond = k * travelled - (virgin ? Y : 2 * Y);
    // All is elastic after the second leg where that one hardened past the range of the strain.
    if (H >= 3 * G && reversals >= 2) {
        const double first_direction = path.rate < 0 ? -1 : 1;
        return {strain, k * strain + first_direction * (k * path.peak - Y), p};
    }
    if (beyond <= 0) return {strain, direction * (k * travelled - (virgin ? 0 : Y)), p};
    const double dp = beyond / (3 * G + H);
    return {strain, direction * (Y + H * dp), p + dp};
}

double ScalarJ2::plastic_work(double p) const { return (Y0 + 0.5 * H * p) * p; }

std::string strain_path_text() {
    return "t drives the strain, not inertia. path=monotonic: strain = rate t. path=cycle: a triangle wave that starts "
           "at 0\n"
           "at the rate `rate`, reverses at peak (-peak where rate < 0), then at the opposite peak, and so on for "
           "ever.\n"
           "Refused: strain travelled |rate| t beyond 1e15 peaks (monotonic: beyond 1e15), where a double t tells no "
           "place.";
}

std::vector<Parameter> j2_parameters() {
    return appended(elastic_parameters("E 2e11, nu 0.3"),
                    {number("Y0", "Pa", 4e8, between(1e-100, 1e100), "initial yield stress in tension"),
                     number("H", "Pa", 0, between(0, 1e100),
                            "isotropic hardening: d yield stress / d plastic strain; 0 is perfect"),
                     number("rate", "1/s", 1, finite, "d strain / dt up to the first reversal, of either sign"),
                     number("peak", "-", 0.01, positive, "strain at which path=cycle reverses"),
                     word("path", "monotonic",
                          {{"monotonic", "strain = rate t"}, {"cycle", "a triangle wave between peak and -peak"}},
                          "how the strain goes on")});
}

StrainPath strain_path(const Values& values) {
    return {.kind = values.word("path") == "cycle" ? StrainPath::Kind::cycle : StrainPath::Kind::monotonic,
            .rate = values.number("rate"),
            .peak = values.number("peak")};
}

}  // namespace ordo::oracles
