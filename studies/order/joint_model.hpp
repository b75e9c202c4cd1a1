#pragma once
// Sums of powers, fitted to logarithms of errors: ln e = ln(A h^p + B dt^q + f), of which parts may be absent.
#include <Eigen/Dense>
#include <optional>

namespace ordo::studies {

/// Which parts a model has, by column of `JointLogs::x`: 0 in h, 1 in dt, 2 the floor.
using Parts3 = Eigen::Array<bool, 3, 1>;

/// Logarithms of a grid's points. The abscissae are centred, so that orders and amplitudes are nearly independent.
struct JointLogs {
    Eigen::MatrixX3d x;  ///< n x 3: ln h - centre(0), ln dt - centre(1), 0
    Eigen::VectorXd y;   ///< n, ln e
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
};

/// A model with its parameters: for each part its log-amplitude at the centre, and behind that, unless it is the floor,
/// its order.
struct JointModel {
    Parts3 parts = Parts3::Constant(false);
    Eigen::VectorXd theta;
    double squares = 0;  ///< sum of squared residuals in ln e

    Eigen::Index amplitude(int part) const;  ///< place of its log-amplitude in theta; the order is behind it
    /// n x 3: what each part is of the whole; with it `value`, n, ln e of the model.
    Eigen::MatrixX3d shares(const Eigen::MatrixX3d& x, Eigen::VectorXd* value = nullptr) const;
    /// n x theta: derivatives of ln e; a part's share, and its share times its abscissa.
    Eigen::MatrixXd jacobian(const Eigen::MatrixX3d& x) const;
};

/// Number of parameters of a model with these parts.
Eigen::Index parameters_of(const Parts3& parts);

/// The least squares of these parts, best of several starts; nothing where there are fewer points than parameters + 1.
std::optional<JointModel> fitted_model(const JointLogs& logs, const Parts3& parts);

/// The model that the points ask for: parts are added while Akaike's corrected criterion and an F-test want them.
JointModel selected_model(const JointLogs& logs);

/// P-value of the F-test that `squares` fall to `fewer` by chance, as `added` parameters leave `freedom` degrees of
/// freedom. Squares below round-off of n logarithms count as that.
double chance_of(double squares, double fewer, double added, double freedom);

}  // namespace ordo::studies
