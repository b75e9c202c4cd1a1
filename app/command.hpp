#pragma once
// A sub-command: its words, its options and what it does. One file each; app/main.cpp lists them.
#include <boost/program_options.hpp>
#include <functional>
#include <string>
#include <vector>

namespace ordo::app {

namespace po = boost::program_options;

/// Exit codes of the command, see docs/conventions.md.
enum Exit { all_hold = 0, gate_failed = 1, bad_input = 2, run_broken = 3, environment = 4, interrupted = 130 };

struct Command {
    std::string name;
    std::string about;                  ///< one line
    std::string usage;                  ///< behind "ordo NAME "
    std::vector<std::string> examples;  ///< whole commands
    po::options_description options;
    int most_arguments = 0;  ///< positional words it takes; -1: any number
    std::function<int(const po::variables_map& options, const std::vector<std::string>& arguments)> run;
};

Command list_command();
Command run_command();
Command check_command();
Command accept_command();
Command history_command();
Command table_command();
Command plot_command();
Command oracle_command();
Command solve_command();
Command stability_command();
Command basis_command();
Command fit_command();
Command completion_command(const std::vector<Command>& others);

/// All sub-commands, in the order of `ordo --help`.
std::vector<Command> all_commands();

/// Does what the words behind "ordo" say, and answers with the exit code. Messages go to stderr.
int run_ordo(const std::vector<std::string>& words);

}  // namespace ordo::app
