#include "solvers/rrm/error_metric.hpp"

#include <limits>

#include "tests/catch.hpp"

using namespace ordo::solvers::rrm;

namespace {

constexpr double never = std::numeric_limits<double>::infinity();

double time_until(const Moments& now, const Moments& rate, double allowed) {
    return earlier(never, now, rate, rate.square(), allowed * allowed);
}

}  // namespace

TEST_CASE("rrm metric: two equal pieces that differ by D have the flattening error w D / 2", "[unit]") {
    const double w = 0.6, D = 0.25;
    const Moments both = piece(w / 2, 3) + piece(w / 2, 3 + D);
    CHECK(std::sqrt(both.square()) == Approx(w * D / 2));
    CHECK(piece(w, 3).square() == Approx(0).margin(1e-15));
}

TEST_CASE("rrm metric: does not depend on the base", "[unit]") {
    // sqrt(w q - s^2) is length times standard deviation: the same for values that all lie higher.
    const Moments low = piece(0.2, 1) + piece(0.5, -2);
    const Moments high = piece(0.2, 11) + piece(0.5, 8);
    CHECK(low.square() == Approx(high.square()));
    Side side{{}, 0.7, {}, {}};
    for (std::size_t k = 0; k < 4; ++k) {
        side.sum[k] = low.s;
        side.square[k] = low.q;
    }
    Side rebased{};  // to a base that lies 10 lower
    add(rebased, {0, 0, 0, 0}, side, {10, 10, 10, 10}, 3);
    CHECK(moments(rebased, 0).s == Approx(high.s));
    CHECK(moments(rebased, 2).q == Approx(high.q));
    CHECK(moments(rebased, 3).s == 0);
}

TEST_CASE("rrm metric: the time until an error is the time at which it is there", "[unit]") {
    const Moments starts[] = {{0, 0, 0}, piece(0.1, 0) + piece(0.2, 0.5), piece(0.3, 1)};
    const Moments rates[] = {piece(1, 0) + piece(2, 1), piece(0.5, -1) + piece(3, 0), piece(1, 2)};
    for (const Moments& start : starts) {
        for (const Moments& rate : rates) {
            const double allowed = 0.7;
            const double t = time_until(start, rate, allowed);
            if (t == never) continue;
            const Moments then{start.w + t * rate.w, start.s + t * rate.s, start.q + t * rate.q};
            CAPTURE(start.w, rate.w, t);
            CHECK(std::sqrt(then.square()) == Approx(allowed));
            CHECK(t > 0);
        }
    }
}

TEST_CASE("rrm metric: equal pieces never reach an error, and what is there needs no time", "[unit]") {
    // equal values: the rate's own error is 0 exactly, w_l w_r (difference)^2
    CHECK(earlier(never, {0, 0, 0}, piece(1, 0.3) + piece(2, 0.3), 0, 1e-18) == never);
    CHECK(time_until(piece(1, 0) + piece(1, 1), piece(1, 0), 0.2) == 0);
}

TEST_CASE("rrm metric: of two times the earlier one holds", "[unit]") {
    const Moments none{0, 0, 0};
    const Moments rate = piece(1, 0) + piece(1, 1);  // error 1 a second
    CHECK(earlier(0.3, none, rate, rate.square(), 0.25) == 0.3);
    CHECK(earlier(0.7, none, rate, rate.square(), 0.25) == Approx(0.5));
}

TEST_CASE("rrm metric: sides are summed with all that they hold", "[unit]") {
    Side a{{1, 2, 3}, 0.5, {1, 1, 1, 1}, {2, 2, 2, 2}};
    const Side b{{10, 20, 30}, 0.25, {4, 4, 4, 4}, {8, 8, 8, 8}};
    const ordo::solvers::rrm::Watched base{};
    add(a, base, b, base, 3);
    CHECK(a.content == ordo::solvers::Contents{11, 22, 33});
    CHECK(a.width == 0.75);
    CHECK(a.sum[2] == 5);
    CHECK(a.square[0] == 10);
    CHECK(a.sum[3] == 1);
}
