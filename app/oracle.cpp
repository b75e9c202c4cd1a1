// ordo oracle: an exact solution, evaluated on its own.
#include "oracles/oracle.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>

#include "app/columns.hpp"
#include "app/command.hpp"
#include "app/constants.hpp"
#include "app/places.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "reports/plot/profile.hpp"
#include "studies/reader/study_reader.hpp"

namespace ordo::app {
namespace {

using oracles::Exact;

/// Where and when: one time at many places, or many times at one place.
struct Question {
    Places places;
    std::vector<double> times;

    bool is_history() const { return times.size() > 1; }
};

/// --t T, or --t FROM:TO:N for a history at one place.
Question question_from(const po::variables_map& options, int dim) {
    if (!options.contains("t")) throw InputError("ordo oracle", "needs a time: --t T");
    const auto text = options["t"].as<std::string>();
    const bool is_history = text.find(':') != std::string::npos;
    const Question question{
        places_from(options, dim, "ordo oracle"),
        is_history ? line_of(text, "ordo oracle --t") : std::vector<double>{number_of(text, "ordo oracle --t")}};
    if (is_history && question.places.count() != 1)
        throw InputError("ordo oracle --t", "a history FROM:TO:N is of one place, but there are " +
                                                std::to_string(question.places.count()));
    return question;
}

/// The fields at all places or times, a row of exact.width() numbers each.
std::vector<double> sampled(const Exact& exact, const Question& question, const std::string& where) {
    const Places& places = question.places;
    if (places.cells && !exact.averages) throw InputError(where + " --cells", "offers no cell averages");
    for (const double t : question.times) exact.check(places.x, t, where);
    const std::size_t length = places.count() * exact.width();
    std::vector<double> rows(question.times.size() * length);
    for (std::size_t k = 0; k < question.times.size(); ++k)
        (places.cells ? exact.averages : exact.sample)(places.x, question.times[k],
                                                       std::span(rows).subspan(k * length, length));
    if (std::any_of(rows.begin(), rows.end(), [](double value) { return std::isinf(value); }))
        throw InputError(where, "a field is beyond 1.8e308 at these places and times");
    return rows;
}

/// One component of all places out of their rows.
std::vector<double> component(const std::vector<double>& rows, std::size_t offset, std::size_t width) {
    std::vector<double> values;
    for (std::size_t k = offset; k < rows.size(); k += width) values.push_back(rows[k]);
    return values;
}

/// A panel a field.
std::vector<reports::Panel> panels_of(const Exact& exact, const std::vector<double>& rows) {
    std::vector<reports::Panel> panels;
    std::size_t offset = 0;
    for (const auto& field : exact.fields) {
        panels.push_back({field.name, field.unit, {}, {}});
        for (const auto& name : component_names(field.name, components_of(field.rank, exact.dim), exact.dim)) {
            panels.back().components.push_back(name);
            panels.back().values.push_back(component(rows, offset++, exact.width()));
        }
    }
    return panels;
}

std::vector<Column> columns_of(const Exact& exact, const Question& question, const std::vector<double>& rows) {
    std::vector<Column> columns;
    if (question.is_history()) columns.push_back({"t", question.times});
    for (int axis = 0; axis < exact.dim; ++axis) {
        auto values = question.places.coordinate(axis);
        if (question.is_history()) values.assign(question.times.size(), values.front());
        columns.push_back({std::string{"xyz"[axis]}, values});
    }
    for (auto& panel : panels_of(exact, rows)) {
        for (std::size_t k = 0; k < panel.components.size(); ++k)
            columns.push_back({panel.components[k], std::move(panel.values[k])});
    }
    return columns;
}

Given given_from(const po::variables_map& options) {
    Given given;
    if (!options.contains("set")) return given;
    for (const auto& text : options["set"].as<std::vector<std::string>>()) {
        const auto setting = studies::setting_from(text);
        if (!given.emplace(setting.path, studies::value_from(setting.value)).second)
            throw InputError("ordo oracle --set", "'" + one_line(setting.path) + "' is set twice");
    }
    return given;
}

/// --constants: as JSON, without places.
int show_constants(const Exact& exact, const po::variables_map& options, const std::string& where) {
    if (asks_for_places(options) || options.contains("plot") || !options["format"].defaulted())
        throw InputError("ordo oracle --constants", "stands alone: without places, --plot and --format");
    if (!exact.constants) throw InputError(where + " --constants", "has none");
    std::optional<double> t;
    if (options.contains("t")) t = number_of(options["t"].as<std::string>(), "ordo oracle --t");
    if (t) exact.check({}, *t, where);
    std::cout << constants_as_json(exact.constants(t));
    return all_hold;
}

/// --plot: fields along a line, or over time at one place.
int draw_profile(const Exact& exact, const std::string& name, const po::variables_map& options,
                 const Question& question, const std::vector<double>& rows) {
    std::vector<std::string> subtitle;
    if (options.contains("set")) subtitle = options["set"].as<std::vector<std::string>>();
    const std::string place = options.contains("x") ? options["x"].as<std::string>() : "";
    subtitle.push_back(question.is_history() ? "x = " + place + " m"
                                             : "t = " + shortest(question.times.front()) + " s");
    std::string along = exact.abscissa;
    if (along.empty()) along = exact.dim == 1 ? "x [m]" : "distance along the line [m]";
    const reports::Profile profile{name, joined(subtitle), question.is_history() ? "t [s]" : along,
                                   question.is_history() ? question.times : question.places.along(),
                                   panels_of(exact, rows)};
    for (const auto& file : reports::draw(profile, options["plot"].as<std::string>())) std::cout << file << '\n';
    return all_hold;
}

int run(const po::variables_map& options, const std::vector<std::string>& words) {
    if (words.size() != 1)
        throw InputError("ordo oracle", "names no exact solution; usage: ordo oracle NAME --t T --x X1,X2,...");
    const auto& oracle = oracles::oracle_named(words.front(), "ordo oracle");
    const std::string where = "ordo oracle " + oracle.name;
    const auto exact =
        oracle.bind(resolve(oracle.parameters, given_from(options), "ordo oracle --set", "oracle " + oracle.name));
    if (options.contains("constants")) return show_constants(exact, options, where);
    if (exact.fields.empty()) throw InputError(where, "has no fields; ask with --constants");
    if (options.contains("plot") && !options["format"].defaulted())
        throw InputError("ordo oracle --plot", "takes its format from the picture's name, not from --format");
    const auto question = question_from(options, exact.dim);
    const auto rows = sampled(exact, question, where);
    if (options.contains("plot")) return draw_profile(exact, oracle.name, options, question, rows);
    std::cout << columns_as(options["format"].as<std::string>(), columns_of(exact, question, rows), "ordo oracle");
    return all_hold;
}

}  // namespace

Command oracle_command() {
    po::options_description options("options");
    // clang-format off
    options.add_options()
        ("set", po::value<std::vector<std::string>>()->value_name("k=v"), "one parameter; may be repeated")
        ("t", po::value<std::string>()->value_name("T"), "time [s]; FROM:TO:N for a history at one place")
        ("constants", po::value<bool>()->zero_tokens()->implicit_value(true),
         "what does not depend on x, as JSON; with --t also where the fronts are")
        ("plot", po::value<std::string>()->value_name("FILE"), "a picture instead: .svg, .pdf or .png, and its .gp")
        ("format", po::value<std::string>()->value_name("NAME")->default_value("csv"), "csv or json");
    // clang-format on
    declare_places(options);
    return {.name = "oracle",
            .about = "evaluate an exact solution, 17 digits",
            .usage =
                "NAME [--set k=v]... --t T (--x X1,X2,... | --grid FROM:TO:N | --points FILE | --cells FROM:TO:N)\n"
                "                   [--format csv|json | --plot FILE]\n"
                "       ordo oracle NAME [--set k=v]... --constants [--t T]",
            .examples = {"ordo oracle bar_vibration --t 0.5 --grid 0:25:6",
                         "ordo oracle bar_vibration --set ends=fixed_fixed --set mode=3 --t 1 --x 5,10"},
            .options = options,
            .most_arguments = 1,
            .run = run};
}

}  // namespace ordo::app
