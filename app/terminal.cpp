#include "app/terminal.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <iostream>
#include <utility>

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

std::string bar(const std::string& study, const studies::Progress& now) {
    const double left = now.work_done > 0 ? now.seconds * (1 - now.work_done) / now.work_done : 0;
    return fmt::format("{}: {} of {} runs done, {} running, {} left", one_line(study), now.done, now.total, now.running,
                       minutes(left));
}

}  // namespace

ProgressLines::ProgressLines(std::vector<std::string> studies)
    : studies_(std::move(studies)),
      live_(isatty(STDERR_FILENO) != 0 && variable("TERM") != "dumb"),
      held_(studies_.size()) {}

ProgressLines::~ProgressLines() { wipe(); }

void ProgressLines::wipe() const {
    if (live_) std::cerr << "\r\033[K" << std::flush;
}

void ProgressLines::show(const studies::Progress& progress) {
    const std::lock_guard lock(mutex_);
    std::string& held = held_[progress.study];
    if (live_) held = "\r\033[K" + bar(studies_[progress.study], progress);
    else held += fmt::format("[{}/{}] {}\n", progress.done, progress.total, run_line(*progress.last));
    if (progress.study == turn_) std::cerr << std::exchange(held, "") << std::flush;
}

void ProgressLines::next() {
    const std::lock_guard lock(mutex_);
    if (++turn_ < held_.size()) std::cerr << std::exchange(held_[turn_], "") << std::flush;
}

std::string shown(studies::Verdict verdict) {
    const std::string word = studies::text_of(verdict);
    if (isatty(STDOUT_FILENO) == 0 || !variable("NO_COLOR").empty() || variable("TERM") == "dumb") return word;
    const char* colour = verdict == studies::Verdict::pass ? "32" : verdict == studies::Verdict::fail ? "31" : "33";
    return fmt::format("\033[{}m{}\033[0m", colour, word);
}

}  // namespace ordo::app
