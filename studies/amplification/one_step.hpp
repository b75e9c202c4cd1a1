#pragma once
// The matrix of one step, assembled from the solver itself: each column is a step of a run that was started with one
// number off rest.
#include <Eigen/Core>
#include <vector>

#include "studies/amplification/scheme.hpp"

namespace ordo::studies {

/// Whether velocities and what else the solver names are all that a step of this scheme carries on: not of transfers
/// that keep a velocity gradient with each particle.
bool has_matrix(const Scheme& scheme);

/// What a step carries on, made dimensionless: velocities over c, then strains, or displacements over h, of all points.
/// Positions are those of the start: about rest, that points move is an effect of second order.
class OneStep {
public:
    /// Throws InputError for a scheme without a matrix.
    explicit OneStep(Scheme scheme);

    Eigen::Index points() const { return points_; }
    /// The columns of points first to first + count of both halves: rows 2 points, columns 2 count. By central
    /// differences, so that an even term in the amplitude is lost; accurate to 1e-10.
    Eigen::MatrixXd columns(double courant, Eigen::Index first, Eigen::Index count) const;
    Eigen::MatrixXd matrix(double courant) const { return columns(courant, 0, points_); }

private:
    Eigen::VectorXd stepped(double courant, Eigen::Index column, double amplitude) const;

    Scheme scheme_;
    solvers::SolidScene<1> still_;
    double c_;
    double h_;
    Eigen::Index points_;
};

/// Largest modulus of an eigenvalue.
double spectral_radius(const Eigen::MatrixXd& matrix);

/// The same operator for waves on a periodic body of equal cells: entry n is what a step does to the points of a cell
/// when all cells carry the same up to the phase exp(2 pi i n / cells); n = 0 to cells / 2.
std::vector<Eigen::MatrixXcd> waves_of(const OneStep& step, double courant, Eigen::Index cells);

double spectral_radius(const std::vector<Eigen::MatrixXcd>& waves);

}  // namespace ordo::studies
