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

TEST_CASE("cli: a plot is drawn against each cost that it names", "[cli]") {
    const Folder folder;
    make_report(folder);
    const auto plot = folder.ordo({"plot", "r.json", "-o", "figures", "--against", "time,work"});
    CHECK(plot.code == 0);
    CHECK(plot.err.empty());
    const std::string begin = "figures/sample-displacement.rms-";
    CHECK(plot.out == begin + "time.gp\n" + begin + "work.gp\n" + begin + "time.svg\n" + begin + "work.svg\n");
    CHECK(folder.names() == Names{"figures", begin + "time.gp", begin + "time.svg", begin + "work.gp",
                                  begin + "work.svg", "r.json", "s.json"});
    CHECK_THAT(folder.read(begin + "time.svg"), ContainsSubstring("thread time [s], one machine, this run"));
    CHECK_THAT(folder.read(begin + "work.svg"), ContainsSubstring("counted work [particle steps]"));
    CHECK(folder.ordo({"plot", "r.json", "-o", "figures", "--against", "h,time"}).code == 0);
    CHECK(folder.has(begin + "h.svg"));
}

TEST_CASE("cli: an abscissa that is unknown, empty or named twice is refused with the nearest", "[cli]") {
    const Folder folder;
    make_report(folder);
    const Names before = folder.names();
    const std::vector<std::pair<std::string, std::string>> faults{
        {"tme", "nearest: 'time'"},         {"time,wrk", "nearest: 'work'"}, {"h,", "against ''"}, {",", "against ''"},
        {"work,time,work", "stands twice"}, {"h work", "'h work'"},          {"", "is empty"},     {"H", "'H'"}};
    for (const auto& [words, part] : faults) {
        INFO(words);
        const auto plot = folder.ordo({"plot", "r.json", "-o", "figures", "--against", words});
        CHECK(plot.code == 2);
        CHECK(plot.err_lines() == 1);
        CHECK_THAT(plot.err, ContainsSubstring("--against") && ContainsSubstring(part));
        CHECK(plot.out.empty());
    }
    CHECK(folder.names() == before);
}

TEST_CASE("cli: a report without run times is not drawn against time, and nothing is written", "[cli]") {
    const Folder folder;
    make_report(folder);
    auto report = samples::Json::parse(folder.read("r.json"));
    const auto times = GENERATE(as<std::string>{}, "[]", "[0, 0, 0]", "[null, null, null]", "[-1, -1, 0]");
    report["provenance"]["run_seconds"] = samples::Json::parse(times);
    folder.write("r.json", report.dump());
    const Names before = folder.names();
    // What comes before it in the list is not written either.
    const auto plot = folder.ordo({"plot", "r.json", "-o", "figures", "--against", "h,work,time"});
    CHECK(plot.code == 2);
    CHECK(plot.err_lines() == 1);
    CHECK_THAT(plot.err, ContainsSubstring("sample: no run of this report has a time above zero"));
    CHECK(plot.out.empty());
    CHECK(folder.names() == before);
    CHECK(folder.ordo({"plot", "r.json", "-o", "figures", "--against", "h,work"}).code == 0);
}

TEST_CASE("cli: a run whose time is zero is left out of the plot by name", "[cli]") {
    const Folder folder;
    make_report(folder);
    auto report = samples::Json::parse(folder.read("r.json"));
    report["provenance"]["run_seconds"][0] = 0;
    folder.write("r.json", report.dump());
    CHECK(folder.ordo({"plot", "r.json", "--against", "time"}).code == 0);
    CHECK_THAT(folder.read("sample-displacement.rms-time.svg"),
               ContainsSubstring("1 run without a time above zero: cells = 4"));
}
