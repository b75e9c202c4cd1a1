// ordo history: figures over the revisions of a code.
#include "reports/gate/history.hpp"

#include <algorithm>
#include <filesystem>
#include <iostream>

#include "app/arguments.hpp"
#include "app/command.hpp"

namespace ordo::app {
namespace {

namespace fs = std::filesystem;

/// Every *.json below the folder, sorted.
std::vector<std::string> documents_in(const std::string& folder) {
    std::error_code error;
    if (!fs::is_directory(folder, error)) throw InputError(folder, "is no folder; usage: ordo history DIR");
    std::vector<std::string> files;
    fs::recursive_directory_iterator entry(folder, error);
    for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
        if (entry->path().extension() == ".json") files.push_back(entry->path().string());
    }
    if (error) throw InputError(folder, "cannot be read: " + error.message());
    std::ranges::sort(files);
    return files;
}

/// The reports among them; what is none is named on stderr.
std::vector<reports::Entry> entries_in(const std::vector<std::string>& files) {
    std::vector<reports::Entry> entries;
    for (const auto& file : files) {
        try {
            entries.push_back(reports::entry_of(reports::read_report(file)));
        } catch (const InputError& error) {
            std::cerr << "not looked at: " << one_line(error.what()) << '\n';
        }
    }
    return entries;
}

int history(const po::variables_map& options, const std::vector<std::string>& folders) {
    if (folders.size() != 1) throw InputError("ordo history", "takes one folder; usage: ordo history DIR");
    const bool json = format_of<bool>(options, {{"text", false}, {"json", true}}, "ordo history");
    const auto entries = entries_in(documents_in(folders.front()));
    if (entries.empty()) throw InputError(folders.front(), "holds no report; each 'ordo run -o FILE' makes one");
    const auto found = reports::history_of(entries);
    std::cout << (json ? reports::history_json(found) : reports::history_text(found));
    return all_hold;
}

}  // namespace

Command history_command() {
    po::options_description options("options");
    options.add_options()("format", po::value<std::string>()->value_name("NAME")->default_value("text"),
                          "text or json");
    return {.name = "history",
            .about = "find the revisions at which errors, orders or work counts stepped",
            .usage = "DIR [--format text|json]",
            .examples = {"ordo history reports/nightly"},
            .options = options,
            .most_arguments = 1,
            .run = history};
}

}  // namespace ordo::app
