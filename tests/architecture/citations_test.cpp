// Every key of the literature that the project cites is in docs/references.bib.
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "tests/architecture/house.hpp"
#include "tests/catch.hpp"

using namespace ordo::house;

namespace {

using Keys = std::set<std::string>;

/// Author and year, as Sulsky1994 and Steffen2008b are.
const std::regex author_year(R"([A-Z][A-Za-z]+[0-9]{4}[a-z]?)");

/// Short name of a public repository, as MPMtry, BS1D and SR22 are: four letters or more, two of them capitals, and not
/// in capitals throughout (those are placeholders, as STUDY is).
bool repository_name(const std::string& word) {
    static const std::regex form(R"((?=.*[A-Z].*[A-Z])(?=.*[a-z0-9])[A-Z][A-Za-z0-9]{3,})");
    return std::regex_match(word, form);
}

/// Keys of the entries in a BibTeX file, repeated ones too.
std::vector<std::string> keys_of_bibliography(const File& file) {
    static const std::regex form(R"(^@\w+\{([^,\s]+),)");
    std::vector<std::string> keys;
    for (const auto& line : file.lines()) {
        std::smatch match;
        if (std::regex_search(line, match, form)) keys.push_back(match[1]);
    }
    return keys;
}

/// Keys in brackets, alone or in a list: [Sulsky1994], [Toro2009, ch. 4]. Names of repositories count in C++ comments
/// only; elsewhere brackets hold array indices, captures, test tags and links.
void add_bracketed(const File& file, Keys& keys) {
    static const std::regex brackets(R"(\[([A-Z][^\[\]"]*)\])");
    static const std::regex separator(R"([,;]\s*)");
    const bool code = file.ends_with(".hpp") || file.ends_with(".cpp");
    for (const auto& line : file.lines()) {
        if (line.find('[') == std::string::npos) continue;
        const auto comment = static_cast<std::ptrdiff_t>(code ? std::min(line.find("//"), line.size()) : line.size());
        for (std::sregex_iterator match(line.begin(), line.end(), brackets), end; match != end; ++match) {
            const std::string inside = (*match)[1];
            for (std::sregex_token_iterator word(inside.begin(), inside.end(), separator, -1), last; word != last;
                 ++word) {
                const bool named = match->position() > comment && repository_name(*word);
                if (std::regex_match(word->str(), author_year) || named) keys.insert(*word);
            }
        }
    }
}

/// A source is a key or a sentence; a sentence has a blank in it.
void add_source(const std::string& source, Keys& keys) {
    if (!source.empty() && source.find(' ') == std::string::npos) keys.insert(source);
}

/// Strings of `source = "..."` and `source = {"...", "..."}`.
void add_sources_of_code(const File& file, Keys& keys) {
    static const std::regex member(R"re(\bsource\s*=\s*(\{[^{}]*\}|"[^"]*"))re");
    static const std::regex literal(R"re("([^"]*)")re");
    const auto& text = file.text;
    for (std::sregex_iterator match(text.begin(), text.end(), member), end; match != end; ++match) {
        const std::string value = (*match)[1];
        for (std::sregex_iterator word(value.begin(), value.end(), literal); word != end; ++word)
            add_source((*word)[1], keys);
    }
}

/// Strings and lists of strings under any member `source`.
void add_sources_of_json(const nlohmann::json& json, Keys& keys) {
    if (!json.is_structured()) return;
    for (const auto& [name, value] : json.items()) {
        if (json.is_object() && name == "source") {
            for (const auto& item : value.is_array() ? value : nlohmann::json::array({value})) {
                if (item.is_string()) add_source(item.get<std::string>(), keys);
            }
        }
        add_sources_of_json(value, keys);
    }
}

/// Everything that one file cites. Sources that tests make up are not looked at.
Keys cited(const File& file) {
    Keys keys;
    add_bracketed(file, keys);
    const bool product = file.room() != "tests";
    if (product && (file.ends_with(".cpp") || file.ends_with(".hpp"))) add_sources_of_code(file, keys);
    if (product && file.ends_with(".json"))
        add_sources_of_json(nlohmann::json::parse(file.text, nullptr, true, true), keys);
    return keys;
}

Faults dead_keys(const File& file, const Keys& known) {
    Faults faults;
    for (const auto& key : cited(file)) {
        if (!known.contains(key)) faults.push_back(file.path + ": '" + key + "' is not in docs/references.bib");
    }
    return faults;
}

std::vector<std::string> bibliography() {
    const auto found = files({"docs/references.bib"});
    return found.size() == 1 ? keys_of_bibliography(found.front()) : std::vector<std::string>{};
}

/// In brackets, which this file may not hold around a dead key.
std::string bracketed(const std::string& inside) { return "[" + inside + "]"; }

}  // namespace

TEST_CASE("architecture: every cited key is in docs/references.bib, once", "[architecture]") {
    const auto keys = bibliography();
    const Keys known(keys.begin(), keys.end());
    REQUIRE(known.contains("Sulsky1994"));
    CHECK(known.size() == keys.size());
    const auto all = files({".hpp", ".cpp", ".json", ".md"});
    CHECK(faults_in(all, [&](const File& file) { return dead_keys(file, known); }) == Faults{});
}

TEST_CASE("architecture: citations are found where they stand", "[architecture]") {
    Keys found;
    for (const auto& file : files({".hpp", ".cpp", ".json"})) {
        if (file.room() != "tests") found.merge(cited(file));
    }
    CHECK(found.contains("GolubWelsch1969"));   // in a comment
    CHECK(found.contains("MPMtry"));            // a repository
    CHECK(found.contains("WobbesTielen2015"));  // in a source
}

TEST_CASE("alarm: a dead key is found", "[alarm]") {
    const Keys known{"Sulsky1994", "Toro2009", "MPMtry"};
    const auto dead = [&](const std::string& path, const std::string& text) {
        return dead_keys({path, text}, known).size();
    };
    CHECK(dead("solvers/x.hpp", "/// source " + bracketed("Sulsky1995") + "\n") == 1);
    CHECK(dead("solvers/x.hpp", "/// source " + bracketed("Sulsky1994, Nobody1999b") + "\n") == 1);
    CHECK(dead("solvers/x.hpp", "/// as in " + bracketed("Nobody1999, eq. 4.52") + "\n") == 1);
    CHECK(dead("solvers/x.hpp", "// as in " + bracketed("BS2D") + "\n") == 1);
    CHECK(dead("solvers/x.cpp", "word(\"musl\", \"modified " + bracketed("Sulsky1995") + "\")\n") == 1);
    CHECK(dead("solvers/x.cpp", "return {.source = {\"Sulsky1994\", \"Nobody\"}};\n") == 1);
    CHECK(dead("solvers/x.cpp", "return {.source = {\n    \"Sulsky1994\",\n    \"Nobody1999\"}};\n") == 1);
    CHECK(dead("oracles/x.cpp", ".source = \"Nobody1999\",\n") == 1);
    CHECK(dead("studies/x.json",
               R"({"expect": [{"source": "Nobody1999"}], "source": ["Sulsky1994", "MPMtri"]} // ends)") == 2);
    CHECK(dead("docs/x.md", "As in " + bracketed("Nobody1999") + ".\n") == 1);
}

TEST_CASE("alarm: what is no citation is not taken for one", "[alarm]") {
    const Keys known{"Sulsky1994", "Toro2009", "MPMtry"};
    const auto dead = [&](const std::string& path, const std::string& text) { return dead_keys({path, text}, known); };
    CHECK(dead("solvers/x.hpp", "/// [Sulsky1994], [Toro2009, ch. 4], [MPMtry] in [m], [MPa], [J/kg], [0, 1]\n") ==
          Faults{});
    CHECK(dead("solvers/x.cpp", "auto f = [This, &Other](int i) { return table[Index][i]; };\n") == Faults{});
    CHECK(dead("tests/x_test.cpp", "TEST_CASE(\"a\", \"[unit][Slow]\") {}\n") == Faults{});
    CHECK(dead("app/x.cpp", "// ordo list [KIND] [NAME]; --set [PATH=VALUE]\n") == Faults{});
    CHECK(dead("studies/x.json", R"({"source": ["Sulsky1994", "seen in our own runs"], "axes": [1]})") == Faults{});
    CHECK(dead("reports/schema/x.json", R"({"source": {"type": "string"}})") == Faults{});
    CHECK(dead("docs/x.md", "[CMakeLists](../CMakeLists.txt)\n") == Faults{});
}
