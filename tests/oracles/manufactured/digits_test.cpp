// The motion alone defines everything else: each field of each manufactured motion is held to its stated accuracy,
// without any of its closed forms.
#include "oracles/manufactured/axis_aligned_mms.hpp"
#include "oracles/manufactured/bar_mms.hpp"
#include "oracles/manufactured/periodic_bar_mms.hpp"
#include "oracles/manufactured/ring_mms.hpp"
#include "oracles/manufactured/vortex_mms.hpp"
#include "tests/catch.hpp"
#include "tests/oracles/manufactured/motion_digits.hpp"

using namespace ordo;
using namespace ordo::oracles;
using namespace ordo::oracles::gate;
using namespace ordo::oracles::gate::manufactured;

namespace {

constexpr double pi = 3.141592653589793;

template <class Body>
Real real_lambda(const Body& body) {
    const Real nu(body.elastic.nu);
    return Real(body.elastic.E) * nu / ((1 + nu) * (1 - 2 * nu));
}
template <class Body>
Real real_mu(const Body& body) {
    return Real(body.elastic.E) / (2 * (1 + Real(body.elastic.nu)));
}
template <class Body>
Real real_c(const Body& body) {
    return sqrt(Real(body.elastic.E) / Real(body.rho));
}

ElasticConstants E_nu(double E, double nu) { return elastic_constants({Elastic::E, E}, {Elastic::nu, nu}, ""); }

Digits digits_of(const BarMms& bar, const std::function<void(MaterialPoint<1>&)>& fault = nullptr) {
    const Real omega = real_pi * real_c(bar) / Real(bar.L);
    const Truth<1> truth{[bar, omega](const Reals<1>& X, const Real& t) {
                             return Reals<1>{Real(bar.A) * sin(real_pi * X[0] / Real(bar.L)) * sin(omega * t)};
                         },
                         real_lambda(bar),
                         real_mu(bar),
                         bar.rho,
                         bar.L,
                         omega};
    const double margin = std::min(1.0, 10 * (1 - pi * std::abs(bar.A) / bar.L));
    const auto accuracy = [=](double t) { return 1e-15 * (4 + bar.omega() * t) / margin; };
    const auto at = [=](const std::array<double, 1>& X, double t) {
        auto p = bar.at(X, t);
        if (fault) fault(p);
        return p;
    };
    return digits<1>(truth,
                     {at, accuracy, {{0}, {0.013 * bar.L}, {0.2 * bar.L}, {0.52 * bar.L}, {0.83 * bar.L}, {bar.L}}});
}

Digits digits_of(const PeriodicBarMms& bar) {
    const Real omega = real_pi * sqrt(Real(bar.E) / Real(bar.rho)) / Real(bar.L);
    const Truth<1> truth{[bar, omega](const Reals<1>& X, const Real& t) {
                             return Reals<1>{Real(bar.A) * sin(2 * real_pi * X[0] / Real(bar.L)) * cos(omega * t)};
                         },
                         0,
                         Real(bar.E) / 2,
                         bar.rho,
                         bar.L,
                         omega};
    const double margin = std::min(1.0, 10 * (1 - 2 * pi * std::abs(bar.A) / bar.L));
    const auto accuracy = [=](double t) { return 1e-15 * (4 + bar.omega() * t) / margin; };
    const auto at = [=](const std::array<double, 1>& X, double t) { return bar.at(X, t); };
    return digits<1>(truth,
                     {at, accuracy, {{0}, {0.113 * bar.L}, {0.26 * bar.L}, {0.52 * bar.L}, {0.83 * bar.L}, {bar.L}}});
}

template <std::size_t dim>
Digits digits_of(const AxisAlignedMms& body) {
    const Real omega = real_pi * (body.speed ? Real(*body.speed) : real_c(body)) / Real(body.L);
    const Truth<dim> truth{[body, omega](const Reals<dim>& X, const Real& t) {
                               Reals<dim> u;
                               for (std::size_t a = 0; a < dim; ++a)
                                   u[a] = Real(body.A) * sin(body.k * real_pi * X[a] / Real(body.L)) *
                                          sin(omega * t + Real(body.phase[a]));
                               return u;
                           },
                           real_lambda(body),
                           real_mu(body),
                           body.rho,
                           Real(body.L) / body.k,
                           omega};
    const double margin = std::min(1.0, 10 * (1 - body.k * pi * std::abs(body.A) / body.L));
    const double latest = *std::max_element(body.phase.begin(), body.phase.end());
    const auto accuracy = [=](double t) { return 1e-15 * (4 + body.omega() * t + latest) / margin; };
    const auto at = [=](const std::array<double, dim>& X, double t) { return body.at(X, t); };
    std::vector<std::array<double, dim>> points(5);
    for (std::size_t n = 0; n < points.size(); ++n) {
        for (std::size_t a = 0; a < dim; ++a)
            points[n][a] = body.L * std::array{0.0, 0.17, 0.48, 0.761, 0.93, 1.0, 0.31}[n + a];
    }
    double scale = 0;
    if (body.speed) {
        const double wave = body.k * pi / body.L;
        scale = wave * wave * std::abs(body.A) * body.elastic.M / body.rho;
    }
    return digits<dim>(truth, {at, accuracy, points, scale});
}

/// Points of a ring, the rims among them.
std::vector<std::array<double, 2>> ring_points(double r_i, double r_o) {
    std::vector<std::array<double, 2>> points{{r_i, 0}, {0, -r_o}};
    for (const auto& [share, angle] : {std::array{0.07, 0.3}, {0.31, 2.2}, {0.52, -1.1}, {0.77, 4.0}, {0.98, 5.9}}) {
        const double R = r_i + (r_o - r_i) * share;
        points.push_back({R * std::cos(angle), R * std::sin(angle)});
    }
    return points;
}

Digits digits_of(const RingMms& ring) {
    const Real r_i(ring.r_i), r_o(ring.r_o);
    const Real omega = real_pi * real_c(ring) / (r_i + r_o);
    const Real c1 = -6 * r_i / (r_o * (r_o - 3 * r_i)), c2 = 3 * (r_i + r_o) / (r_o * r_o * (r_o - 3 * r_i));
    const Real c3 = -2 / (r_o * r_o * (r_o - 3 * r_i));
    const Truth<2> truth{[=](const Reals<2>& X, const Real& t) {
                             const Real R = sqrt(X[0] * X[0] + X[1] * X[1]);
                             const Real share = Real(ring.A) * sin(omega * t) * (c1 + c2 * R + c3 * R * R);
                             return Reals<2>{X[0] * share, X[1] * share};
                         },
                         real_lambda(ring),
                         real_mu(ring),
                         ring.rho,
                         r_i,
                         omega};
    const double margin = std::min(1.0, 10 * (1 - ring.largest_strain()));
    const auto accuracy = [=](double t) { return 1e-15 * (8 + ring.omega() * t) / margin; };
    const auto at = [=](const std::array<double, 2>& X, double t) { return ring.at(X, t); };
    return digits<2>(truth, {at, accuracy, ring_points(ring.r_i, ring.r_o)});
}

Digits digits_of(const VortexMms& vortex) {
    const Real r_i(vortex.r_i), r_o(vortex.r_o), width = r_o - r_i;
    const Real omega = vortex.pulse ? Real(*vortex.pulse) : Real(2 * real_pi * real_c(vortex) / (r_i + r_o));
    const Truth<2> truth{
        [=](const Reals<2>& X, const Real& t) {
            const Real s = (sqrt(X[0] * X[0] + X[1] * X[1]) - (r_i + r_o) / 2) / width;
            const Real alpha = Real(vortex.A) * sin(omega * t) * (1 - 8 * s * s + 16 * s * s * s * s);
            return Reals<2>{cos(alpha) * X[0] - sin(alpha) * X[1] - X[0], sin(alpha) * X[0] + cos(alpha) * X[1] - X[1]};
        },
        real_lambda(vortex),
        real_mu(vortex),
        vortex.rho,
        width,
        omega};
    const double stretch = 4 * vortex.r_o / (vortex.r_o - vortex.r_i);
    const auto accuracy = [=](double t) { return 1e-15 * (stretch + vortex.omega() * t) * (1 + std::abs(vortex.A)); };
    const auto at = [=](const std::array<double, 2>& X, double t) { return vortex.at(X, t); };
    return digits<2>(truth, {at, accuracy, ring_points(vortex.r_i, vortex.r_o)});
}

void holds(const Digits& found) {
    INFO(found.where << ": " << found.worst << " of the stated error");
    CHECK(found.worst <= 1);
}

}  // namespace

TEST_CASE("bar_mms: every field is what the motion says, to the stated digits", "[gate]") {
    holds(digits_of(BarMms{}));
    for (const double A : {1e-5, 0.05, -0.2, 0.31}) {
        holds(digits_of(BarMms{.A = A}));
        holds(digits_of(BarMms{.L = 2.7, .A = 2.7 * A, .rho = 13, .elastic = E_nu(211, 0.33)}));
        holds(digits_of(BarMms{.L = 0.01, .A = 0.01 * A, .rho = 0.3, .elastic = E_nu(5, -0.6)}));
    }
}

TEST_CASE("periodic_bar_mms: every field is what the motion says, to the stated digits", "[gate]") {
    holds(digits_of(PeriodicBarMms{}));
    for (const double A : {1e-5, -0.04, 0.158})
        holds(digits_of(PeriodicBarMms{.L = 50, .A = 50 * A, .rho = 1.7, .E = 3}));
}

TEST_CASE("axis_aligned_mms: every field is what the motion says, to the stated digits", "[gate]") {
    holds(digits_of<2>({}));
    holds(digits_of<2>({.A = 1e-4, .phase = {0, pi, 0}}));
    holds(digits_of<2>({.L = 3, .A = -0.4, .rho = 2, .k = 2, .phase = {0.2, 1, 0}, .elastic = E_nu(7, 0.21)}));
    holds(digits_of<2>({.L = 0.2, .A = 1e-6, .k = 300, .elastic = E_nu(7, -0.3)}));
    holds(digits_of<2>({.A = 0.0079,
                        .rho = 1,
                        .speed = 0.6,
                        .elastic = elastic_constants({Elastic::lambda, 0.3}, {Elastic::G, 0.4}, "")}));
    holds(digits_of<3>({.phase = {0, 2.0943951023931953, 4.1887902047863905}, .elastic = E_nu(1e4, 0.3)}));
    holds(digits_of<3>({.A = 0.25, .k = 1, .phase = {0, 1.3, 2}, .elastic = E_nu(1e4, 0)}));
}

TEST_CASE("ring_mms: every field is what the motion says, to the stated digits", "[gate]") {
    holds(digits_of(RingMms{}));
    holds(digits_of(RingMms{.A = -1e-7}));
    holds(digits_of(RingMms{.r_i = 2, .r_o = 3.1, .A = -0.9, .rho = 7, .elastic = E_nu(3, 0.37)}));
    holds(digits_of(RingMms{.r_i = 1, .r_o = 11, .A = 3, .rho = 7, .elastic = E_nu(3, -0.37)}));
    holds(digits_of(RingMms{.r_i = 0.98, .r_o = 1, .A = 0.93, .elastic = E_nu(3, 0.2)}));
}

TEST_CASE("vortex_mms: every field is what the motion says, to the stated digits", "[gate]") {
    holds(digits_of(VortexMms{}));
    holds(digits_of(VortexMms{.A = pi, .elastic = E_nu(1e6, 0.3)}));
    holds(digits_of(VortexMms{.r_i = 0.2, .r_o = 3, .A = -1e-6, .rho = 1.3, .pulse = 1.7, .elastic = E_nu(8, -0.2)}));
    holds(digits_of(VortexMms{.r_i = 0.95, .r_o = 1, .A = 0.2, .rho = 1.3, .elastic = E_nu(8, 0.45)}));
}

TEST_CASE("manufactured motions: a fault of 1e-13 in one field is seen", "[alarm]") {
    const BarMms bar{.A = 0.05, .elastic = E_nu(1e7, 0.3)};
    CHECK(digits_of(bar).worst <= 1);
    CHECK(digits_of(bar, [](MaterialPoint<1>& p) { p.u[0] *= 1 + 1e-13; }).where == "displacement");
    CHECK(digits_of(bar, [](MaterialPoint<1>& p) { p.v[0] *= 1 + 1e-13; }).where == "velocity");
    CHECK(digits_of(bar, [](MaterialPoint<1>& p) { p.stress[0] *= 1 + 1e-13; }).where == "stress");
    CHECK(digits_of(bar, [](MaterialPoint<1>& p) { p.b[0] *= 1 + 1e-13; }).where == "body_force");
    CHECK(digits_of(bar, [](MaterialPoint<1>& p) { p.P[0] = std::nan(""); }).where == "nominal_stress");
}
