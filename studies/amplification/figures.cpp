#include "studies/amplification/figures.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>

#include "studies/amplification/limits.hpp"

namespace ordo::studies {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// What a figure is found from, and the run in which it says what else it saw.
struct Question {
    Scheme scheme;
    Stability asked;
    double courant;  ///< of the resolution; that of the planned step
    const solvers::Interrupt& interrupt;
    Run& run;
};

double finite_or_none(double value) { return std::isfinite(value) ? value : none; }

double by_runs(const Question& of) {
    const Growths growths(of.scheme, of.asked, of.interrupt);
    const auto is_stable = [&](double courant) { return growths.at(courant, false).kind == Growth::Class::stable; };
    const Limit limit = first_limit(is_stable, of.asked);
    if (!std::isfinite(limit.value())) {
        of.run.reason = fmt::format("stable in the whole bracket, to a Courant number of {}", of.asked.to);
        return none;
    }
    const Growth beyond = growths.at(limit.unstable, true);
    of.run.reason =
        beyond.kind == Growth::Class::blown_up
            ? fmt::format("at a Courant number of {:.4g}: {}", limit.unstable, beyond.why)
            : fmt::format("at a Courant number of {:.4g} it grows {:.3g} times", limit.unstable, beyond.growth);
    return limit.value();
}

double by_matrix(const Question& of) { return finite_or_none(limit_by_matrix(of.scheme, of.asked).value()); }

double by_theory(const Question& of) { return limit_by_theory(of.scheme).value_or(none); }

double largest_eigenvalue(const Question& of) { return radius(OneStep(of.scheme), of.scheme, of.courant); }

/// Of a run. One that blows up is a diverged one, which has its other figures all the same.
double of_run(const Question& of, double Growth::*number) {
    const Growth found = Growths(of.scheme, of.asked, of.interrupt).at(of.courant, true);
    if (found.kind != Growth::Class::blown_up) return found.*number;
    of.run.status = Status::diverged;
    of.run.reason = found.why;
    return none;
}

struct Figure {
    const char* name;
    const char* words;
    bool at_courant;  ///< of one Courant number, else of all
    double (*find)(const Question&);
};

constexpr std::array figures{
    Figure{"limit_by_runs", "largest stable Courant number, by bisection on runs", false, by_runs},
    Figure{"limit_by_matrix", "the same, by the spectral radius of one step's matrix", false, by_matrix},
    Figure{"limit_by_theory",
           "the same in closed form where one is known, of particles in tents: on a bar without ends", false,
           by_theory},
    Figure{"spectral_radius", "largest modulus of an eigenvalue of one step", true, largest_eigenvalue},
    Figure{"growth", "largest norm of a run over that of a run at a small step", true,
           [](const Question& of) { return of_run(of, &Growth::growth); }},
    Figure{"energy_kept", "mean energy in the last quarter of a run over that at its start", true,
           [](const Question& of) { return of_run(of, &Growth::kept); }},
    Figure{"wave_speed", "speed of the wave as long as a periodic body, over the exact one", true,
           [](const Question& of) { return longest_wave(of.scheme, of.courant).speed; }},
    Figure{"wave_gain", "factor of one step on the amplitude of that wave", true,
           [](const Question& of) { return longest_wave(of.scheme, of.courant).gain; }},
};

const Figure& figure_named(const std::string& name) {
    return *std::ranges::find_if(figures, [&](const Figure& figure) { return figure.name == name; });
}

}  // namespace

const std::vector<std::string>& stability_names() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        for (const auto& figure : figures) all.emplace_back(figure.name);
        return all;
    }();
    return names;
}

std::string stability_words(const std::string& name) { return figure_named(name).words; }

bool is_at_courant(const std::string& name) { return figure_named(name).at_courant; }

void find_stability(const RunSpec& spec, const Parts& parts, const solvers::Interrupt& interrupt, Run& run) {
    const Question of{.scheme = {.scene = parts.scene(spec.scene.name).problem(spec.scene.values),
                                 .solver = &parts.solver(spec.solver.name),
                                 .options = spec.solver.options,
                                 .resolution = spec.resolution},
                      .asked = *spec.measure.stability,
                      .courant = spec.courant,
                      .interrupt = interrupt,
                      .run = run};
    for (const auto& quantity : spec.measure.quantities)
        run.errors.push_back({quantity.key(), figure_named(quantity.key()).find(of)});
}

}  // namespace ordo::studies
