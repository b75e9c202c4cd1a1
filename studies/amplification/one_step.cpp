#include "studies/amplification/one_step.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <complex>
#include <utility>

#include "core/error.hpp"

namespace ordo::studies {
namespace {

using solvers::Tensor;
using solvers::Vec;

/// Truncation falls with its square, round-off grows with its inverse: both are about 1e-11 here.
constexpr double small = 3e-6;

solvers::VectorField<1> one_off(std::size_t k, double value) {
    return [=](std::span<const Vec<1>>, double, std::span<Vec<1>> out) {
        std::ranges::fill(out, Vec<1>(0.0));
        if (k < out.size()) out[k] = Vec<1>(value);
    };
}

solvers::TensorField<1> one_stretched(std::size_t k, double strain) {
    return [=](std::span<const Vec<1>>, double, std::span<Tensor<1>> out) {
        std::ranges::fill(out, Tensor<1>::Identity());
        if (k < out.size()) out[k](0, 0) += strain;
    };
}

constexpr std::size_t nobody = static_cast<std::size_t>(-1);

}  // namespace

bool has_matrix(const Scheme& scheme) {
    if (!std::holds_alternative<solvers::SolidScene<1>>(scheme.scene) || scheme.solver->carries.empty()) return false;
    if (find_parameter(scheme.solver->options, "transfer") == nullptr) return true;
    const std::string transfer = scheme.options.word("transfer");
    return transfer != "apic" && transfer != "tpic" && transfer != "mls";
}

OneStep::OneStep(Scheme scheme) : scheme_(std::move(scheme)), still_(at_rest(scheme_.scene)), c_(wave_speed(still_)) {
    if (!has_matrix(scheme_))
        throw InputError("",
                         "the steps of solver " + scheme_.solver->name + " carry on more than a matrix here knows of");
    h_ = scheme_.plan(1).h;
    std::size_t asked = 0;
    solvers::SolidScene<1> counting = still_;
    counting.velocity = [&](std::span<const Vec<1>> X, double, std::span<Vec<1>> v) {
        asked = X.size();
        std::ranges::fill(v, Vec<1>(0.0));
    };
    points_ = static_cast<Eigen::Index>(scheme_.start(counting, 1, {})->snapshot().points());
    if (static_cast<Eigen::Index>(asked) != points_)
        throw InputError("", "solver " + scheme_.solver->name + " shows other points than it is started from");
}

Eigen::VectorXd OneStep::stepped(double courant, Eigen::Index column, double amplitude) const {
    const bool moves = column < points_;
    const auto k = static_cast<std::size_t>(moves ? column : column - points_);
    const bool strains = scheme_.solver->carries == "strain";
    solvers::SolidScene<1> scene = still_;
    if (moves) scene.velocity = one_off(k, amplitude * c_);
    else if (strains) scene.deformed = {one_off(nobody, 0), one_stretched(k, amplitude)};
    else scene.deformed = {one_off(k, amplitude * h_), one_stretched(nobody, 0)};
    const auto simulation = scheme_.start(scene, courant, {"velocity", scheme_.solver->carries});
    simulation->advance_to(scheme_.plan(courant).dt, [] { return false; });
    const auto shot = simulation->snapshot();
    const auto& v = shot.field("velocity").values;
    const auto& carried = shot.field(scheme_.solver->carries).values;
    Eigen::VectorXd state(2 * points_);
    state.head(points_) = Eigen::Map<const Eigen::VectorXd>(v.data(), points_) / c_;
    state.tail(points_) = Eigen::Map<const Eigen::VectorXd>(carried.data(), points_) / (strains ? 1 : h_);
    return state;
}

Eigen::MatrixXd OneStep::columns(double courant, Eigen::Index first, Eigen::Index count) const {
    Eigen::MatrixXd out(2 * points_, 2 * count);
    for (Eigen::Index k = 0; k < 2 * count; ++k) {
        const Eigen::Index column = k < count ? first + k : points_ + first + k - count;
        out.col(k) = (stepped(courant, column, small) - stepped(courant, column, -small)) / (2 * small);
    }
    return out;
}

double spectral_radius(const Eigen::MatrixXd& matrix) {
    return Eigen::EigenSolver<Eigen::MatrixXd>(matrix, false).eigenvalues().cwiseAbs().maxCoeff();
}

std::vector<Eigen::MatrixXcd> waves_of(const OneStep& step, double courant, Eigen::Index cells) {
    const Eigen::Index in_cell = step.points() / cells;
    const Eigen::MatrixXd columns = step.columns(courant, 0, in_cell);
    std::vector<Eigen::MatrixXcd> waves;
    for (Eigen::Index n = 0; 2 * n <= cells; ++n) {
        Eigen::MatrixXcd sum = Eigen::MatrixXcd::Zero(2 * in_cell, 2 * in_cell);
        for (Eigen::Index cell = 0; cell < cells; ++cell) {
            // What cell 0 gives to `cell` is what `-cell` gives to cell 0.
            const double phase = -2 * boost::math::constants::pi<double>() * static_cast<double>(n * cell % cells) /
                                 static_cast<double>(cells);
            for (const Eigen::Index half : {0, 1})
                sum.middleRows(half * in_cell, in_cell) +=
                    std::polar(1.0, phase) * columns.middleRows(half * step.points() + cell * in_cell, in_cell);
        }
        waves.push_back(std::move(sum));
    }
    return waves;
}

double spectral_radius(const std::vector<Eigen::MatrixXcd>& waves) {
    double largest = 0;
    for (const auto& wave : waves)
        largest = std::max(
            largest, Eigen::ComplexEigenSolver<Eigen::MatrixXcd>(wave, false).eigenvalues().cwiseAbs().maxCoeff());
    return largest;
}

}  // namespace ordo::studies
