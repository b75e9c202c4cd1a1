#include "tests/architecture/house.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

namespace ordo::house {
namespace {

namespace fs = std::filesystem;

const fs::path& top() {
    static const fs::path path = ORDO_SOURCE_DIR;
    return path;
}

File read(const fs::path& path) {
    std::ifstream stream(path, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return {path.lexically_relative(top()).generic_string(), text.str()};
}

}  // namespace

std::string File::room() const { return path.substr(0, path.find('/')); }

bool File::ends_with(const std::string& ending) const { return path.ends_with(ending); }

std::vector<std::string> File::lines() const {
    std::vector<std::string> all;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) all.push_back(line);
    return all;
}

const std::vector<std::string>& rooms() {
    static const std::vector<std::string> names{"app", "reports", "studies", "solvers", "oracles", "core"};
    return names;
}

std::vector<File> files(const std::vector<std::string>& endings) {
    std::vector<std::string> folders = rooms();
    for (const char* other : {"tests", "bench", "docs", "tools", "cmake", ".ci"}) folders.emplace_back(other);
    std::vector<fs::path> paths;
    for (const auto& entry : fs::directory_iterator(top())) {
        if (entry.is_regular_file()) paths.push_back(entry.path());
    }
    for (const auto& folder : folders) {
        if (!fs::exists(top() / folder)) continue;
        for (const auto& entry : fs::recursive_directory_iterator(top() / folder)) {
            if (entry.is_regular_file()) paths.push_back(entry.path());
        }
    }
    std::sort(paths.begin(), paths.end());
    std::vector<File> found;
    for (const auto& path : paths) {
        const auto has = [&](const std::string& ending) { return path.generic_string().ends_with(ending); };
        if (std::any_of(endings.begin(), endings.end(), has)) found.push_back(read(path));
    }
    return found;
}

std::vector<File> sources() {
    auto all = files({".hpp", ".cpp"});
    std::erase_if(all, [](const File& file) { return file.path.find('/') == std::string::npos; });
    return all;
}

std::vector<Include> includes_of(const File& file) {
    static const std::regex form(R"re(^\s*#\s*include\s*(["<])([^">]+)[">])re");
    std::vector<Include> all;
    const auto lines = file.lines();
    for (std::size_t i = 0; i < lines.size(); ++i) {
        std::smatch match;
        if (lines[i].find('#') == std::string::npos || !std::regex_search(lines[i], match, form)) continue;
        all.push_back({i + 1, match[2], match[1] == "\""});
    }
    return all;
}

std::string fault(const File& file, std::size_t line, const std::string& what) {
    return file.path + ":" + std::to_string(line) + ": " + what;
}

}  // namespace ordo::house
