// ordo completion: the bash completion, written from the same option tables that parse the command line.
#include <fmt/format.h>

#include <iostream>

#include "app/command.hpp"
#include "core/text.hpp"

namespace ordo::app {
namespace {

std::string script(const std::vector<Command>& commands) {
    std::string cases;
    std::vector<std::string> names;
    for (const auto& command : commands) {
        std::string options = "--help";
        for (const auto& option : command.options.options()) options += " --" + option->long_name();
        const std::string words = command.name == "list" ? " scenes solvers oracles norms studies schema" : "";
        cases += fmt::format("        {}) words=\"{}{}\" ;;\n", command.name, options, words);
        names.push_back(command.name);
    }
    return fmt::format(R"(# bash completion of ordo, made by: ordo completion
_ordo() {{
    local word="${{COMP_WORDS[COMP_CWORD]}}" words
    if [ "$COMP_CWORD" -eq 1 ]; then
        mapfile -t COMPREPLY < <(compgen -W "{} completion --help --version" -- "$word")
        return
    fi
    case "${{COMP_WORDS[1]}}" in
{}        *) words="" ;;
    esac
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word"; compgen -f -- "$word")
}}
complete -o filenames -F _ordo ordo
)",
                       joined(names, " "), cases);
}

}  // namespace

Command completion_command(const std::vector<Command>& others) {
    const std::string text = script(others);
    return {.name = "completion",
            .about = "print the completion for bash",
            .usage = "",
            .examples = {"source <(ordo completion)"},
            .options = {},
            .most_arguments = 0,
            .run = [text](const po::variables_map&, const std::vector<std::string>&) {
                std::cout << text;
                return all_hold;
            }};
}

}  // namespace ordo::app
