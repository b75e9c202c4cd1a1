#include "oracles/blasts/sedov.hpp"

#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "core/text.hpp"

namespace ordo::oracles {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double pi = boost::math::constants::pi<double>();

double value_or_none(double x) { return std::isfinite(x) ? x : nan; }

const Sedov& admissible(const Sedov& given) {
    const int j = static_cast<int>(given.geometry);
    const auto refuse = [](const std::string& problem) { throw InputError("oracle sedov", problem); };
    if (!(given.gamma > 1)) refuse("gamma = " + shortest(given.gamma) + ", but must be > 1");
    if (!(given.omega < j))
        refuse("omega = " + shortest(given.omega) + ", but must be < " + std::to_string(j) +
               ": with a density rho0 r^-omega every neighbourhood of r = 0 would hold infinite mass; nearest: below " +
               std::to_string(j));
    if (!(given.energy > 0)) refuse("energy = " + shortest(given.energy) + ", but must be > 0");
    if (!(given.rho0 > 0)) refuse("rho0 = " + shortest(given.rho0) + ", but must be > 0");
    return given;
}

}  // namespace

SedovBlast::SedovBlast(const Sedov& given)
    : given_(admissible(given)),
      j_(static_cast<int>(given.geometry)),
      profiles_(j_, given.gamma, given.omega),
      integrals_(energy_integrals(profiles_, j_, given.gamma, given.omega)),
      r_of_one_(std::pow(given.energy / integrals_.alpha / given.rho0, 1 / (j_ + 2 - given.omega))) {
    if (!(std::isfinite(r_of_one_) && r_of_one_ > 0 && std::isfinite(integrals_.alpha)))
        throw InputError(
            "oracle sedov",
            "alpha = " + shortest(integrals_.alpha) + " and r_shock(1 s) = " + shortest(r_of_one_) +
                " m leave the range of a double; nearest: " + "gamma, omega, energy and rho0 of less extreme size");
}

SedovBlast::Front SedovBlast::front(double t) const {
    const double delta = 2 / (j_ + 2 - given_.omega);
    const double r = r_of_one_ * std::pow(t, delta);
    const double speed = delta * r / t;
    const double ahead = given_.rho0 * std::pow(r, -given_.omega);
    const double u = 2 * speed / (given_.gamma + 1);
    const double rho = ahead * (given_.gamma + 1) / (given_.gamma - 1);
    return {r, speed, profiles_.core() * r, {u, rho, ahead * speed * u, u * u / 2}};
}

SedovBlast::State SedovBlast::at(double r, const Front& front) const {
    if (!(r < front.r)) return {0, given_.rho0 * std::pow(r, -given_.omega), 0, 0};
    if (r < front.core) return {nan, 0, 0, nan};
    const auto [f, g, h, e] = profiles_.profile(r / front.r);
    const auto& [u2, rho2, p2, e2] = front.behind;
    return {u2 * f, value_or_none(rho2 * g), p2 * h, value_or_none(e2 * e)};
}

double SedovBlast::swept_mass(double r) const {
    const double area = j_ == 1 ? 1 : 2 * (j_ - 1) * pi;
    return area * given_.rho0 * std::pow(r, j_ - given_.omega) / (j_ - given_.omega);
}

double SedovBlast::mass(double r, double t) const {
    const Front now = front(t);
    if (!(r < now.r)) return swept_mass(r);
    return r < now.core ? 0 : swept_mass(now.r) * profiles_.enclosed_mass(r / now.r);
}

}  // namespace ordo::oracles
