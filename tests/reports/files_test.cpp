// Files appear whole or not at all, and never outside their folder.
#include "reports/files.hpp"

#include <sys/stat.h>

#include <filesystem>

#include "core/error.hpp"
#include "tests/app/process.hpp"
#include "tests/catch.hpp"

using namespace ordo;
using outside::Folder;
using reports::check_writable;
using reports::safe_path;
using reports::write_whole;

namespace {

using Names = std::vector<std::string>;

std::string in(const Folder& folder, const std::string& name) { return (folder.path() / name).string(); }

/// A name that a hostile study could have, from this alphabet, by its number.
std::string hostile(std::size_t number) {
    static const Names parts{"..", ".", "/", "a", "\n", " ", std::string(1, '\0'), "\\", "~", "\x1b", "\xff"};
    std::string name;
    for (; number > 0; number /= parts.size()) name += parts[number % parts.size()];
    return name;
}

}  // namespace

TEST_CASE("files: a file is written whole, and again, with nothing beside it", "[unit]") {
    const Folder folder;
    write_whole(in(folder, "r.json"), "first");
    CHECK(folder.read("r.json") == "first");
    const std::string bytes("a\0b\r\n\xff", 6);
    write_whole(in(folder, "r.json"), bytes);
    CHECK(folder.read("r.json") == bytes);
    CHECK(folder.names() == Names{"r.json"});
}

TEST_CASE("files: a failure leaves nothing", "[unit]") {
    const Folder folder;
    folder.write("folder/inside", "kept");
    CHECK_THROWS_AS(write_whole(in(folder, "folder"), "text"), EnvironmentError);
    CHECK_THROWS_AS(write_whole(in(folder, "missing/r.json"), "text"), EnvironmentError);
    CHECK_THROWS_AS(write_whole(in(folder, "folder/inside/r.json"), "text"), EnvironmentError);
    CHECK(folder.names() == Names{"folder", "folder/inside"});
    CHECK(folder.read("folder/inside") == "kept");
}

TEST_CASE("files: a place to write is made, and left empty", "[unit]") {
    const Folder folder;
    check_writable(in(folder, "r.json"));
    check_writable(in(folder, "a/b/r.json"));
    CHECK(folder.names() == Names{"a", "a/b"});
    folder.write("r.json", "kept");
    check_writable(in(folder, "r.json"));
    CHECK(folder.read("r.json") == "kept");
}

TEST_CASE("files: a name without a folder is one in the current folder", "[unit]") {
    const Folder folder;
    const auto before = std::filesystem::current_path();
    std::filesystem::current_path(folder.path());
    CHECK_NOTHROW(check_writable("r.json"));
    CHECK_NOTHROW(write_whole("r.json", "text"));
    std::filesystem::current_path(before);
    CHECK(folder.names() == Names{"r.json"});
}

TEST_CASE("files: where no file can be, none is promised", "[unit]") {
    const Folder folder;
    folder.write("file", "kept");
    CHECK_THROWS_AS(check_writable(""), InputError);
    CHECK_THROWS_AS(check_writable(folder.path().string()), InputError);
    CHECK_THROWS_AS(check_writable(in(folder, "file/r.json")), InputError);
    CHECK_THROWS_AS(check_writable(in(folder, "file/deep/r.json")), InputError);
    CHECK_THROWS_AS(check_writable("/proc/r.json"), InputError);
    // Renaming over what is no ordinary file, a device for one, would replace it. A pipe of our own shows it unharmed.
    REQUIRE(mkfifo(in(folder, "pipe").c_str(), 0600) == 0);
    CHECK_THROWS_AS(check_writable(in(folder, "pipe")), InputError);
    std::filesystem::remove(in(folder, "pipe"));
    CHECK_THROWS_AS(check_writable(in(folder, std::string(300, 'n'))), InputError);
    CHECK(folder.names() == Names{"file"});
    CHECK(folder.read("file") == "kept");
}

TEST_CASE("files: plain names stay as they are", "[unit]") {
    CHECK(safe_path("wobbes_tielen_2015/vibrating_bar") == "wobbes_tielen_2015/vibrating_bar");
    CHECK(safe_path("A-1_b.c/d.e") == "A-1_b.c/d.e");
}

TEST_CASE("files: the faults of a name, one by one", "[unit]") {
    CHECK(safe_path("") == "_");
    CHECK(safe_path("..") == "_.");
    CHECK(safe_path("../../x") == "_./_./x");
    CHECK(safe_path("/etc/passwd") == "_etc/passwd");
    CHECK(safe_path("a//b") == "a/_b");
    CHECK(safe_path("a/") == "a/_");
    CHECK(safe_path(".hidden/.too") == "_hidden/_too");
    CHECK(safe_path(std::string("a\0b", 3)) == "a_b");
    CHECK(safe_path("a\nb\x1b[1m\x7f`$(x)'\"") == "a_b__1m____x___");
    CHECK(safe_path("\xc3\xa9") == "__");
}

TEST_CASE("alarm: no name leads out of the folder", "[alarm]") {
    namespace fs = std::filesystem;
    const fs::path base = "/base";
    for (std::size_t number = 0; number < 11 * 11 * 11 * 11; ++number) {
        const std::string safe = safe_path(hostile(number));
        const auto normal = (base / safe).lexically_normal();
        const auto inside = normal.lexically_relative(base).string();
        bool fine = !safe.empty() && fs::path(safe).is_relative() && inside.find("..") != 0 && inside != ".";
        for (const auto& part : fs::path(safe)) fine = fine && !part.empty() && part.string().front() != '.';
        for (const char c : safe) fine = fine && c > ' ' && c < '\x7f' && c != '\\' && c != '~';
        if (fine) continue;
        FAIL("number " << number << " gives '" << safe << "'");
    }
}
