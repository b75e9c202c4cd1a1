#include "reports/plot/plot.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "core/error.hpp"
#include "core/text.hpp"
#include "reports/files.hpp"
#include "reports/plot/script.hpp"

namespace ordo::reports {
namespace {

namespace fs = std::filesystem;

/// "study-displacement.rms-h" with the characters of plain file names only.
std::string file_name(const studies::Study& study, const View& view) {
    std::string name = study.name + "-" + view.quantity.key() + "-" + view.abscissa;
    std::ranges::replace(name, '/', '_');
    return safe_path(name);
}

/// Everything that can be read from a file descriptor until its other end closes; closes it.
std::string read_all(int descriptor) {
    std::string text;
    std::array<char, 4096> buffer{};
    for (;;) {
        const ssize_t n = read(descriptor, buffer.data(), buffer.size());
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) break;
        text.append(buffer.data(), static_cast<std::size_t>(n));
    }
    close(descriptor);
    return text;
}

/// What a program said last, which is its error.
std::string last_line(std::string said) {
    said.resize(said.find_last_not_of(" \n") + 1);
    return one_line(said.substr(said.rfind('\n') + 1));
}

constexpr const char* scripts_are_there = "; the .gp files are written";

/// Runs gnuplot on a script without a shell and without the user's settings. The script's path is made absolute, so
/// that no folder's name is taken for an option. Throws EnvironmentError.
void run_gnuplot(const std::string& script, const std::string& output) {
    std::array<int, 2> pipe_ends{};
    if (pipe2(pipe_ends.data(), O_CLOEXEC) != 0)
        throw EnvironmentError(std::string("no pipe: ") + std::strerror(errno));
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, pipe_ends[1], STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, pipe_ends[1], STDERR_FILENO);
    std::array<std::string, 5> words{"gnuplot", "--default-settings", "-e", "output = " + quoted(output),
                                     fs::absolute(script).string()};
    std::array<char*, 6> arguments{};
    std::ranges::transform(words, arguments.begin(), [](std::string& word) { return word.data(); });
    pid_t child = 0;
    const int refused = posix_spawnp(&child, "gnuplot", &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    close(pipe_ends[1]);
    const std::string said = read_all(pipe_ends[0]);
    if (refused == ENOENT) {
        throw EnvironmentError(std::string("gnuplot is missing (Debian package gnuplot-nox)") + scripts_are_there);
    }
    if (refused != 0) {
        throw EnvironmentError(std::string("gnuplot cannot be started: ") + std::strerror(refused) + scripts_are_there);
    }
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return;
    throw EnvironmentError("gnuplot failed on " + script + ": " + last_line(said) + scripts_are_there);
}

/// A picture appears whole or not at all.
void draw_picture(const std::string& script, const std::string& picture) {
    const std::string part = picture + ".part" + std::to_string(getpid());
    std::error_code error;
    try {
        run_gnuplot(script, part);
    } catch (...) {
        fs::remove(part, error);
        throw;
    }
    fs::rename(part, picture, error);
    if (error)
        throw EnvironmentError(picture + ": gnuplot made no picture (" + error.message() + ")" + scripts_are_there);
}

}  // namespace

std::string quoted(const std::string& text) {
    std::string inside;
    for (const char c : one_line(text)) inside += c == '\'' ? "''" : std::string{c};
    return "'" + inside + "'";
}

std::vector<Figure> figures(const Report& report, PlotFormat format) {
    std::vector<Figure> all;
    for (const auto& view : views_of(report.result)) {
        const std::string name = file_name(report.result.study, view);
        all.push_back({name, script_of(report.result, view, format, name + ending_of(format))});
    }
    return all;
}

std::vector<std::string> draw(const Report& report, const std::string& folder, PlotFormat format) {
    std::vector<std::string> scripts;
    for (const auto& figure : figures(report, format)) {
        const std::string path = (fs::path(folder) / (figure.name + ".gp")).string();
        check_writable(path);
        write_whole(path, figure.script);
        scripts.push_back(path);
    }
    std::vector<std::string> files = scripts;
    for (const auto& script : scripts) {
        files.push_back(fs::path(script).replace_extension(ending_of(format)).string());
        draw_picture(script, files.back());
    }
    return files;
}

}  // namespace ordo::reports
