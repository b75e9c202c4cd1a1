// What goes to a terminal, and what must not go anywhere else.
#include "tests/app/samples.hpp"

using namespace ordo;
using outside::Folder;
using outside::make_report;
using outside::Outcome;
using outside::Words;

namespace {

/// Runs `ordo` on a terminal of its own, as Python's pty gives it; both streams come back as one.
Outcome on_terminal(const Folder& folder, const Words& words, const std::string& name, const std::string& value) {
    const std::string program = "import os, pty, sys; sys.exit(os.waitstatus_to_exitcode(pty.spawn(sys.argv[1:])))";
    Words all = outside::command(words);
    all.insert(all.begin(), {ORDO_PYTHON, "-c", program});
    return outside::run(all,
                        {.folder = folder.path(), .environment = {{"TERM", "xterm"}, {"NO_COLOR", ""}, {name, value}}});
}

bool escapes(const std::string& text) { return text.find('\x1b') != std::string::npos; }

}  // namespace

TEST_CASE("cli: a verdict has a colour on a terminal only, and not with NO_COLOR", "[cli]") {
    const Folder folder;
    make_report(folder);
    const Words check{"check", "r.json"};
    const auto coloured = on_terminal(folder, check, "LC_ALL", "C");
    CHECK(coloured.code == 0);
    CHECK_THAT(coloured.out, ContainsSubstring("\x1b[32mpass\x1b[0m"));
    CHECK_FALSE(escapes(on_terminal(folder, check, "NO_COLOR", "1").out));
    CHECK_FALSE(escapes(on_terminal(folder, check, "TERM", "dumb").out));
    const auto plain = folder.ordo(check);
    CHECK_FALSE(escapes(plain.out + plain.err));
}

TEST_CASE("cli: progress is one line that is wiped away on a terminal, and plain lines elsewhere", "[cli]") {
    const Folder folder;
    make_report(folder);
    const Words run{"run", "s.json", "-o", "r.json"};
    const auto live = on_terminal(folder, run, "LC_ALL", "C");
    CHECK_THAT(live.out, ContainsSubstring("\r\x1b[Ksample: 3 of 3 runs done"));
    CHECK_THAT(live.out, ContainsSubstring("\r\x1b[Ksample\r\n"));  // the table's first line in its place
    CHECK_FALSE(escapes(on_terminal(folder, run, "TERM", "dumb").out));
    const auto plain = folder.ordo(run);
    CHECK_FALSE(escapes(plain.out + plain.err));
    CHECK(plain.err.find('\r') == std::string::npos);
}
