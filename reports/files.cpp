#include "reports/files.hpp"

#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "core/error.hpp"

namespace ordo::reports {
namespace {

namespace fs = std::filesystem;

/// A name beside `path` that no other process uses.
std::string beside(const std::string& path) { return path + ".part" + std::to_string(getpid()); }

}  // namespace

void write_whole(const std::string& path, const std::string& text) {
    const std::string part = beside(path);
    std::error_code error;
    {
        std::ofstream file(part, std::ios::binary);
        file << text;
        file.close();
        if (!file) {
            fs::remove(part, error);
            throw EnvironmentError(path + ": cannot be written");
        }
    }
    fs::rename(part, path, error);
    if (!error) return;
    std::error_code ignored;
    fs::remove(part, ignored);
    throw EnvironmentError(path + ": cannot be written (" + error.message() + ")");
}

void check_writable(const std::string& path) {
    if (path.empty()) throw InputError("", "the name of an output file is empty");
    std::error_code error;
    if (fs::is_directory(path, error)) throw InputError(path, "is a folder, but must be a file");
    if (fs::exists(path, error) && !fs::is_regular_file(path, error)) throw InputError(path, "is no ordinary file");
    error.clear();
    const fs::path folder = fs::path(path).parent_path();
    if (!folder.empty()) fs::create_directories(folder, error);
    if (error) throw InputError(path, "its folder cannot be made (" + error.message() + ")");
    const std::string part = beside(path);
    const bool opens = std::ofstream(part).good();
    fs::remove(part, error);
    if (!opens) throw InputError(path, "cannot be written there");
}

std::string safe_path(const std::string& name) {
    std::string path;
    for (const char c : name) {
        const bool plain =
            (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
        const bool begins = path.empty() || path.back() == '/';
        if (plain || (c == '.' && !begins) || (c == '/' && !begins)) path += c;
        else path += '_';
    }
    return path.empty() || path.back() == '/' ? path + '_' : path;
}

}  // namespace ordo::reports
