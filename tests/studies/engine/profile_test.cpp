// Where a field on cells passes a level.
#include "studies/engine/profile.hpp"

#include <cmath>
#include <vector>

#include "tests/catch.hpp"

using ordo::studies::Profile;

namespace {

constexpr double far = 1e300;

const std::vector<double> edges{0, 1, 2, 4};
const std::vector<double> means{3, 2, 1};

}  // namespace

TEST_CASE("profile: uniform cells pass a level at the edge where they jump over it", "[unit]") {
    const Profile steps{edges, means};
    CHECK(steps.crossing(2.5, 0.2, -far, far) == 1);
    CHECK(steps.crossing(1.5, 0.2, -far, far) == 2);
    CHECK(steps.crossing(2, 1.4, -far, far) == 1);  // a cell at the level: its nearer edge
    CHECK(steps.crossing(2, 1.6, -far, far) == 2);
}

TEST_CASE("profile: cells with a rise pass a level inside", "[unit]") {
    const std::vector<double> rises{0, -1, -0.5};  // 3 | 2.5 to 1.5 | 1.25 to 0.75
    const Profile lines{edges, means, rises};
    CHECK(lines.at(1, 1.25) == 2.25);
    CHECK(lines.at_left(2) == 1.25);
    CHECK(lines.at_right(2) == 0.75);
    CHECK(lines.crossing(2.25, 0, -far, far) == 1.25);
    CHECK(lines.crossing(1, 0, -far, far) == 3);
    CHECK(lines.crossing(2.75, 0, -far, far) == 1);
    CHECK(lines.crossing(1.4, 0, -far, far) == 2);
}

TEST_CASE("profile: of several places the nearest one in the window counts", "[unit]") {
    const std::vector<double> up_and_down{0, 1, 0};
    const Profile steps{edges, up_and_down};
    CHECK(steps.crossing(0.5, 1.4, -far, far) == 1);
    CHECK(steps.crossing(0.5, 1.6, -far, far) == 2);
    CHECK(steps.crossing(0.5, 1.4, 1.5, far) == 2);
    CHECK(std::isnan(steps.crossing(0.5, 1.4, 1.1, 1.9)));
}

TEST_CASE("profile: a level that is not passed has no place, and neither has NaN", "[alarm]") {
    const Profile steps{edges, means};
    CHECK(std::isnan(steps.crossing(3.5, 1, -far, far)));
    CHECK(std::isnan(steps.crossing(std::nan(""), 1, -far, far)));
    const std::vector<double> same{2, 2, 2};
    CHECK(std::isnan(Profile{edges, same}.crossing(2, 1, -far, far)));
    const std::vector<double> broken{3, std::nan(""), 1};
    CHECK(std::isnan(Profile{edges, broken}.crossing(2, 1, -far, far)));
}
