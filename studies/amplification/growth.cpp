#include "studies/amplification/growth.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <utility>

#include "core/error.hpp"

namespace ordo::studies {
namespace {

using solvers::Vec;

constexpr int parts = 64;

/// Numbers in [-1, 1], the same at every call: a place in the list has its own.
template <int dim>
void add_noise(std::span<Vec<dim>> v, double amplitude) {
    std::mt19937_64 random;
    for (auto& one : v) {
        for (int axis = 0; axis < dim; ++axis)
            one[axis] += amplitude * (std::ldexp(static_cast<double>(random() >> 10), -53) - 1);
    }
}

/// The body with noise on its velocity.
template <int dim>
solvers::SolidScene<dim> noisy(solvers::SolidScene<dim> body, double amplitude) {
    body.velocity = [amplitude, before = body.velocity](std::span<const Vec<dim>> X, double t, std::span<Vec<dim>> v) {
        std::ranges::fill(v, Vec<dim>::Zero());
        if (before) before(X, t, v);
        add_noise<dim>(v, amplitude);
    };
    return body;
}

}  // namespace

Growths::Growths(Scheme scheme, const Stability& asked, const solvers::Interrupt& interrupt)
    : scheme_(std::move(scheme)), asked_(asked), interrupt_(interrupt), scene_(scheme_.scene) {
    constexpr double amplitude = 1e-9;  // of the wave speed: rest but for round-off, linear to as many digits
    if (solvers::is_solid(scene_)) {
        if (!asked_.as_scene) scene_ = at_rest(scene_);
        scene_ = solvers::on_solid(scene_, [&]<int dim>(const solvers::SolidScene<dim>& body) -> solvers::Scene {
            c_ = std::sqrt(solvers::stiffness(body.law) / body.rho);
            return noisy<dim>(body, amplitude * c_);
        });
        fields_ = {"velocity", "strain"};
    } else {
        if (!asked_.as_scene) throw InputError("", "noise is for bodies; choose 'motion' to be \"scene\"");
        fields_ = scheme_.solver->fields_in ? scheme_.solver->fields_in(scene_) : scheme_.solver->fields;
    }
    try {
        run(asked_.from, [&](const Sizes& now) {
            reference_.resize(now.size(), 0.0);
            for (std::size_t k = 0; k < now.size(); ++k) reference_[k] = std::max(reference_[k], now[k]);
            return true;
        });
    } catch (const solvers::Diverged& error) {
        throw solvers::Diverged("at the lower end of the bracket: " + std::string(error.what()));
    }
}

Growths::Sizes Growths::sizes(const solvers::Snapshot& shot) const {
    const bool body = !shot.weights_undeformed.empty();
    const auto& weights = body ? shot.weights_undeformed : shot.weights;
    Sizes sums;
    for (const auto& field : shot.fields) {
        const auto width = static_cast<std::size_t>(field.components);
        double sum = 0;
        for (std::size_t i = 0; i < field.values.size(); ++i)
            sum += weights[i / width] * field.values[i] * field.values[i];
        sums.push_back(sum);
    }
    if (body) return {std::sqrt(sums[0] / (c_ * c_) + sums[1])};
    for (double& sum : sums) sum = std::sqrt(sum);
    return sums;
}

void Growths::run(double courant, const std::function<bool(const Sizes&)>& tell) const {
    const auto simulation = scheme_.start(scene_, courant, fields_);
    const double dt = scheme_.plan(courant).dt;
    const double steps = std::ceil(asked_.crossings / courant / parts);
    for (int k = 0; k <= parts; ++k) {
        if (k > 0) simulation->advance_to(k * steps * dt, interrupt_);
        const auto now = sizes(simulation->snapshot());
        if (!std::ranges::all_of(now, [](double size) { return std::isfinite(size); }))
            throw solvers::Diverged("a field is not finite");
        if (!tell(now)) return;
    }
}

Growth Growths::at(double courant, bool to_the_end) const {
    Growth found;
    std::vector<double> squares;
    try {
        run(courant, [&](const Sizes& now) {
            squares.push_back(std::inner_product(now.begin(), now.end(), now.begin(), 0.0));
            for (std::size_t k = 0; k < now.size(); ++k) {
                if (now[k] > 0) found.growth = std::max(found.growth, now[k] / reference_[k]);
            }
            if (found.growth > asked_.growth) found.kind = Growth::Class::growing;
            return to_the_end || found.kind == Growth::Class::stable;
        });
    } catch (const solvers::Diverged& error) {
        return {Growth::Class::blown_up, std::numeric_limits<double>::infinity(), 0, error.what()};
    }
    constexpr int quarter = parts / 4;
    if (squares.size() > parts)
        found.kept = std::accumulate(squares.end() - quarter, squares.end(), 0.0) / quarter / squares.front();
    return found;
}

}  // namespace ordo::studies
