// ordo basis: the functions of the MPM family in one dimension, and what particles and grid make of simple fields.
#include <algorithm>
#include <iostream>

#include "app/basis_view.hpp"
#include "app/command.hpp"
#include "app/places.hpp"
#include "core/error.hpp"
#include "core/text.hpp"

namespace ordo::app {
namespace {

using namespace solvers::mpm;

constexpr std::size_t most_pictures = 10'000;
const std::vector<std::string> show_names{"grid", "interpolated", "particle", "reproduction", "errors"};

const Parameter& declared(const std::vector<Parameter>& parameters, const std::string& name) {
    return *find_parameter(parameters, name);
}

/// One number; or, in a table of errors, FROM:TO:N.
std::vector<double> numbers_of(const po::variables_map& options, const std::string& name, bool many) {
    static const auto parameters = lineup_parameters();
    const Parameter& parameter = declared(parameters, name);
    if (!options.contains(name)) return {std::get<double>(*parameter.fallback)};
    const auto text = options[name].as<std::string>();
    const std::string where = "ordo basis --" + name;
    const bool line = text.find(':') != std::string::npos;
    if (line && !many) throw InputError(where, "is a range, which is for --show errors alone; give one number");
    const auto numbers = line ? line_of(text, where) : std::vector<double>{number_of(text, where)};
    if (numbers.size() > most_pictures) throw InputError(where, "has more than 10000 numbers");
    for (const double number : numbers) check_value(parameter, number, where);
    return numbers;
}

/// All states of the body that are asked for.
std::vector<Lineup> lineups_from(const po::variables_map& options, bool many) {
    Lineup lineup;
    lineup.cells = static_cast<int>(numbers_of(options, "cells", false).front());
    lineup.margin = static_cast<int>(numbers_of(options, "margin", false).front());
    const auto ppc = numbers_of(options, "ppc", many);
    const auto translate = numbers_of(options, "translate", many);
    const auto stretch = numbers_of(options, "stretch", many);
    if (ppc.size() * translate.size() * stretch.size() > most_pictures)
        throw InputError("ordo basis", "asks for more than 10000 states of the body");
    std::vector<Lineup> lineups;
    for (const double F : stretch) {
        for (const double shift : translate) {
            for (const double density : ppc) {
                lineup.ppc = density;
                lineup.translate = shift;
                lineup.stretch = F;
                lineups.push_back(lineup);
            }
        }
    }
    return lineups;
}

std::vector<std::string> words_of(const po::variables_map& options, const std::string& name,
                                  const std::vector<std::string>& fallback) {
    if (!options.contains(name)) return fallback;
    auto words = options[name].as<std::vector<std::string>>();
    auto sorted = words;
    std::ranges::sort(sorted);
    if (const auto twice = std::ranges::adjacent_find(sorted); twice != sorted.end())
        throw InputError("ordo basis --" + name, "'" + one_line(*twice) + "' is given twice");
    return words;
}

/// Where `word` stands among `names`.
std::size_t index_of(const std::string& word, const std::vector<std::string>& names, const std::string& where,
                     const std::string& kind) {
    const auto found = std::ranges::find(names, word);
    if (found == names.end())
        throw InputError(where, "there is no " + kind + " '" + one_line(word) + "'" + did_you_mean(word, names));
    return static_cast<std::size_t>(found - names.begin());
}

std::vector<Show> shows_from(const po::variables_map& options) {
    const bool drawn = options.contains("plot");
    std::vector<Show> shows;
    for (const auto& word : words_of(
             options, "show",
             drawn ? std::vector<std::string>{"grid", "particle", "reproduction"} : std::vector<std::string>{"grid"}))
        shows.push_back(static_cast<Show>(index_of(word, show_names, "ordo basis --show", "view")));
    if (!drawn && shows.size() > 1) throw InputError("ordo basis --show", "may be repeated with --plot only");
    if (drawn && std::ranges::count(shows, Show::errors) > 0)
        throw InputError("ordo basis --show", "'errors' is a table and has no picture (nearest: 'reproduction')");
    return shows;
}

/// The names and kinds of the bases, in the order given.
std::vector<std::string> bases_from(const po::variables_map& options, const std::vector<Show>& shows) {
    static const auto parameters = option_parameters();
    const auto names = declared(parameters, "basis").word_names();
    const std::string where = "ordo basis --basis";
    const bool cpdi_only = std::ranges::count(shows, Show::interpolated) > 0;
    auto known = names;
    known.push_back("all");
    auto bases =
        words_of(options, "basis",
                 cpdi_only ? std::vector<std::string>{"cpdi"} : std::vector<std::string>{"linear", "ugimp", "cpdi"});
    for (const auto& basis : bases) {
        index_of(basis, known, where, "basis");
        if (basis == "all" && bases.size() > 1) throw InputError(where, "'all' stands alone");
        if (cpdi_only && basis != "cpdi" && basis != "cpdi2")
            throw InputError(where, "'" + basis + "' has no tents interpolated over boxes (nearest: 'cpdi')");
    }
    return bases.front() == "all" ? names : bases;
}

Mappings mappings_from(const po::variables_map& options) {
    if (!options.contains("option")) return {Mapping::weighted, Mapping::pseudo_inverse};
    const std::vector<std::string> names{"1", "2"};
    return {
        static_cast<Mapping>(index_of(options["option"].as<std::string>(), names, "ordo basis --option", "option"))};
}

std::vector<Shown> shown(const std::vector<std::string>& bases, const std::vector<Lineup>& lineups) {
    static const auto parameters = option_parameters();
    const auto names = declared(parameters, "basis").word_names();
    std::vector<Shown> all;
    if (bases.size() * lineups.size() > most_pictures)
        throw InputError("ordo basis", "asks for more than 10000 states of the body");
    for (const auto& basis : bases) {
        for (Lineup lineup : lineups) {
            lineup.basis = static_cast<Basis>(index_of(basis, names, "ordo basis --basis", "basis"));
            all.push_back({basis, picture_of(lineup, "ordo basis")});
        }
    }
    return all;
}

int run(const po::variables_map& options, const std::vector<std::string>&) {
    const auto shows = shows_from(options);
    const auto bases = bases_from(options, shows);
    const auto mappings = mappings_from(options);
    const auto format = options["format"].as<std::string>();
    columns_as(format, {}, "ordo basis");
    const bool many = shows.front() == Show::errors;
    if (!options.contains("plot")) {
        const auto all = shown(bases, lineups_from(options, many));
        std::cout << columns_as(format, columns_of(shows.front(), all, mappings), "ordo basis");
        return all_hold;
    }
    if (!options["format"].defaulted())
        throw InputError("ordo basis --plot", "takes its format from the picture's name, not from --format");
    const auto picture = options["plot"].as<std::string>();
    const auto plot_format = reports::format_by_ending(picture);
    const auto all = shown(bases, lineups_from(options, many));
    const auto name = picture.substr(picture.find_last_of('/') + 1);
    const auto script = reports::script_of(figure_of(shows, all, mappings), plot_format, name);
    for (const auto& file : reports::draw_with_script(script, picture)) std::cout << file << '\n';
    return all_hold;
}

/// A number of the line-up, its help from its declaration.
void declare_number(po::options_description& options, const Parameter& parameter, const std::string& value) {
    options.add_options()(
        parameter.name.c_str(), po::value<std::string>()->value_name(value),
        (parameter.help + ", " + parameter.rule() + " (default " + parameter.default_text() + ")").c_str());
}

}  // namespace

Command basis_command() {
    using Words = std::vector<std::string>;
    po::options_description options("options");
    // clang-format off
    options.add_options()
        ("basis", po::value<Words>()->value_name("WORD"),
         "a basis of solver mpm, or all; may be repeated (default linear, ugimp and cpdi)")
        ("show", po::value<Words>()->value_name("WORD"),
         "grid: S_i for a particle at x; interpolated: the tents as cpdi replaces them over the boxes; "
         "particle: Phi_p; reproduction: f = 1 and f = x there and back; errors: their maxima, a row a state. "
         "May be repeated with --plot (default grid; with --plot grid, particle, reproduction)")
        ("option", po::value<std::string>()->value_name("N"),
         "nodes from particles by 1: weights over their sum; 2: pseudo-inverse (default both)");
    for (const auto& parameter : lineup_parameters())
        declare_number(options, parameter, parameter.name == "cells" || parameter.name == "margin" ? "N" : "NUMBER");
    options.add_options()
        ("plot", po::value<std::string>()->value_name("FILE"), "a picture instead: .svg, .pdf or .png, and its .gp")
        ("format", po::value<std::string>()->value_name("NAME")->default_value("csv"), "csv or json");
    // clang-format on
    return {.name = "basis",
            .about = "grid and particle basis of MPM, GIMP, CPDI in 1D",
            .usage =
                "[--basis WORD]... [--show WORD]... [--option 1|2] [--ppc N] [--translate N] [--stretch N]\n"
                "                  [--cells N] [--margin N] [--format csv|json | --plot FILE]\n"
                "       ordo basis --show errors [--ppc FROM:TO:N] [--translate FROM:TO:N] [--stretch FROM:TO:N] ...",
            .examples = {"ordo basis --basis cpdi --show particle --option 2 --ppc 2 --translate 0.3",
                         "ordo basis --show errors --ppc 0.5:4:8"},
            .options = options,
            .most_arguments = 0,
            .run = run};
}

}  // namespace ordo::app
