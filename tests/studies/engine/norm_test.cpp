#include "studies/engine/norm.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "tests/catch.hpp"

using namespace ordo::studies;

namespace {

const std::vector<Norm> all_norms{Norm::rms, Norm::l1, Norm::l2, Norm::linf};

/// Norm of an error field itself: found = error, exact = 0.
double norm_of(Norm norm, const std::vector<double>& error, const std::vector<double>& weights, int components = 1) {
    return error_norm(norm, error, std::vector<double>(error.size(), 0.0), weights, components);
}

}  // namespace

TEST_CASE("norm: a constant error has the same norm on twice as many equal cells", "[unit]") {
    // Error 0.75 on a body of volume 4: l1 = 3, l2 = 0.75 sqrt 4; binary fractions, so that the sums are exact.
    for (const std::size_t cells : {1, 2, 4, 8, 256}) {
        const std::vector<double> error(cells, -0.75);
        const std::vector<double> weights(cells, 4.0 / static_cast<double>(cells));
        CHECK(norm_of(Norm::rms, error, weights) == 0.75);
        CHECK(norm_of(Norm::l1, error, weights) == 3);
        CHECK(norm_of(Norm::l2, error, weights) == 1.5);
        CHECK(norm_of(Norm::linf, error, weights) == 0.75);
    }
}

TEST_CASE("norm: weights stand at the right place", "[unit]") {
    // Errors 3 and 4 on volumes 1 and 1/4.
    const std::vector<double> found{13, 16};
    const std::vector<double> exact{10, 20};
    const std::vector<double> weights{1, 0.25};
    const auto norm = [&](Norm kind) { return error_norm(kind, found, exact, weights, 1); };
    CHECK(norm(Norm::rms) == Approx(std::sqrt((9 + 16) / 2.0)).epsilon(1e-15));  // points count alike
    CHECK(norm(Norm::l1) == Approx(3 + 0.25 * 4).epsilon(1e-15));
    CHECK(norm(Norm::l2) == Approx(std::sqrt(9 + 0.25 * 16)).epsilon(1e-15));  // the weight is not squared
    CHECK(norm(Norm::linf) == 4);                                              // and not weighted
}

TEST_CASE("norm: a vector's error is its Euclidean length, point by point", "[unit]") {
    const std::vector<double> error{3, 4, 0, -12};  // lengths 5 and 12
    const std::vector<double> weights{0.5, 2};
    CHECK(norm_of(Norm::rms, error, weights, 2) == Approx(std::sqrt((25 + 144) / 2.0)).epsilon(1e-15));
    CHECK(norm_of(Norm::l1, error, weights, 2) == Approx(0.5 * 5 + 2 * 12).epsilon(1e-15));
    CHECK(norm_of(Norm::l2, error, weights, 2) == Approx(std::sqrt(0.5 * 25 + 2 * 144)).epsilon(1e-15));
    CHECK(norm_of(Norm::linf, error, weights, 2) == 12);
    // A 2D tensor has four numbers a point.
    CHECK(norm_of(Norm::linf, {1, 1, 1, 1}, {1}, 4) == 2);
}

TEST_CASE("norm: it scales with the error, does not see its sign, and is zero for none", "[unit]") {
    const std::vector<double> error{0.1, -0.7, 0.3};
    const std::vector<double> opposite{-0.4, 2.8, -1.2};
    const std::vector<double> weights{0.2, 0.3, 0.5};
    for (const Norm norm : all_norms) {
        INFO(text_of(norm));
        CHECK(norm_of(norm, opposite, weights) == Approx(4 * norm_of(norm, error, weights)).epsilon(1e-15));
        CHECK(norm_of(norm, {0, 0, 0}, weights) == 0);
        CHECK(error_norm(norm, error, opposite, weights, 1) == error_norm(norm, opposite, error, weights, 1));
    }
}

TEST_CASE("norm: NaN stays NaN wherever it stands, and infinity does not vanish", "[alarm]") {
    const double inf = std::numeric_limits<double>::infinity();
    for (const Norm norm : all_norms) {
        INFO(text_of(norm));
        for (std::size_t at = 0; at < 4; ++at) {
            std::vector<double> error{1, 2, 3, 4};
            error[at] = std::nan("");
            CHECK(std::isnan(norm_of(norm, error, {1, 1, 1, 1})));
            CHECK(std::isnan(norm_of(norm, error, {1, 1}, 2)));
            CHECK(std::isnan(error_norm(norm, std::vector<double>(4, 1.0), error, std::vector<double>(4, 1.0), 1)));
            error[at] = inf;
            CHECK_FALSE(std::isfinite(norm_of(norm, error, {1, 1, 1, 1})));
        }
    }
}

TEST_CASE("norm: what is about waves is no norm over points", "[alarm]") {
    for (const Norm norm : {Norm::l1_fans, Norm::shock, Norm::contact, Norm::fan_edge}) {
        INFO(text_of(norm));
        CHECK_THROWS_AS(norm_of(norm, {1, 2}, {1, 1}), std::logic_error);
    }
}
