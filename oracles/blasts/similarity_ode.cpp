#include "oracles/blasts/similarity_ode.hpp"

#include <cmath>
#include <limits>

namespace ordo::oracles {

void SimilarityOde::Slopes::operator()(double log_y, const double* state, double* slopes) const {
    const double w = state[0];
    const double a = 1 - (j + 2 - omega) / 2;
    const double b1 = omega - (j - 1) * w;
    const double b3 = omega * (1 - gamma) - 2 * a;
    const double H = std::exp(state[2] - state[1] - 2 * log_y);
    const double density = (-a * w - (w - 1) * b1 - H * b3 / (w - 1)) / (gamma * H - (w - 1) * (w - 1));
    slopes[0] = b1 - w - (w - 1) * density;
    slopes[1] = density;
    slopes[2] = b3 / (w - 1) + gamma * density;
    slopes[3] = w * w * std::exp(state[1] + (j + 2) * log_y);
    slopes[4] = std::exp(state[2] + j * log_y);
}

SimilarityOde::SimilarityOde(int j, double gamma, double omega)
    : slopes_{j, gamma, omega},
      start_{2 / (gamma + 1), std::log((gamma + 1) / (gamma - 1)), std::log(2 / (gamma + 1)), 0, 0},
      state_(start_),
      steps_(slopes_, state_.size(), -1e-3, 1e-13) {}

SimilarityOde::State SimilarityOde::inwards_to(double lambda) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    if (!steps_.advance(log_y_, std::log(lambda), state_)) return {nan, nan, nan, nan, nan};
    const double delta = 2 / (slopes_.j + 2 - slopes_.omega);
    return {lambda * state_[0] / start_[0], std::exp(state_[1] - start_[1]), std::exp(state_[2] - start_[2]),
            -delta * delta * state_[3], -delta * delta * state_[4]};
}

}  // namespace ordo::oracles
