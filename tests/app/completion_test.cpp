// ordo completion, from outside.
#include <fstream>
#include <sstream>

#include "tests/app/process.hpp"
#include "tests/catch.hpp"

using namespace ordo;
using outside::Folder;
using outside::Words;

namespace {

/// What bash offers for the last of these words, by the installed completion.
std::string completed(const Words& words) {
    const Folder folder;
    std::string line;
    for (const auto& word : words) line += "'" + word + "' ";
    const std::string script = "source '" + std::string(ORDO_SOURCE_DIR) + "/app/completion.bash'; COMP_WORDS=(" +
                               line + "); COMP_CWORD=" + std::to_string(words.size() - 1) +
                               "; _ordo; printf '<%s>' \"${COMPREPLY[@]}\"";
    folder.write("a file.json", "");
    const auto outcome = outside::run({"bash", "--norc", "-c", script}, folder.here());
    CHECK(outcome.code == 0);
    CHECK(outcome.err.empty());
    return outcome.out;
}

}  // namespace

TEST_CASE("cli: the completion in the tree is what the command prints", "[cli]") {
    const Folder folder;
    const auto printed = folder.ordo({"completion"});
    CHECK(printed.code == 0);
    std::ifstream file(std::string(ORDO_SOURCE_DIR) + "/app/completion.bash");
    std::ostringstream text;
    text << file.rdbuf();
    INFO("write it again: ordo completion > app/completion.bash");
    CHECK(text.str() == printed.out);
    folder.write("completion.bash", printed.out);
    CHECK(outside::run({"bash", "-n", "completion.bash"}, folder.here()).code == 0);
}

TEST_CASE("cli: the completion offers sub-commands, options, words and files", "[cli]") {
    CHECK(completed({"ordo", "pl"}) == "<plot>");
    CHECK(completed({"ordo", "comp"}) == "<completion>");
    CHECK(completed({"ordo", "run", "--j"}) == "<--jobs>");
    CHECK(completed({"ordo", "check", "--"}) == "<--help><--against><--times><--verbose><--junit><--annotations><--summary>");
    CHECK(completed({"ordo", "list", "sch"}) == "<schema>");
    CHECK(completed({"ordo", "table", "a"}) == "<a file.json>");
    CHECK(completed({"ordo", "nothing", "-"}) == "<>");
}
