#include "app/terminal.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <iostream>

#include "core/text.hpp"

namespace ordo::app {
namespace {

std::string variable(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? "" : value;
}

std::string minutes(double seconds) {
    const long whole = static_cast<long>(seconds + 0.5);
    return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

std::string run_line(const studies::Run& run) {
    std::string text = run.solver;
    for (const auto& [name, value] : run.axes) text += " " + name + "=" + shortest(value);
    text += ": " + studies::text_of(run.status);
    if (run.origin == studies::Origin::cached) text += " (cached)";
    if (run.origin == studies::Origin::shared) text += " (shared)";
    if (!run.reason.empty()) text += " (" + run.reason + ")";
    for (const auto& [name, value] : run.errors) text += fmt::format(" {} {:.4e}", name, value);
    return text;
}

}  // namespace

ProgressLine::ProgressLine(std::string study)
    : study_(one_line(std::move(study))), live_(isatty(STDERR_FILENO) != 0 && variable("TERM") != "dumb") {}

ProgressLine::~ProgressLine() {
    if (live_) std::cerr << "\r\033[K" << std::flush;
}

void ProgressLine::show(const studies::Progress& progress) {
    if (!live_) {
        std::cerr << fmt::format("[{}/{}] {}\n", progress.done, progress.total, run_line(*progress.last));
        return;
    }
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin_;
    const double left = progress.work_done > 0 ? passed.count() * (1 - progress.work_done) / progress.work_done : 0;
    std::cerr << fmt::format("\r\033[K{}: {} of {} runs done, {} running, {} left", study_, progress.done,
                             progress.total, progress.running, minutes(left))
              << std::flush;
}

std::string shown(studies::Verdict verdict) {
    const std::string word = studies::text_of(verdict);
    if (isatty(STDOUT_FILENO) == 0 || !variable("NO_COLOR").empty() || variable("TERM") == "dumb") return word;
    const char* colour = verdict == studies::Verdict::pass ? "32" : verdict == studies::Verdict::fail ? "31" : "33";
    return fmt::format("\033[{}m{}\033[0m", colour, word);
}

}  // namespace ordo::app
