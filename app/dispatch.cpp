// From words to a sub-command, and from exceptions to exit codes.
#include <fmt/format.h>

#include <iostream>
#include <new>

#include "app/command.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "reports/report.hpp"
#include "studies/engine/engine.hpp"

namespace ordo::app {
namespace {

/// Prefix guessing off: "--job" must not be taken for "--jobs".
constexpr int style = po::command_line_style::default_style & ~po::command_line_style::allow_guessing;

void print_help(const Command& command) {
    std::cout << "ordo " << command.name << ": " << command.about << "\n\nusage: ordo " << command.name << ' '
              << command.usage << "\n\n";
    if (!command.options.options().empty()) std::cout << command.options << '\n';
    std::cout << "examples:\n";
    for (const auto& example : command.examples) std::cout << "  " << example << '\n';
}

void print_overview(const std::vector<Command>& commands) {
    std::cout << "ordo measures how accurate a solver really is: sweep, compare with the exact solution, fit the "
                 "order, gate.\n\n"
                 "usage: ordo COMMAND ...\n\n";
    for (const auto& command : commands) std::cout << fmt::format("  {:<11} {}\n", command.name, command.about);
    std::cout
        << "\n'ordo COMMAND --help' shows options and examples. Exit codes: 0 all expectations hold, 1 a gate failed,\n"
           "2 bad input (nothing run, nothing written), 3 a run broke, 4 the environment failed, 130 interrupted.\n"
           "examples:\n  ordo list scenes\n  ordo run studies/wobbes_tielen_2015/vibrating_bar.json\n";
}

std::vector<std::string> long_names(const po::options_description& options) {
    std::vector<std::string> names;
    for (const auto& option : options.options()) names.push_back("--" + option->long_name());
    return names;
}

/// An empty name would mean something else: -o "" the default, --against "" no baseline at all.
void refuse_empty(const po::variables_map& values, const std::string& where) {
    for (const auto& [name, value] : values) {
        const auto* text = boost::any_cast<std::string>(&value.value());
        if (text != nullptr && text->empty()) throw InputError(where, "--" + name + " is empty");
    }
}

int run_parsed(const Command& command, const std::vector<std::string>& words) {
    po::options_description all(command.options);
    all.add_options()("help,h", "this text")("argument", po::value<std::vector<std::string>>());
    po::positional_options_description positional;
    positional.add("argument", command.most_arguments);
    const std::string where = "ordo " + command.name;
    po::variables_map values;
    try {
        po::store(po::command_line_parser(words).options(all).positional(positional).style(style).run(), values);
        if (values.contains("help")) {
            print_help(command);
            return all_hold;
        }
        po::notify(values);
    } catch (const po::unknown_option& error) {
        const std::string given = error.get_option_name();
        const std::string name = given.substr(0, given.find('='));
        throw InputError(where, "unknown option '" + name + "'" + did_you_mean(name, long_names(command.options)));
    } catch (const po::too_many_positional_options_error&) {
        throw InputError(where, "too many words; usage: ordo " + command.name + " " + command.usage);
    } catch (const po::error& error) {
        throw InputError(where, std::string(error.what()) + "; usage: ordo " + command.name + " " + command.usage);
    }
    refuse_empty(values, where);
    const auto arguments =
        values.contains("argument") ? values["argument"].as<std::vector<std::string>>() : std::vector<std::string>{};
    return command.run(values, arguments);
}

int run_words(const std::vector<std::string>& words) {
    const auto commands = all_commands();
    if (words.empty()) throw InputError("", "names no command; usage: ordo COMMAND ..., see ordo --help");
    if (words.front() == "--help" || words.front() == "-h" || words.front() == "help") {
        print_overview(commands);
        return all_hold;
    }
    if (words.front() == "--version") {
        const auto here = reports::provenance_here(0, 0);
        std::cout << "ordo " << here.ordo_version << " (" << here.revision << ", " << here.compiler << ")\n";
        return all_hold;
    }
    std::vector<std::string> names;
    for (const auto& command : commands) {
        if (command.name == words.front()) return run_parsed(command, {words.begin() + 1, words.end()});
        names.push_back(command.name);
    }
    throw InputError("", "there is no command '" + words.front() + "'" + did_you_mean(words.front(), names));
}

/// One line on stderr, whatever the message holds.
int complain(const std::string& message, int code) {
    std::cerr << "ordo: " << one_line(message) << '\n';
    return code;
}

}  // namespace

std::vector<Command> all_commands() {
    std::vector<Command> commands{list_command(),    run_command(),       check_command(), accept_command(),
                                  history_command(), table_command(),     plot_command(),  oracle_command(),
                                  solve_command(),   stability_command(), basis_command(), fit_command()};
    commands.push_back(completion_command(commands));
    return commands;
}

int run_ordo(const std::vector<std::string>& words) {
    try {
        const int code = run_words(words);
        std::cout.flush();
        if (!std::cout) return complain("standard output cannot be written", environment);
        return code;
    } catch (const InputError& error) {
        return complain(error.what(), bad_input);
    } catch (const studies::StudyInterrupted&) {
        return complain("interrupted; nothing unfinished was written", interrupted);
    } catch (const EnvironmentError& error) {
        return complain(error.what(), environment);
    } catch (const std::bad_alloc&) {
        return complain("out of memory", environment);
    } catch (const std::exception& error) {
        return complain(std::string("internal error: ") + error.what(), environment);
    }
}

}  // namespace ordo::app
