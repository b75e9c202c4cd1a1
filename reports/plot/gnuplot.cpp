#include "reports/plot/gnuplot.hpp"

#include <fcntl.h>
#include <fmt/format.h>
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

namespace ordo::reports {
namespace {

namespace fs = std::filesystem;

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

/// Pictures of 900 px or 9 in width; the height is in px.
std::string terminal(PlotFormat format, int height) {
    switch (format) {
        case PlotFormat::svg:
            return fmt::format("svg enhanced size 900,{} font 'DejaVu Sans,10' fontscale 1.3 background 'white'",
                               height);
        case PlotFormat::pdf:
            return fmt::format("pdfcairo enhanced size 9in,{}in font 'DejaVu Sans,10' fontscale 0.6", 0.01 * height);
        case PlotFormat::png: break;
    }
    return fmt::format("pngcairo enhanced size 900,{} font 'DejaVu Sans,10'", height);
}

}  // namespace

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

std::vector<std::string> draw_with_script(const std::string& text, const std::string& picture) {
    const std::string script = fs::path(picture).replace_extension(".gp").string();
    check_writable(picture);
    check_writable(script);
    write_whole(script, text);
    draw_picture(script, picture);
    return {script, picture};
}

PlotFormat format_by_ending(const std::string& picture) {
    const std::string ending = fs::path(picture).extension().string();
    for (const auto format : {PlotFormat::svg, PlotFormat::pdf, PlotFormat::png}) {
        if (ending == ending_of(format)) return format;
    }
    throw InputError(one_line(picture), "a picture's name must end in .svg, .pdf or .png");
}

std::string quoted(const std::string& text) {
    std::string inside;
    for (const char c : one_line(text)) inside += c == '\'' ? "''" : std::string{c};
    return "'" + inside + "'";
}

std::string ending_of(PlotFormat format) {
    return format == PlotFormat::svg ? ".svg" : format == PlotFormat::pdf ? ".pdf" : ".png";
}

std::string opening(PlotFormat format, int height, const std::string& picture) {
    return "set terminal " + terminal(format, height) +
           "\nset encoding utf8\nif (!exists('output')) output = " + quoted(picture) + "\nset output output\n";
}

std::string data_block(const std::string& name, const std::string& rows) {
    return "$" + name + " << EOD\n" + rows + "EOD\n";
}

}  // namespace ordo::reports
