// Every exact solution has a page with its picture and the command that made it, and a working example.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include "oracles/oracle.hpp"
#include "tests/app/process.hpp"
#include "tests/catch.hpp"

using namespace ordo;
namespace fs = std::filesystem;

namespace {

const fs::path pages = fs::path(ORDO_SOURCE_DIR) / "docs" / "oracles";

std::string text_of(const fs::path& path) {
    std::ifstream stream(path);
    return {std::istreambuf_iterator<char>(stream), {}};
}

outside::Words words_of(const std::string& line) {
    std::istringstream stream(line);
    return {std::istream_iterator<std::string>(stream), {}};
}

}  // namespace

TEST_CASE("pages: every exact solution has one, with its picture and the command that draws it", "[architecture]") {
    const std::string index = text_of(pages / "index.md");
    for (const auto& oracle : oracles::all_oracles()) {
        INFO(oracle.name);
        const std::string page = text_of(pages / (oracle.name + ".md"));
        CHECK_THAT(page, ContainsSubstring("\n    ordo oracle " + oracle.name + " "));
        if (!oracle.fields.empty()) {  // without fields there is nothing to draw
            CHECK_THAT(page, ContainsSubstring("](" + oracle.name + ".svg)") &&
                                 ContainsSubstring("--plot docs/oracles/" + oracle.name + ".svg\n"));
            CHECK_THAT(text_of(pages / (oracle.name + ".svg")), ContainsSubstring("</svg>"));
        }
        CHECK_THAT(index, ContainsSubstring("](" + oracle.name + ".md)"));
        CHECK(std::count(page.begin(), page.end(), '\n') <= 80);
    }
}

TEST_CASE("pages: the example of every exact solution works, and so does its listing", "[cli]") {
    const outside::Folder folder;
    for (const auto& oracle : oracles::all_oracles()) {
        INFO(oracle.name);
        outside::Words words = words_of(oracle.example);
        REQUIRE((!words.empty() && words.front() == oracle.name));
        words.insert(words.begin(), "oracle");
        const auto outcome = folder.ordo(words);
        INFO(outcome.err);
        CHECK(outcome.code == 0);
        CHECK_FALSE(outcome.out.empty());
        CHECK(folder.ordo({"list", "oracles", oracle.name}).code == 0);
    }
}
