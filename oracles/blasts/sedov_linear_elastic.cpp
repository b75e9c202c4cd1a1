#include "oracles/blasts/sedov_linear_elastic.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "oracles/features.hpp"

namespace ordo::oracles {
namespace {

const std::vector<FieldInfo>& all_fields() {
    static const auto list = [] {
        std::vector<FieldInfo> fields = elastic::fields();
        fields.push_back({"displacement", "m", 1});
        return fields;
    }();
    return list;
}

/// How far the particle that is there now has moved since t = 0.
double moved(const ElasticLine& line, const ElasticProfile& profile, double x) {
    return x - line.position(profile.reference(x), 0);
}

/// The elastic fields and how far the particle has moved since t = 0, one point after the other.
void sample(const ElasticLine& line, std::span<const double> x, double t, std::span<double> values) {
    const ElasticProfile profile = line.profile(t);
    auto out = values.begin();
    for (const double place : x) {
        for (const double value : line.fields(profile.at(place).state)) *out++ = value;
        *out++ = moved(line, profile, place);
    }
}

/// Their means over cells; the displacement is linear in x within a piece.
void averages(const ElasticLine& line, std::span<const double> edges, double t, std::span<double> values) {
    const ElasticProfile profile = line.profile(t);
    auto out = values.begin();
    for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
        const double a = edges[i];
        const double b = edges[i + 1];
        for (const double mean : line.averages(profile, a, b)) *out++ = mean;
        double displacement = 0;
        profile.over(a, b, [&](const ElasticProfile::Piece&, double from, double to) {
            displacement += moved(line, profile, 0.5 * (from + to)) * ((to - from) / (b - a));
        });
        *out++ = displacement;
    }
}

Constants constants_of(const SedovLinearElastic& blast, std::optional<double> t) {
    const double c0 = blast.wave_speed();
    Constants constants{{"E0", blast.energy()},
                        {"c0", c0},
                        {"t0", blast.splitting_time()},
                        {"rho_pulse", blast.rho0 / (0.5 * (1 + blast.lambda_c))},
                        {"v_pulse", 0.5 * c0 * (1 - blast.lambda_c)},
                        {"sigma_pulse", -0.5 * blast.E * (1 - blast.lambda_c)}};
    if (t) {
        constants.push_back({"x_front", blast.front(*t)});
        constants.push_back({"x_rear", blast.rear(*t)});
    }
    return constants;
}

/// T is the same everywhere, so every jump is an acoustic one.
std::vector<Wave> waves_of(const ElasticLine& line, double t) {
    std::vector<Wave> waves;
    for (const double x : line.jumps(t)) waves.push_back({Wave::Kind::shock, x, x});
    return waves;
}

/// The displacement is continuous, and linear between the jumps of the stretch now and of that at t = 0, which lie at
/// the ends of the squeezed piece.
std::vector<Feature> kinks_of(const SedovLinearElastic& blast, double t) {
    const auto line = blast.line();
    auto places = line.jumps(t);
    for (const double X : {-0.5 * blast.L0, 0.5 * blast.L0}) places.push_back(line.position(X, t));
    std::vector<Feature> kinks;
    for (const double x : places) kinks.push_back({Feature::Kind::linear, x, 1});
    return kinks;
}

Exact bind(const Values& values) {
    const SedovLinearElastic blast{.L0 = values.number("L0"),
                                   .lambda_c = values.number("lambda_c"),
                                   .E = values.number("E"),
                                   .rho0 = values.number("rho0"),
                                   .c_v = values.number("c_v"),
                                   .T = values.number("T")};
    const double thermal = blast.c_v * blast.T;
    if (!std::isfinite(blast.energy() + thermal) || !std::isfinite(blast.rho0 / blast.lambda_c * (1 + thermal)) ||
        !(blast.wave_speed() > 0) || !std::isfinite(blast.splitting_time()))
        throw InputError(
            "oracle sedov_linear_elastic",
            "its energy, density or wave speed leaves the numbers of a double; nearest: values nearer to 1");
    constexpr double furthest = 1e300;  // of x and of c0 t
    Exact exact{.dim = 1,
                .coordinates = Coordinates::spatial,
                .lower = {-furthest},
                .upper = {furthest},
                .times = between(0, std::min(furthest, furthest / blast.wave_speed())),
                .fields = all_fields(),
                .sample = [line = blast.line()](std::span<const double> x, double t,
                                                std::span<double> values) { sample(line, x, t, values); },
                .averages = [line = blast.line()](std::span<const double> edges, double t,
                                                  std::span<double> values) { averages(line, edges, t, values); },
                .jumps = [line = blast.line()](double t) { return line.jumps(t); },
                .waves = [line = blast.line()](double t) { return waves_of(line, t); },
                .constants = [blast](std::optional<double> t) { return constants_of(blast, t); }};
    exact.features = [blast, other = features_of_waves(exact, Feature::Kind::linear)](const std::string& field,
                                                                                      double t) {
        return field == "displacement" ? kinks_of(blast, t) : other(field, t);
    };
    return exact;
}

}  // namespace

double SedovLinearElastic::wave_speed() const { return std::sqrt(E / rho0); }
double SedovLinearElastic::energy() const { return 0.5 * E * (1 - lambda_c) * (1 - lambda_c) * L0; }
double SedovLinearElastic::splitting_time() const { return 0.5 * L0 / wave_speed(); }
double SedovLinearElastic::front(double t) const { return 0.5 * lambda_c * L0 + wave_speed() * t; }

double SedovLinearElastic::rear(double t) const {
    const double inwards = 0.5 * L0 - wave_speed() * t;
    return inwards > 0 ? lambda_c * inwards : -inwards;
}

ElasticLine SedovLinearElastic::line() const {
    const elastic::State relaxed{1, 0, T};
    return {E, rho0, c_v, {-0.5 * L0, 0.5 * L0}, {relaxed, {lambda_c, 0, T}, relaxed}, -0.5 * lambda_c * L0};
}

Oracle sedov_linear_elastic() {
    return {
        .name = "sedov_linear_elastic",
        .about = "Blast of linear elasticity: a crushed slug is released and splits into two pulses",
        .source = {"Walker2017"},
        .explanation =
            "rho0 v_t = sigma_X,  lambda_t = v_X,  sigma = E (lambda - 1);  C = E (lambda - 1)^2 / 2 + c_v T\n"
            "Heat exerts no stress in this law: a point release of heat moves nothing, T stays what it is. What "
            "blasts\n"
            "is strain: a slug of reference length L0 at the stretch lambda_c, at rest around x = 0 in a relaxed "
            "line,\n"
            "is let go at t = 0. With c0 = sqrt(E / rho0), t0 = L0 / (2 c0), E0 = E (1 - lambda_c)^2 L0 / 2 :\n"
            "  released band  lambda = (1 + lambda_c)/2,  |v| = c0 (1 - lambda_c)/2,  front |x| = lambda_c L0/2 + c0 "
            "t\n"
            "  t < t0         rear |x| = lambda_c (L0/2 - c0 t), within it the slug as it was\n"
            "  t > t0         rear |x| = c0 t - L0/2: two pulses, each with E0/2, half kinetic, half strain\n"
            "The point blast of energy E0 is the limit lambda_c -> 0, L0 = 2 E0 / E: density 2 rho0, |v| = c0 / 2.\n"
            "Holds for every t >= 0 and 0 < lambda_c <= 1 (1: nothing was stored). x is the position in space; at a\n"
            "jump the state on its right holds; displacement counts from t = 0; energy is internal, per mass.\n"
            "constants: E0 (per cross-section), c0, t0, rho_pulse, v_pulse, sigma_pulse; with t x_front, x_rear\n"
            "of the right band",
        .example = "sedov_linear_elastic --t 2 --grid -2.5:2.5:11",
        .parameters = {number("L0", "m", 1, positive, "reference length of the slug"),
                       number("lambda_c", "-", 0.1, {.low = 0, .high = 1, .low_excluded = true},
                              "stretch of the slug before its release"),
                       number("E", "Pa", 1, positive, "Young's modulus"),
                       number("rho0", "kg/m^3", 1, positive, "density where lambda = 1"),
                       number("T", "K", 0, at_least(0), "temperature of everything"),
                       number("c_v", "J/(m^3 K)", 1, positive, "heat capacity per reference volume")},
        .fields = all_fields(),
        .smoothness = "uniform between its jumps (displacement: linear, continuous)",
        .accuracy = "4 ulp of c0 in velocity and of Z c0 in stress; places 4 ulp of L0 + c0 t",
        .bind = bind};
}

}  // namespace ordo::oracles
