#include "oracles/bars/oedometer.hpp"

#include <boost/math/constants/constants.hpp>

#include "core/elastic_constants.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "oracles/bars/end_load.hpp"
#include "oracles/bars/gravity.hpp"

namespace ordo::oracles {
namespace {

const std::string where = "oracle oedometer";
constexpr double longest_ramp = 1e4;  // transits: a point costs as many pieces

/// The column at one time: the load's fields and gravity's, added, or the series.
class Column {
public:
    Column(const Oedometer& column, double t)
        : column_(column),
          t_(t),
          load_(column.H, column.wave_speed(), column.p0 / column.E, t),
          gravity_({column.H, column.wave_speed(), column.g}, {column.ramp}, t) {}

    bars::Fields at(double y) const {
        return column_.terms > 0 ? column_.series(y, y, t_, column_.terms) : load_.at(y) + gravity_.at(y);
    }
    bars::Fields mean(double a, double b) const {
        return column_.terms > 0 ? column_.series(a, b, t_, column_.terms) : load_.mean(a, b) + gravity_.mean(a, b);
    }

private:
    Oedometer column_;
    double t_;
    bars::StepLoad load_;
    bars::Gravity gravity_;
};

Oedometer column_from(const Values& values) {
    const Oedometer column{.H = values.number("H"),
                           .E = youngs_modulus(values, 5e4, "oracle oedometer"),
                           .rho = values.number("rho"),
                           .g = values.number("g"),
                           .p0 = values.number("p0"),
                           .terms = values.whole("terms"),
                           .ramp = values.number("ramp")};
    const auto& [H, E, rho, g, p0, terms, ramp] = column;
    bars::require_waves(H, E, rho, where);
    const double c = column.wave_speed();
    for (const double scale : {p0 / E, p0 / E * H, p0 / E * c, 4 * p0}) bars::require_finite(4 * scale, "p0", where);
    for (const double scale : {g * H / (c * c), g * H / c * (H / c), g * H / c, g * rho * H, 1 / (c * c)})
        bars::require_finite(4 * scale, "rho g H / E", where);
    const double transits = ramp * c / H;
    if (transits > longest_ramp)
        throw InputError(where, "ramp = " + shortest(ramp) + " s is " + shortest(transits) +
                                    " transits H / c, but must be at most 1e4 of them, " +
                                    shortest(longest_ramp * H / c) + " s; oedometer_static has the state at rest");
    return column;
}

Constants constants_of(const Oedometer& column, std::optional<double> t) {
    const auto& [H, E, rho, g, p0, terms, ramp] = column;
    Constants list{{"wave_speed", column.wave_speed()},
                   {"first_eigenfrequency", column.first_eigenfrequency()},
                   {"period", 4 * H / column.wave_speed()},
                   {"static_top_displacement", (p0 - rho * g * H / 2) * H / E}};
    if (terms > 0) list.push_back({"truncation_bound", column.series_bound(terms)});
    if (t) {
        list.push_back({"load_front", column.load_front(*t)});
        list.push_back({"gravity_front", column.gravity_front(*t)});
    }
    return list;
}

/// Fronts of the load and of gravity; a ramp begins and ends like s^3 in the force, s^5 in the displacement.
std::vector<Feature> features_of(const Oedometer& column, const std::string& field, double t) {
    std::vector<Feature> features;
    const auto add = [&](double x, int derivative) { features.push_back(bars::front_feature(field, x, derivative)); };
    if (column.terms > 0) return {};
    if (column.p0 != 0) add(column.load_front(t), 1);
    if (column.g != 0) add(column.gravity_front(t), column.ramp > 0 ? 5 : 2);
    if (column.g != 0 && column.ramp > 0 && t > column.ramp) add(column.gravity_front(t - column.ramp), 5);
    return features;
}

Exact bind(const Values& values) {
    const Oedometer column = column_from(values);
    const auto at = [column](double t) { return Column(column, t); };
    const bool jumps = column.p0 != 0 && column.terms == 0;
    return {
        .dim = 1,
        .coordinates = Coordinates::material,
        .lower = {0},
        .upper = {column.H},
        .times = between(0, bars::most_radians * column.H / column.wave_speed()),
        .fields = standard_fields(),
        .sample = bars::points_of(at, column.E),
        .averages = bars::cells_of(at, column.E),
        .jumps = [column, jumps](
                     double t) { return jumps && t > 0 ? std::vector{column.load_front(t)} : std::vector<double>{}; },
        .features = [column](const std::string& field, double t) { return features_of(column, field, t); },
        .constants = [column](std::optional<double> t) { return constants_of(column, t); }};
}

constexpr const char* explanation =
    "rho u_tt = E u_yy - rho g r(t) on 0 <= y <= H;  u(0, t) = 0,  E u_y(H, t) = p0 for t > 0,  at rest at t = 0\n"
    "gravity acts towards -y; p0 > 0 is tension; c = sqrt(E / rho)\n"
    "terms = 0: exact, by images, in closed form; free fall that waves from the base take back,\n"
    "  u = -G(t) + sum_{m >= 0} (-1)^m [ G(t - (2mH + y)/c) + G(t - ((2m+2)H - y)/c) ],  G'' = g r,  and\n"
    "  u = sum_{m >= 0} (-1)^m [ I(t - ((2m+1) H - y)/c) - I(t - ((2m+1) H + y)/c) ],  I(s) = c p0 s / E\n"
    "terms = N: (rho g/2E) y^2 + (p0 - rho g H) y/E + sum_{n <= N} u_n cos(omega_n t) sin(k_n y),\n"
    "  u_n = 16 rho g H^2 / ((2n-1)^3 pi^3 E) + 8 H p0 (-1)^n / ((2n-1)^2 pi^2 E),  k_n = (2n-1) pi / (2H)\n"
    "  as papers print it (20 terms); velocity, strain and stress are its derivatives, Gibbs oscillations included\n"
    "ramp = T: r = s^3 (10 - 15 s + 6 s^2), s = t / T, then 1 (p0 stays sudden); the series' gravity follows r, its\n"
    "  cos(omega_n t) becoming int r'(s) cos(omega_n (t - s)) ds\n"
    "x is the position y in the undeformed column; exact at any strain where the nominal stress is E (F - 1)\n"
    "refused: a ramp of more than 1e4 transits H / c, which a point would pay for; t beyond 1e12 transits\n"
    "constants: wave_speed, first_eigenfrequency, period (4 H / c), static_top_displacement, truncation_bound (with\n"
    "terms: of the displacement), with --t load_front and gravity_front";

}  // namespace

double Oedometer::wave_speed() const { return std::sqrt(E / rho); }
double Oedometer::first_eigenfrequency() const { return boost::math::constants::half_pi<double>() * wave_speed() / H; }
double Oedometer::load_front(double t) const { return bars::StepLoad(H, wave_speed(), p0 / E, t).front(); }
double Oedometer::gravity_front(double t) const { return bars::Fall{H, wave_speed(), g}.front(t); }

bars::Fields Oedometer::at(double y, double t) const { return Column(*this, t).at(y); }
bars::Fields Oedometer::mean(double a, double b, double t) const { return Column(*this, t).mean(a, b); }
double Oedometer::displacement(double y, double t) const { return at(y, t).displacement; }
double Oedometer::velocity(double y, double t) const { return at(y, t).velocity; }
double Oedometer::strain(double y, double t) const { return at(y, t).strain; }
double Oedometer::stress(double y, double t) const { return E * strain(y, t); }

Oracle oedometer() {
    return {.name = "oedometer",
            .about =
                "Elastic column under sudden or ramped gravity and a sudden load on its top; exact or truncated series",
            .source = {"WobbesTielen2015", "MPMtry"},
            .explanation = explanation,
            .example = "oedometer --set p0=-100 --t 0.5 --grid 0:25:101",
            .parameters = with_youngs_modulus(
                {number("H", "m", 25, positive, "height"), number("rho", "kg/m", 1, positive, "density"),
                 number("g", "m/s^2", 9.81, at_least(0), "gravity, towards -y"),
                 number("p0", "Pa", 0, finite, "nominal traction on the top from t = 0 on, tension positive"),
                 whole("terms", 0, between(0, 100'000), "terms of the series; 0 is the exact solution"),
                 number("ramp", "s", 0, at_least(0), "time over which gravity grows from 0 to g, 0 = at once")},
                5e4),
            .fields = standard_fields(),
            .smoothness =
                "displacement continuous; sudden gravity: velocity and stress with a kink at gravity_front; "
                "p0: velocity and stress jump at load_front; ramped gravity alone: displacement four "
                "times continuously differentiable; series: analytic",
            .accuracy = "1e-14 (1 + c t / H) of the field's largest value in a period 4 H / c",
            .bind = bind};
}

}  // namespace ordo::oracles
