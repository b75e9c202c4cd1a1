#include "solvers/mpm/basis/particle_basis.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>

namespace ordo::solvers::mpm {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// The columns of S that hold more than round-off.
std::vector<Eigen::Index> touched_nodes(const Picture& picture) {
    std::vector<Eigen::Index> nodes;
    for (std::size_t i = 0; i < picture.touched.size(); ++i) {
        if (picture.touched[i]) nodes.push_back(static_cast<Eigen::Index>(i));
    }
    return nodes;
}

/// The grid's functions at x; NaN in the rows of points that feel an untouched node.
Weights where_there_is_a_field(const Picture& picture, std::span<const double> x) {
    Weights N = grid_functions(picture, x);
    for (Eigen::Index k = 0; k < N.rows(); ++k) {
        bool covered = true;
        for (Eigen::Index i = 0; i < N.cols(); ++i)
            covered = covered && (picture.touched[static_cast<std::size_t>(i)] || N(k, i) <= negligible);
        if (!covered) N.row(k).setConstant(nan);
    }
    return N;
}

/// Largest absolute value, NaN left out; NaN of nothing.
double largest(const Eigen::VectorXd& values) {
    double most = nan;
    for (const double value : values) most = std::isnan(value) ? most : std::fmax(most, std::abs(value));
    return most;
}

}  // namespace

NodalMap nodal_map(const Picture& picture, Mapping mapping) {
    const auto nodes = touched_nodes(picture);
    const Weights S = picture.S(Eigen::all, nodes);
    Eigen::CompleteOrthogonalDecomposition<Weights> decomposition;
    decomposition.setThreshold(negligible);
    decomposition.compute(S);
    NodalMap map{Weights::Zero(picture.nodes(), picture.count()), decomposition.rank()};
    if (mapping == Mapping::pseudo_inverse) {
        const Weights inverse = decomposition.pseudoInverse();
        map.T(nodes, Eigen::all) = inverse;
        return map;
    }
    for (const auto i : nodes) map.T.row(i) = picture.S.col(i).transpose() / picture.S.col(i).sum();
    return map;
}

Weights particle_basis(const Picture& picture, const NodalMap& map, std::span<const double> x) {
    return where_there_is_a_field(picture, x) * map.T;
}

Reproduced reproduced(const Picture& picture, const NodalMap& map, const Eigen::VectorXd& f,
                      std::span<const double> x) {
    const Eigen::VectorXd nodal = map.T * f;
    return {picture.S * nodal, where_there_is_a_field(picture, x) * nodal};
}

Errors errors_of(const Picture& picture, const NodalMap& map) {
    const Eigen::VectorXd x_p = picture.positions();
    const std::vector<double> x = points_between_particles(picture);
    const Eigen::VectorXd places = Eigen::Map<const Eigen::VectorXd>(x.data(), static_cast<Eigen::Index>(x.size()));
    Errors errors;
    for (std::size_t degree = 0; degree < 2; ++degree) {
        const Eigen::VectorXd f = degree == 0 ? Eigen::VectorXd::Ones(x_p.size()) : x_p;
        const Eigen::VectorXd exact = degree == 0 ? Eigen::VectorXd::Ones(places.size()) : places;
        const auto [at_particles, at_x] = reproduced(picture, map, f, x);
        errors.at_particles[degree] = largest(at_particles - f);
        errors.between[degree] = largest(at_x - exact);
    }
    const Weights phi = particle_basis(picture, map, x);
    errors.amplification = largest(phi.cwiseAbs().rowwise().sum());
    errors.without_field = static_cast<double>(phi.col(0).array().isNaN().count()) / static_cast<double>(phi.rows());
    return errors;
}

}  // namespace ordo::solvers::mpm
