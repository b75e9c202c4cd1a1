#pragma once
// Smooth walls: the sums of a node gain those of its mirror image.

namespace ordo::bench {

/// Nodes one by one, each as [m, momentum, force][lane].
struct Wall {
    int dim, lanes;
    int axis;      ///< the wall's normal
    int from, to;  ///< lanes that lie at the wall

    /// Two nodes that are each other's image, or one that stands on the wall.
    void operator()(double* one, double* other) const {
        for (int q = 0; q < 1 + 2 * dim; ++q) {
            const double sign = q == 1 + axis || q == 1 + dim + axis ? -1 : 1;
            for (int k = q * lanes + from; k < q * lanes + to; ++k) {
                const double sum = one[k] + sign * other[k];
                one[k] = sum;
                other[k] = sign * sum;
            }
        }
    }
};

}  // namespace ordo::bench
