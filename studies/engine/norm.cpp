#include "studies/engine/norm.hpp"

#include <cmath>
#include <stdexcept>

namespace ordo::studies {

double error_norm(Norm norm, std::span<const double> found, std::span<const double> exact,
                  std::span<const double> weights, int components) {
    if (norm > Norm::linf) throw std::logic_error("error_norm: " + text_of(norm) + " is no norm over points");
    const std::size_t n = weights.size();
    const std::size_t c = static_cast<std::size_t>(components);
    if (n == 0 || found.size() != n * c || exact.size() != n * c) throw std::logic_error("error_norm: shapes differ");
    double sum = 0;
    double largest = 0;
    for (std::size_t i = 0; i < n; ++i) {
        double square = 0;
        for (std::size_t k = i * c; k < (i + 1) * c; ++k) square += (found[k] - exact[k]) * (found[k] - exact[k]);
        const double length = std::sqrt(square);
        if (std::isnan(length)) return length;
        largest = length > largest ? length : largest;
        sum += norm == Norm::rms ? square : norm == Norm::l1 ? weights[i] * length : weights[i] * square;
    }
    switch (norm) {
        case Norm::rms: return std::sqrt(sum / static_cast<double>(n));
        case Norm::l1: return sum;
        case Norm::l2: return std::sqrt(sum);
        default: break;
    }
    return largest;
}

}  // namespace ordo::studies
