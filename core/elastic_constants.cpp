#include "core/elastic_constants.hpp"

#include <cmath>

#include "core/error.hpp"
#include "core/text.hpp"

namespace ordo {
namespace {

/// How two constants give all six. Forms without cancellation beyond what the question itself has.
struct Pair {
    Elastic first, second;
    const char* rule;  ///< where K > 0 and G > 0, and nothing is left open
    bool (*holds)(double, double);
    ElasticConstants (*all)(double, double);
};

bool is_poisson(double nu) { return nu > -1 && nu < 0.5; }

ElasticConstants from_E_nu(double E, double nu) {
    const double wave = E / ((1 + nu) * (1 - 2 * nu));
    return {E, nu, E / (3 * (1 - 2 * nu)), E / (2 * (1 + nu)), wave * nu, wave * (1 - nu)};
}
ElasticConstants from_E_K(double E, double K) {
    const double share = 3 * K / (9 * K - E);
    return {E, (3 * K - E) / (6 * K), K, share * E, share * (3 * K - E), share * (3 * K + E)};
}
ElasticConstants from_E_G(double E, double G) {
    const double share = G / (3 * G - E);
    return {E, (E - 2 * G) / (2 * G), share * E / 3, G, share * (E - 2 * G), share * (4 * G - E)};
}
/// G and K are the positive roots of 2 G^2 + (3 lambda - E) G = E lambda and 3 K^2 - (E + 3 lambda) K = -E lambda / 3.
ElasticConstants from_E_lambda(double E, double lambda) {
    const double root = std::hypot(E + lambda, std::sqrt(8.0) * lambda);
    const double K_sum = E + 3 * lambda, G_sum = E - 3 * lambda;
    const double K = K_sum >= 0 ? (K_sum + root) / 6 : 2 * E * (-lambda / (root - K_sum)) / 3;
    const double G = G_sum >= 0 ? (G_sum + root) / 4 : 2 * E * (lambda / (root - G_sum));
    return {E, 2 * lambda / (E + lambda + root), K, G, lambda, (E - lambda + root) / 2};
}
/// The solid with nu >= 0; the other one has the other sign of `root`.
ElasticConstants from_E_M(double E, double M) {
    const double near = std::sqrt(M - E), far = std::sqrt(9 * M - E);
    const double root = near * far;
    const double G = 2 * E * (M / (3 * M + E + root));
    return {E, 2 * near / (near + far), (3 * M - E + root) / 6, G, (M - E + root) / 4, M};
}
ElasticConstants from_nu_K(double nu, double K) {
    const double share = 3 * K / (1 + nu);
    return {3 * K * (1 - 2 * nu), nu, K, share * (1 - 2 * nu) / 2, share * nu, share * (1 - nu)};
}
ElasticConstants from_nu_G(double nu, double G) {
    const double share = 2 * G / (1 - 2 * nu);
    return {2 * G * (1 + nu), nu, share * (1 + nu) / 3, G, share * nu, share * (1 - nu)};
}
ElasticConstants from_nu_lambda(double nu, double lambda) {
    const double share = lambda / nu;
    return {share * (1 + nu) * (1 - 2 * nu), nu,     share * (1 + nu) / 3,
            share * (1 - 2 * nu) / 2,        lambda, share * (1 - nu)};
}
ElasticConstants from_nu_M(double nu, double M) {
    const double share = M / (1 - nu);
    return {share * (1 + nu) * (1 - 2 * nu), nu, share * (1 + nu) / 3, share * (1 - 2 * nu) / 2, share * nu, M};
}
ElasticConstants from_K_G(double K, double G) {
    const double sum = 3 * K + G, difference = 3 * K - 2 * G;
    return {9 * K * (G / sum), difference / (2 * sum), K, G, difference / 3, K + 4 * G / 3};
}
ElasticConstants from_K_lambda(double K, double lambda) {
    const double difference = K - lambda, sum = 2 * K + difference;
    return {9 * K * (difference / sum), lambda / sum, K, 1.5 * difference, lambda, K + 2 * difference};
}
ElasticConstants from_K_M(double K, double M) {
    const double sum = 3 * K + M, difference = 3 * K - M;
    return {9 * K * ((M - K) / sum), difference / sum, K, 3 * (M - K) / 4, difference / 2, M};
}
ElasticConstants from_G_lambda(double G, double lambda) {
    const double sum = lambda + G, bulk = 3 * lambda + 2 * G;
    return {G * (bulk / sum), lambda / (2 * sum), bulk / 3, G, lambda, lambda + 2 * G};
}
ElasticConstants from_G_M(double G, double M) {
    const double difference = M - G, bulk = 3 * M - 4 * G;
    return {G * (bulk / difference), (M - 2 * G) / (2 * difference), bulk / 3, G, M - 2 * G, M};
}
ElasticConstants from_lambda_M(double lambda, double M) {
    const double sum = M + lambda, bulk = M + 2 * lambda;
    return {(M - lambda) * (bulk / sum), lambda / sum, bulk / 3, (M - lambda) / 2, lambda, M};
}

using enum Elastic;

constexpr std::array<Pair, 15> pairs{{
    {E, nu, "E > 0 and -1 < nu < 0.5", [](double a, double b) { return a > 0 && is_poisson(b); }, from_E_nu},
    {E, K, "0 < E < 9 K", [](double a, double b) { return a > 0 && a < 9 * b; }, from_E_K},
    {E, G, "0 < E < 3 G", [](double a, double b) { return a > 0 && a < 3 * b; }, from_E_G},
    {E, lambda, "E > 0", [](double a, double b) { return a > 0 && std::isfinite(b); }, from_E_lambda},
    {E, M, "0 < E <= M", [](double a, double b) { return a > 0 && a <= b; }, from_E_M},
    {nu, K, "-1 < nu < 0.5 and K > 0", [](double a, double b) { return is_poisson(a) && b > 0; }, from_nu_K},
    {nu, G, "-1 < nu < 0.5 and G > 0", [](double a, double b) { return is_poisson(a) && b > 0; }, from_nu_G},
    {nu, lambda, "-1 < nu < 0.5, lambda of the sign of nu, and neither 0 (which leaves E open)",
     [](double a, double b) { return is_poisson(a) && ((a > 0 && b > 0) || (a < 0 && b < 0)); }, from_nu_lambda},
    {nu, M, "-1 < nu < 0.5 and M > 0", [](double a, double b) { return is_poisson(a) && b > 0; }, from_nu_M},
    {K, G, "K > 0 and G > 0", [](double a, double b) { return a > 0 && b > 0; }, from_K_G},
    {K, lambda, "K > 0 and lambda < K", [](double a, double b) { return a > 0 && b < a; }, from_K_lambda},
    {K, M, "0 < K < M", [](double a, double b) { return a > 0 && a < b; }, from_K_M},
    {G, lambda, "G > 0 and 3 lambda > -2 G", [](double a, double b) { return a > 0 && 3 * b > -2 * a; }, from_G_lambda},
    {G, M, "0 < 4 G < 3 M", [](double a, double b) { return a > 0 && 4 * a < 3 * b; }, from_G_M},
    {lambda, M, "-M < 2 lambda < 2 M", [](double a, double b) { return 2 * a > -b && a < b; }, from_lambda_M},
}};

std::string written(KnownElastic known) {
    return std::string(elastic_names.at(static_cast<std::size_t>(known.which))) + " = " + shortest(known.value);
}

const Pair& pair_of(KnownElastic a, KnownElastic b, const std::string& where) {
    for (const auto& pair : pairs) {
        if (pair.first == a.which && pair.second == b.which) return pair;
    }
    throw InputError(where,
                     written(a) + " and " + written(b) + " are the same constant; two different ones are needed");
}

bool is_in_range(const ElasticConstants& all) {
    const auto is_modulus = [](double value) { return std::isnormal(value) && value > 0; };
    return is_modulus(all.E) && is_modulus(all.K) && is_modulus(all.G) && is_modulus(all.M) &&
           std::isfinite(all.lambda) && is_poisson(all.nu);
}

std::vector<KnownElastic> given_of(const Values& values) {
    std::vector<KnownElastic> given;
    for (std::size_t k = 0; k < elastic_names.size(); ++k) {
        if (values.has(elastic_names[k])) given.push_back({static_cast<Elastic>(k), values.number(elastic_names[k])});
    }
    return given;
}

[[noreturn]] void refuse_number_of(const std::vector<KnownElastic>& given, const std::string& where) {
    std::vector<std::string> names;
    for (const auto& known : given) names.push_back(written(known));
    throw InputError(where, (names.size() == 1 ? "only " : "") + joined(names) +
                                (names.size() == 1 ? " is given" : " are given") +
                                ", but an isotropic solid has exactly two of E, nu, K, G, lambda, M");
}

}  // namespace

ElasticConstants elastic_constants(KnownElastic a, KnownElastic b, const std::string& where) {
    if (a.which > b.which) std::swap(a, b);
    const Pair& pair = pair_of(a, b, where);
    const bool finite_input = std::isfinite(a.value) && std::isfinite(b.value);
    if (!finite_input || !pair.holds(a.value, b.value))
        throw InputError(where, "no stable solid (K > 0, G > 0) has " + written(a) + " and " + written(b) +
                                    "; must be " + pair.rule);
    const ElasticConstants all = pair.all(a.value, b.value);
    if (!is_in_range(all))
        throw InputError(where, written(a) + " and " + written(b) + " give constants beyond the range of numbers");
    return all;
}

std::vector<Parameter> elastic_parameters(const std::string& when_absent) {
    const auto modulus = [](const char* name, const Range& range, const std::string& help) {
        return without_default(number(name, "Pa", 0, range, help));
    };
    return {modulus("E", positive, "Young's modulus; of E, nu, K, G, lambda, M any two, or none: " + when_absent),
            without_default(number("nu", "-", 0, finite, "Poisson's ratio, in (-1, 0.5)")),
            modulus("K", positive, "bulk modulus"),
            modulus("G", positive, "shear modulus, Lame's mu"),
            modulus("lambda", finite, "Lame's first modulus"),
            modulus("M", positive, "P-wave modulus lambda + 2 G")};
}

std::vector<Parameter> with_youngs_modulus(std::vector<Parameter> others, double fallback) {
    const auto elastic = elastic_parameters("E " + shortest(fallback) + "; in a bar E alone is enough");
    others.insert(others.begin() + 1, elastic.begin(), elastic.end());
    return others;
}

ElasticConstants elastic_constants(const Values& values, const ElasticConstants& fallback, const std::string& where) {
    const auto given = given_of(values);
    if (given.empty()) return fallback;
    if (given.size() != 2) refuse_number_of(given, where);
    return elastic_constants(given[0], given[1], where);
}

double youngs_modulus(const Values& values, double fallback, const std::string& where) {
    const auto given = given_of(values);
    if (given.empty()) return fallback;
    if (given.size() == 1 && given[0].which == E) return given[0].value;
    if (given.size() != 2) refuse_number_of(given, where);
    return elastic_constants(given[0], given[1], where).E;
}

}  // namespace ordo
