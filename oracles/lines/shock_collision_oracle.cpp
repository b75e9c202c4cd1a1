// shock_collision as a line of the catalogue: declarations, constants, and how to fill in the numbers.
#include "oracles/features.hpp"
#include "oracles/lines/shock_collision.hpp"
#include "oracles/riemann/gas_record.hpp"

namespace ordo::oracles {
namespace {

Constants constants_of(const ShockCollision& flow) {
    Constants constants{{"t_c", flow.meeting_time()}, {"x_c", flow.meeting_place()}, {"t_end", flow.end_time()}};
    const auto add = [&](const std::string& ending, const RiemannGas& problem) {
        const GasStar& star = problem.star();
        constants.push_back({"p_star" + ending, star.p});
        constants.push_back({"v_star" + ending, star.vacuum ? std::numeric_limits<double>::quiet_NaN() : star.v});
        constants.push_back({"rho_star_L" + ending, star.left.rho});
        constants.push_back({"rho_star_R" + ending, star.right.rho});
    };
    add("_left", flow.from_left());
    add("_right", flow.from_right());
    if (flow.after()) add("_after", *flow.after());
    return constants;
}

Exact bind(const Values& values) {
    const ShockCollision flow(gas_from(values, "_L"), gas_from(values, "_M"), gas_from(values, "_R"),
                              values.number("x_L"), values.number("x_R"));
    constexpr double furthest = std::numeric_limits<double>::max();
    Exact exact{.dim = 1,
                .coordinates = Coordinates::spatial,
                .lower = {-furthest},
                .upper = {furthest},
                .times = between(0, flow.end_time()),
                .fields = gas_fields(),
                .sample = along_a_line([flow](double x, double t) { return flow.at(x, t).row(); }),
                .averages = over_cells([flow](double a, double b, double t) { return flow.mean(a, b, t).row(); }),
                .jumps = [flow](double t) { return flow.jumps(t); },
                .waves = [flow](double t) { return flow.waves(t); },
                .constants = [flow](std::optional<double>) { return constants_of(flow); }};
    exact.features = features_of_waves(exact);
    return exact;
}

std::vector<Parameter> parameters() {
    auto list = gas_parameters("_L", {.rho = 0.3, .v = 0.6, .p = 0.4}, "on the left of x_L");
    list = appended(list, gas_parameters("_M", {.rho = 0.1, .v = 0, .p = 0.2}, "between x_L and x_R"));
    list = appended(list, gas_parameters("_R", {.rho = 0.6, .v = -0.6, .p = 0.5}, "on the right of x_R"));
    return appended(list, {gamma_parameter(), number("x_L", "m", -5, finite, "left end of the middle gas at t = 0"),
                           number("x_R", "m", 5, finite, "right end of the middle gas at t = 0")});
}

}  // namespace

Oracle shock_collision() {
    return {
        .name = "shock_collision",
        .about = "Three uniform gases: two Riemann problems, and where their shocks meet a third",
        .source = {"Walker2012", "Toro2009"},
        .explanation =
            "Ideal gases (rho, v, p) on the left of x_L, between x_L and x_R, and on the right of x_R at t = 0. The\n"
            "defaults are the inrush: gas streams from both sides into a thinner one.\n"
            "Until t_c the flow is one Riemann problem at x_L beside another at x_R (oracle riemann_gas). At t_c "
            "their\n"
            "innermost waves meet at x_c. Where both are shocks, the states behind them touch there and begin a third\n"
            "Riemann problem, exact until t_end, when its outer waves reach the contact (or the next wave) of the "
            "first\n"
            "or second. Where any other waves meet, t_end = t_c; where none ever meet, t_end is infinite. Later times "
            "are\n"
            "refused (nearest: t_end).\n"
            "x is the position in space. At a jump the state on its right holds. energy is internal, per mass.\n"
            "Means over cells are exact in all fields, as those of riemann_gas.\n"
            "Refused: x_L >= x_R.\n"
            "constants: t_c, x_c, t_end; p_star, v_star, rho_star_L, rho_star_R of the problems _left (at x_L), _right "
            "(at\n"
            "x_R) and _after (at x_c)",
        .example = "shock_collision --t 3 --grid -7:7:29",
        .parameters = parameters(),
        .fields = gas_fields(),
        .smoothness = "jumps at shocks and contacts; fans have kinks at head and tail, and are analytic inside",
        .accuracy = "as riemann_gas in each of the three problems; places 1e-13 of x_R - x_L and of t times the speeds",
        .bind = bind};
}

}  // namespace ordo::oracles
