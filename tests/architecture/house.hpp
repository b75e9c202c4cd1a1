#pragma once
// The project's own files as text, for the tests that hold them to the rules of docs/architecture.md. Each rule is a
// function of one file, so that a test can feed it a seeded fault too.
#include <string>
#include <vector>

namespace ordo::house {

/// One text file; `path` is relative to the project, with slashes: "solvers/mpm/grid.hpp".
struct File {
    std::string path;
    std::string text;

    std::string room() const;                         ///< first part of the path: "solvers"
    bool ends_with(const std::string& ending) const;  ///< of the path
    std::vector<std::string> lines() const;
};

/// What is wrong, one line each: "solvers/x.hpp:3: ..."; empty where a file keeps the rule.
using Faults = std::vector<std::string>;

/// The rooms of the product, left to right along the arrows, core last.
const std::vector<std::string>& rooms();

/// Every text file of the project with one of these endings, in the order of their paths. Build folders are not seen.
std::vector<File> files(const std::vector<std::string>& endings);

/// .hpp and .cpp of all rooms, the tests and the benchmarks.
std::vector<File> sources();

/// One #include line.
struct Include {
    std::size_t line = 0;
    std::string target;
    bool quoted = false;  ///< "..." and not <...>
};
std::vector<Include> includes_of(const File& file);

/// "path:line: what".
std::string fault(const File& file, std::size_t line, const std::string& what);

/// All that `rule` finds in `among`.
template <class Rule>
Faults faults_in(const std::vector<File>& among, Rule&& rule) {
    Faults all;
    for (const auto& file : among) {
        for (auto& found : rule(file)) all.push_back(std::move(found));
    }
    return all;
}

}  // namespace ordo::house
