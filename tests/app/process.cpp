#include "tests/app/process.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace ordo::outside {
namespace {

namespace fs = std::filesystem;
using clock = std::chrono::steady_clock;

constexpr auto pause = std::chrono::milliseconds(1);

clock::time_point after(double seconds) {
    return clock::now() + std::chrono::duration_cast<clock::duration>(std::chrono::duration<double>(seconds));
}

/// The whole file from its beginning, whoever writes to it.
std::string all_of(std::FILE* file) {
    std::string text;
    char buffer[4096];
    ssize_t n = 0;
    while ((n = pread(fileno(file), buffer, sizeof buffer, static_cast<off_t>(text.size()))) > 0) {
        text.append(buffer, static_cast<std::size_t>(n));
    }
    return text;
}

/// In the child: everything in place, then the program. Never returns.
[[noreturn]] void become(const Words& words, const Setting& setting, int out, int err) {
    const int nothing = open("/dev/null", O_RDONLY);
    if (!setting.out.empty()) out = open(setting.out.c_str(), O_WRONLY);
    const bool placed = chdir(setting.folder.c_str()) == 0 && dup2(nothing, STDIN_FILENO) >= 0 &&
                        dup2(out, STDOUT_FILENO) >= 0 && dup2(err, STDERR_FILENO) >= 0;
    setenv("ORDO_CACHE", "off", 1);  // a test that is about the cache says where it is
    for (const auto& [name, value] : setting.environment) setenv(name.c_str(), value.c_str(), 1);
    std::vector<char*> arguments;
    for (const auto& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    if (placed) execvp(arguments.front(), arguments.data());
    _exit(127);
}

}  // namespace

std::size_t Outcome::err_lines() const { return static_cast<std::size_t>(std::count(err.begin(), err.end(), '\n')); }

Process::Process(const Words& words, const Setting& setting)
    : limit_s_(setting.limit_s), out_(std::tmpfile()), err_(std::tmpfile()) {
    if (out_ == nullptr || err_ == nullptr) throw std::runtime_error("no temporary file");
    id_ = fork();
    if (id_ < 0) throw std::runtime_error("no process");
    if (id_ == 0) become(words, setting, fileno(out_), fileno(err_));
}

Process::~Process() {
    if (!ended()) {
        send(SIGKILL);
        waitpid(id_, &status_, 0);
    }
    std::fclose(out_);
    std::fclose(err_);
}

bool Process::ended() {
    if (id_ > 0 && waitpid(id_, &status_, WNOHANG) == id_) id_ = 0;
    return id_ <= 0;
}

void Process::send(int signal) const {
    if (id_ > 0) kill(id_, signal);
}

std::string Process::err() const { return all_of(err_); }

bool Process::until(const std::function<bool()>& holds) {
    const auto limit = after(10);
    while (!holds()) {
        if (ended() || clock::now() > limit) return false;
        std::this_thread::sleep_for(pause);
    }
    return true;
}

Outcome Process::wait() {
    const auto limit = after(limit_s_);
    while (!ended()) {
        if (clock::now() > limit) return {-1, all_of(out_), all_of(err_)};
        std::this_thread::sleep_for(pause);
    }
    const int code = WIFEXITED(status_) ? WEXITSTATUS(status_) : 128 + WTERMSIG(status_);
    return {code, all_of(out_), all_of(err_)};
}

Outcome run(const Words& words, const Setting& setting) { return Process(words, setting).wait(); }

Words command(Words words) {
    words.insert(words.begin(), ORDO_BINARY);
    return words;
}

Folder::Folder() {
    std::string form = (fs::temp_directory_path() / "ordo_test_XXXXXX").string();
    if (mkdtemp(form.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path_ = form;
}

Folder::~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

Outcome Folder::ordo(const Words& words) const { return run(command(words), here()); }

void Folder::write(const std::string& name, const std::string& text) const {
    fs::create_directories((path_ / name).parent_path());
    std::ofstream(path_ / name, std::ios::binary) << text;
}

std::string Folder::read(const std::string& name) const {
    std::ostringstream text;
    text << std::ifstream(path_ / name, std::ios::binary).rdbuf();
    return text.str();
}

bool Folder::has(const std::string& name) const { return fs::exists(fs::symlink_status(path_ / name)); }

std::vector<std::string> Folder::names() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(path_))
        names.push_back(entry.path().lexically_relative(path_).generic_string());
    std::sort(names.begin(), names.end());
    return names;
}

}  // namespace ordo::outside
