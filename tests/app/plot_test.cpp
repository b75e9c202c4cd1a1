// ordo plot, from outside.
#include "tests/app/samples.hpp"

using namespace ordo;
using outside::Folder;
using outside::make_report;
using outside::Names;

TEST_CASE("cli: a plot makes the files that it names, and only those", "[cli]") {
    const Folder folder;
    make_report(folder);
    const auto plot = folder.ordo({"plot", "r.json", "-o", "figures"});
    CHECK(plot.code == 0);
    CHECK(folder.names() == Names{"figures", "figures/sample-displacement.rms-h.gp",
                                  "figures/sample-displacement.rms-h.svg", "r.json", "s.json"});
    CHECK_THAT(plot.out, ContainsSubstring("figures/sample-displacement.rms-h.gp\n"));
    CHECK_THAT(plot.out, ContainsSubstring("figures/sample-displacement.rms-h.svg\n"));
    CHECK_THAT(folder.read("figures/sample-displacement.rms-h.svg"), ContainsSubstring("<svg"));
}

TEST_CASE("cli: where gnuplot is missing the script is written, and the exit code is 4", "[cli]") {
    const Folder folder;
    make_report(folder);
    const auto plot = outside::run(outside::command({"plot", "r.json", "-o", "figures"}),
                                   {.folder = folder.path(), .environment = {{"PATH", folder.path().string()}}});
    CHECK(plot.code == 4);
    CHECK(plot.err_lines() == 1);
    CHECK_THAT(plot.err, ContainsSubstring("gnuplot"));
    CHECK(folder.names() == Names{"figures", "figures/sample-displacement.rms-h.gp", "r.json", "s.json"});
}

TEST_CASE("cli: a plot that cannot be written, or of another format, is refused", "[cli]") {
    const Folder folder;
    make_report(folder);
    const Names before = folder.names();
    CHECK(folder.ordo({"plot", "r.json", "-o", "s.json"}).code == 2);
    CHECK(folder.ordo({"plot", "r.json", "-o", "r.json/figures"}).code == 2);
    CHECK(folder.ordo({"plot", "r.json", "-o", ""}).code == 2);
    CHECK(folder.ordo({"plot", "r.json", "-o", "figures", "--format", "jpg"}).code == 2);
    CHECK(folder.ordo({"plot", "none.json", "-o", "figures"}).code == 2);
    CHECK(folder.names() == before);
}
