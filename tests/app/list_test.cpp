// ordo list, from outside.
#include "tests/app/samples.hpp"

using namespace ordo;
using outside::Folder;
using outside::link_studies;

TEST_CASE("cli: list shows every catalogue, one alone, and one entry whole", "[cli]") {
    const Folder folder;
    link_studies(folder);
    const auto all = folder.ordo({"list"});
    CHECK(all.code == 0);
    for (const char* part : {"bar_vibration", "mpm", "rms", "studies/wobbes_tielen_2015/vibrating_bar.json"}) {
        CHECK_THAT(all.out, ContainsSubstring(part));
    }
    CHECK_THAT(folder.ordo({"list", "solvers", "mpm"}).out,
               ContainsSubstring("stress_update") && ContainsSubstring("musl"));
    CHECK_THAT(folder.ordo({"list", "scenes", "bar_vibration"}).out,
               ContainsSubstring("fixed_free") && ContainsSubstring("[Pa]"));
    CHECK_THAT(folder.ordo({"list", "oracles", "bar_vibration"}).out, ContainsSubstring("accuracy"));
    CHECK_THAT(folder.ordo({"list", "schema"}).out, ContainsSubstring("\"ordo-study-1\""));
}

TEST_CASE("cli: a bad study among others is refused before any is listed", "[cli]") {
    const Folder folder;
    folder.write("studies/bad.json", "{");
    const auto listed = folder.ordo({"list", "studies"});
    CHECK(listed.code == 2);
    CHECK(listed.out.empty());
    CHECK_THAT(listed.err, ContainsSubstring("studies/bad.json"));
}
