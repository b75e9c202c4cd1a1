// The piece of work that times are measured in.
#include "reports/reference_kernel.hpp"

#include "tests/catch.hpp"

// Bounds as wide as machines and sanitisers differ; outside, nothing was timed, or it delays every study.
TEST_CASE("reference kernel: takes a time that can be measured and nobody notices", "[unit]") {
    const double seconds = ordo::reports::reference_kernel_seconds();
    CHECK(seconds > 1e-5);
    CHECK(seconds < 0.2);
}
