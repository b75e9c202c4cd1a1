#include "oracles/blasts/sedov_nonlinear_elastic.hpp"

#include <cmath>
#include <limits>

#include "oracles/riemann/elastic_laws.hpp"

namespace ordo::oracles {

namespace {

/// f of the material's strain energy.
template <class F>
double with_law(const ElasticBlast& blast, F&& f) {
    switch (blast.material) {
        case ElasticBlast::Material::A: return f(elastic::NeoHookean{blast.E});
        case ElasticBlast::Material::B: return f(elastic::Reciprocal{blast.E});
        case ElasticBlast::Material::C: break;
    }
    return f(elastic::Logarithmic{blast.E});
}

}  // namespace

double ElasticBlast::strain_energy(double lambda) const {
    return with_law(*this, [&](const auto& law) { return law.value(elastic::stretch(lambda)); });
}

double ElasticBlast::elastic_stress(double lambda) const {
    return with_law(*this, [&](const auto& law) { return law.at(elastic::stretch(lambda)).slope; });
}

double ElasticBlast::elastic_share() const {
    // Behind the shock lambda = k / (k + 2), p = 2 rho0 U^2 / (k + 2).
    return std::abs(elastic_stress(k / (k + 2))) / E * (k + 2) / 2;
}

SedovNonlinearElastic::SedovNonlinearElastic(const ElasticBlast& given)
    : given_(given),
      blast_({.geometry = Sedov::Geometry::planar,
              .gamma = given.k + 1,
              .omega = 0,
              .energy = given.energy,
              .rho0 = given.rho0}) {}

double SedovNonlinearElastic::strength(double t) const {
    const double U = blast_.front(t).speed;
    return given_.rho0 * U * U / given_.E;
}

double SedovNonlinearElastic::time_of(double m2) const {
    const double alpha = blast_.integrals().alpha;
    const double R = 4 * given_.energy / (9 * alpha * given_.E * m2);
    return R * std::sqrt(R) * std::sqrt(alpha * given_.rho0 / given_.energy);
}

SedovNonlinearElastic::State SedovNonlinearElastic::at(double x, const SedovBlast::Front& front) const {
    const bool at_left_shock = x == -front.r;  // on whose right the blast is
    if (!(std::abs(x) < front.r || at_left_shock)) return {0, given_.rho0, 0, 0, 0, 0, 0};
    const auto gas = at_left_shock ? front.behind : blast_.at(std::abs(x), front);
    const auto& [E, rho0, c_v, k, material, released] = given_;
    const double lambda = rho0 / gas.density;
    const double heat = (gas.pressure + given_.elastic_stress(lambda)) * lambda / k;  // c_v lambda^-k T
    const double T = heat * std::pow(lambda, k) / c_v;
    const double e = (given_.strain_energy(lambda) + heat) / rho0;
    const auto value = [](double number) {
        return std::isfinite(number) ? number : std::numeric_limits<double>::quiet_NaN();
    };
    return {x < 0 ? -gas.velocity : gas.velocity,
            gas.density,
            -gas.pressure,
            gas.pressure,
            value(T),
            value(e),
            value(lambda - 1)};
}

}  // namespace ordo::oracles
