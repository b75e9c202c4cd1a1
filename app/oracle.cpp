// ordo oracle: an exact solution, evaluated on its own.
#include "oracles/oracle.hpp"

#include <cmath>
#include <iostream>

#include "app/columns.hpp"
#include "app/command.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "studies/reader/study_reader.hpp"

namespace ordo::app {
namespace {

constexpr double most_points = 10'000'000;

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts;
    std::size_t from = 0;
    for (std::size_t at = text.find(separator); at != std::string::npos; at = text.find(separator, from)) {
        parts.push_back(text.substr(from, at - from));
        from = at + 1;
    }
    parts.push_back(text.substr(from));
    return parts;
}

double number_of(const std::string& text, const std::string& option) {
    const Value value = studies::value_from(text);
    const double* number = std::get_if<double>(&value);
    if (number == nullptr || !std::isfinite(*number))
        throw InputError("ordo oracle " + option, "'" + text + "' is not a finite number");
    return *number;
}

/// --grid FROM:TO:N, both ends included.
std::vector<double> grid(const std::string& text) {
    const auto parts = split(text, ':');
    if (parts.size() != 3) throw InputError("ordo oracle --grid", "must be FROM:TO:N, for instance 0:25:101");
    const double from = number_of(parts[0], "--grid");
    const double to = number_of(parts[1], "--grid");
    const double count = number_of(parts[2], "--grid");
    if (count != std::floor(count) || count < 2 || count > most_points)
        throw InputError("ordo oracle --grid", "N must be a whole number in [2, 1e7]");
    std::vector<double> x;
    for (double k = 0; k + 1 < count; ++k) x.push_back(from + (to - from) * k / (count - 1));
    x.push_back(to);  // to the last bit: from + (to - from) may lie outside
    return x;
}

/// --x X1,X2,... in one dimension, --x X1:Y1,X2:Y2,... in two: n x dim.
std::vector<double> points(const std::string& text, int dim) {
    std::vector<double> x;
    for (const auto& point : split(text, ',')) {
        const auto coordinates = split(point, ':');
        if (coordinates.size() != static_cast<std::size_t>(dim)) {
            throw InputError("ordo oracle --x", "'" + point + "' has " + std::to_string(coordinates.size()) +
                                                    " coordinates, but must have " + std::to_string(dim) +
                                                    ", separated by ':'");
        }
        for (const auto& coordinate : coordinates) x.push_back(number_of(coordinate, "--x"));
    }
    return x;
}

std::vector<double> positions(const po::variables_map& options, int dim) {
    if (options.contains("x") == options.contains("grid"))
        throw InputError("ordo oracle", "takes exactly one of --x and --grid");
    if (options.contains("x")) return points(options["x"].as<std::string>(), dim);
    if (dim != 1) throw InputError("ordo oracle --grid", "is for one dimension; name the points: --x X:Y,...");
    return grid(options["grid"].as<std::string>());
}

/// Columns of positions, then of every field's components.
std::vector<Column> evaluated(const oracles::Exact& exact, const std::vector<double>& x, double t) {
    const auto dim = static_cast<std::size_t>(exact.dim);
    std::vector<Column> columns;
    for (const auto& name : component_names("x", exact.dim, exact.dim)) columns.push_back({name, "m", {}});
    for (std::size_t k = 0; k < x.size(); ++k) columns[k % dim].values.push_back(x[k]);
    const std::size_t width = exact.width();
    std::vector<double> values(x.size() / dim * width);
    exact.sample(x, t, values);
    for (const auto& field : exact.fields) {
        for (const auto& name : component_names(field.name, components_of(field.rank, exact.dim), exact.dim)) {
            const std::size_t first = columns.size() - dim;
            columns.push_back({name, field.unit, {}});
            for (std::size_t k = first; k < values.size(); k += width) columns.back().values.push_back(values[k]);
        }
    }
    return columns;
}

int run(const po::variables_map& options, const std::vector<std::string>& words) {
    if (words.size() != 1)
        throw InputError("ordo oracle", "names no exact solution; usage: ordo oracle NAME --t T --x X1,X2,...");
    const auto& oracle = oracles::oracle_named(words.front(), "ordo oracle");
    Given given;
    if (options.contains("set")) {
        for (const auto& text : options["set"].as<std::vector<std::string>>()) {
            const auto setting = studies::setting_from(text);
            given[setting.path] = studies::value_from(setting.value);
        }
    }
    const auto exact = oracle.bind(resolve(oracle.parameters, given, "ordo oracle --set", "oracle " + oracle.name));
    if (!options.contains("t")) throw InputError("ordo oracle", "needs a time: --t T");
    const double t = number_of(options["t"].as<std::string>(), "--t");
    const auto x = positions(options, exact.dim);
    exact.check(x, t, "ordo oracle " + oracle.name);
    std::cout << columns_as(options["format"].as<std::string>(), evaluated(exact, x, t), "ordo oracle");
    return all_hold;
}

}  // namespace

Command oracle_command() {
    po::options_description options("options");
    // clang-format off
    options.add_options()
        ("set", po::value<std::vector<std::string>>()->value_name("k=v"), "one parameter; may be repeated")
        ("t", po::value<std::string>()->value_name("T"), "time [s]")
        ("x", po::value<std::string>()->value_name("X1,X2,..."),
         "positions [m]; coordinates of a point separated by ':'")
        ("grid", po::value<std::string>()->value_name("FROM:TO:N"),
         "N positions in one dimension, both ends included [m]")
        ("format", po::value<std::string>()->value_name("NAME")->default_value("csv"), "csv or json");
    // clang-format on
    return {.name = "oracle",
            .about = "evaluate an exact solution, 17 digits",
            .usage = "NAME [--set k=v]... --t T (--x X1,X2,... | --grid FROM:TO:N) [--format csv|json]",
            .examples = {"ordo oracle bar_vibration --t 0.5 --grid 0:25:6",
                         "ordo oracle bar_vibration --set ends=fixed_fixed --set mode=3 --t 1 --x 5,10"},
            .options = options,
            .most_arguments = 1,
            .run = run};
}

}  // namespace ordo::app
