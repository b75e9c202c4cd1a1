// ordo oracle: an exact solution, evaluated on its own.
#include "oracles/oracle.hpp"

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

/// The fields at all places, a row of exact.width() numbers a place.
std::vector<double> sampled(const Exact& exact, const Places& places, double t, const std::string& where) {
    if (places.cells && !exact.averages) throw InputError(where + " --cells", "offers no cell averages");
    std::vector<double> rows(places.count() * exact.width());
    (places.cells ? exact.averages : exact.sample)(places.x, t, rows);
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

std::vector<Column> columns_of(const Exact& exact, const Places& places, const std::vector<double>& rows) {
    std::vector<Column> columns;
    for (int axis = 0; axis < exact.dim; ++axis) columns.push_back({std::string{"xyz"[axis]}, places.coordinate(axis)});
    for (const auto& panel : panels_of(exact, rows)) {
        for (std::size_t k = 0; k < panel.components.size(); ++k)
            columns.push_back({panel.components[k], panel.values[k]});
    }
    return columns;
}

Given given_from(const po::variables_map& options) {
    Given given;
    if (!options.contains("set")) return given;
    for (const auto& text : options["set"].as<std::vector<std::string>>()) {
        const auto setting = studies::setting_from(text);
        given[setting.path] = studies::value_from(setting.value);
    }
    return given;
}

/// --constants: as JSON, without places.
int show_constants(const Exact& exact, const po::variables_map& options, const std::string& where) {
    if (asks_for_places(options) || options.contains("plot"))
        throw InputError("ordo oracle --constants", "stands alone: without --x, --grid, --points, --cells and --plot");
    if (!exact.constants) throw InputError(where + " --constants", "has none: everything depends on x");
    std::optional<double> t;
    if (options.contains("t")) t = number_of(options["t"].as<std::string>(), "ordo oracle --t");
    if (t) exact.check({}, *t, where);
    std::cout << constants_as_json(exact.constants(t));
    return all_hold;
}

std::string settings_text(const po::variables_map& options) {
    return options.contains("set") ? joined(options["set"].as<std::vector<std::string>>()) + ", " : "";
}

int run(const po::variables_map& options, const std::vector<std::string>& words) {
    if (words.size() != 1)
        throw InputError("ordo oracle", "names no exact solution; usage: ordo oracle NAME --t T --x X1,X2,...");
    const auto& oracle = oracles::oracle_named(words.front(), "ordo oracle");
    const std::string where = "ordo oracle " + oracle.name;
    const auto exact =
        oracle.bind(resolve(oracle.parameters, given_from(options), "ordo oracle --set", "oracle " + oracle.name));
    if (options.contains("constants")) return show_constants(exact, options, where);
    if (!options.contains("t")) throw InputError("ordo oracle", "needs a time: --t T");
    const double t = number_of(options["t"].as<std::string>(), "ordo oracle --t");
    const auto places = places_from(options, exact.dim, "ordo oracle");
    exact.check(places.x, t, where);
    const auto rows = sampled(exact, places, t, where);
    if (!options.contains("plot")) {
        std::cout << columns_as(options["format"].as<std::string>(), columns_of(exact, places, rows), "ordo oracle");
        return all_hold;
    }
    const reports::Profile profile{oracle.name, settings_text(options) + "t = " + shortest(t) + " s",
                                   exact.dim == 1 ? "x [m]" : "distance along the line [m]", places.along(),
                                   panels_of(exact, rows)};
    for (const auto& file : reports::draw(profile, options["plot"].as<std::string>())) std::cout << file << '\n';
    return all_hold;
}

}  // namespace

Command oracle_command() {
    po::options_description options("options");
    // clang-format off
    options.add_options()
        ("set", po::value<std::vector<std::string>>()->value_name("k=v"), "one parameter; may be repeated")
        ("t", po::value<std::string>()->value_name("T"), "time [s]")
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
