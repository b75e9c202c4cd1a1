#pragma once
// Running a program from outside, without a shell: arguments, folder and environment in; output and exit code out.
#include <sys/types.h>

#include <cstdio>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace ordo::outside {

using Words = std::vector<std::string>;
using Names = std::vector<std::string>;

/// What a program left. `code` is its exit code, 128 + n where signal n ended it, -1 where it passed the time limit.
struct Outcome {
    int code = 0;
    std::string out;
    std::string err;

    std::size_t err_lines() const;
};

/// Where a program runs.
struct Setting {
    std::filesystem::path folder;
    std::vector<std::pair<std::string, std::string>> environment = {};  ///< variables to set beside ours
    std::string out = {};                                               ///< file for standard output; empty: it is kept
    double limit_s = 20;                                                ///< longer runs are killed
};

/// A running program; the destructor kills it.
class Process {
public:
    Process(const Words& words, const Setting& setting);
    ~Process();
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    void send(int signal) const;
    std::string err() const;  ///< what it said so far
    /// Waits until that holds; false where the program ended first, or 10 s went by.
    bool until(const std::function<bool()>& holds);
    Outcome wait();

private:
    bool ended();

    pid_t id_ = -1;
    int status_ = 0;
    double limit_s_;
    std::FILE* out_;
    std::FILE* err_;
};

/// Runs it to its end.
Outcome run(const Words& words, const Setting& setting);

/// The command `ordo` with these words behind it.
Words command(Words words);

/// A folder of its own for one test, removed at the end.
class Folder {
public:
    Folder();
    ~Folder();
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    Setting here() const { return {path_}; }
    Outcome ordo(const Words& words) const;                              ///< runs the command in it
    void write(const std::string& name, const std::string& text) const;  ///< makes missing folders
    std::string read(const std::string& name) const;                     ///< "" where there is no such file
    bool has(const std::string& name) const;
    std::vector<std::string> names() const;  ///< every file and folder in it, by path, sorted

private:
    std::filesystem::path path_;
};

}  // namespace ordo::outside
