// Threads that work together.
#include "solvers/mpm/fast/team.hpp"

#include <stdexcept>

#include "tests/catch.hpp"

using ordo::solvers::mpm::fast::Team;

TEST_CASE("team: each member works once, and sees what all did before", "[unit]") {
    for (const int members : {1, 2, 3}) {
        Team team(members);
        REQUIRE(team.members() == members);
        std::vector<int> own(static_cast<std::size_t>(members), 0);
        std::vector<int> sums = own;
        for (int round = 1; round <= 10; ++round) {
            team.run([&](int member) { ++own[static_cast<std::size_t>(member)]; });
            team.run([&](int member) {
                for (const int n : own) sums[static_cast<std::size_t>(member)] += n;
            });
        }
        CHECK(own == std::vector<int>(static_cast<std::size_t>(members), 10));
        CHECK(sums == std::vector<int>(static_cast<std::size_t>(members), members * 10 * 11 / 2));
    }
}

TEST_CASE("team: what the first of the members throws comes to the caller, and work goes on", "[unit]") {
    Team team(3);
    const auto faulty = [](int member) {
        if (member > 0) throw std::runtime_error("member " + std::to_string(member));
    };
    CHECK_THROWS_WITH(team.run(faulty), "member 1");
    int done = 0;
    team.run([&](int member) {
        if (member == 2) ++done;
    });
    CHECK(done == 1);
}

TEST_CASE("team: helpers tell the processor time that they have used", "[unit]") {
    Team team(2);
    Team alone(1);
    std::atomic<long> sum = 0;
    const auto count = [&](int) {
        for (int k = 0; k < 200'000; ++k) sum.fetch_add(k, std::memory_order_relaxed);
    };
    team.run(count);
    alone.run(count);
    const double once = team.helper_seconds();
    CHECK(once > 1e-4);  // 200,000 locked additions of half a nanosecond
    team.run(count);
    CHECK(team.helper_seconds() > once);
    CHECK(alone.helper_seconds() == 0);
}
