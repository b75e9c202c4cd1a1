#pragma once
// Isotropic linear elasticity: any two of six constants give the others.
#include <array>
#include <string>
#include <vector>

#include "core/parameter.hpp"

namespace ordo {

/// The constants of an isotropic elastic solid, K > 0 and G > 0: strain energy is positive.
struct ElasticConstants {
    double E;       ///< Young's modulus [Pa]
    double nu;      ///< Poisson's ratio [-], in (-1, 0.5)
    double K;       ///< bulk modulus [Pa]
    double G;       ///< shear modulus, Lame's mu [Pa]
    double lambda;  ///< Lame's first modulus [Pa]
    double M;       ///< P-wave modulus lambda + 2 G [Pa]
};

enum class Elastic { E, nu, K, G, lambda, M };
inline constexpr std::array elastic_names{"E", "nu", "K", "G", "lambda", "M"};

struct KnownElastic {
    Elastic which;
    double value;
};

/// All six from any two. The two come back as they were given.
///
/// E and M    belong to two solids, one with nu >= 0 and one with nu < 0: the one with nu >= 0 is taken
/// error      throws InputError, opened by `where`, when no such solid exists (K > 0 and G > 0 cannot both hold),
///            or when it is left open (nu = lambda = 0)
/// accurate   4 ulp times (1 + condition), relative. With r(y) = d ln y / d nu at constant E, the condition of y from
///            a and b is (|r(y) - r(b)| + |r(y) - r(a)|) / |r(a) - r(b)|; of y from a and nu, 1 + |nu (r(y) - r(a))|
///            r(E) = 0,  r(G) = -1/(1+nu),  r(K) = 2/(1-2nu),  r(lambda) = 1/nu + r(G) + r(K),
///            r(M) = r(G) + r(K) - 1/(1-nu)
///            It is large for nu near -1 and 0.5, near nu = 0 for (E, M), and where lambda is a small difference
///            (gate: tests/core/elastic_constants_test.cpp)
/// source     [Mavko1998]
ElasticConstants elastic_constants(KnownElastic a, KnownElastic b, const std::string& where);

/// Declares E, nu, K, G, lambda and M, none with a default. `when_absent` says what holds without them: "E 1e7, nu 0".
std::vector<Parameter> elastic_parameters(const std::string& when_absent);

/// Declares the same for a bar, where only Young's modulus matters, behind the first of `others`: `fallback` [Pa] holds
/// when none of them is given.
std::vector<Parameter> with_youngs_modulus(std::vector<Parameter> others, double fallback);

/// What a user gave of elastic_parameters(): nothing is `fallback`, exactly two are completed, else InputError.
ElasticConstants elastic_constants(const Values& values, const ElasticConstants& fallback, const std::string& where);

/// Where only Young's modulus matters: nothing is `fallback`; E alone, or any two; else InputError. [Pa]
double youngs_modulus(const Values& values, double fallback, const std::string& where);

}  // namespace ordo
