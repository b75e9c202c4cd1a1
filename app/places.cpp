#include "app/places.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>

#include "core/error.hpp"
#include "core/text.hpp"
#include "studies/reader/study_reader.hpp"

namespace ordo::app {
namespace {

constexpr double most_points = 10'000'000;
const std::vector<std::string> kinds{"x", "grid", "points", "cells"};

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

/// One point of `dim` coordinates.
std::vector<double> point_from(const std::string& text, char separator, int dim, const std::string& where) {
    const auto coordinates = split(text, separator);
    if (coordinates.size() != static_cast<std::size_t>(dim)) {
        throw InputError(where, "'" + text + "' has " + std::to_string(coordinates.size()) +
                                    " coordinates, but must have " + std::to_string(dim) + ", separated by '" +
                                    separator + "'");
    }
    std::vector<double> point;
    for (const auto& coordinate : coordinates) point.push_back(number_of(coordinate, where));
    return point;
}

/// FROM:TO:N.
struct Line {
    std::vector<double> from, to;
    double count;

    /// Both ends of so many equal intervals and the points between, to the last bit: from + (to - from) may lie
    /// outside.
    std::vector<double> divided(double intervals) const {
        std::vector<double> x;
        for (double k = 0; k < intervals; ++k) {
            for (std::size_t axis = 0; axis < from.size(); ++axis)
                x.push_back(from[axis] + (to[axis] - from[axis]) * k / intervals);
        }
        x.insert(x.end(), to.begin(), to.end());
        return x;
    }
};

Line line_from(const std::string& text, int dim, const std::string& where, double fewest) {
    const auto parts = split(text, ':');
    if (parts.size() != 3) {
        throw InputError(where, dim == 1 ? "must be FROM:TO:N, for instance 0:25:101"
                                         : "must be FROM:TO:N with coordinates separated by ',', for instance "
                                           "0,0:1,1:101");
    }
    const Line line{point_from(parts[0], ',', dim, where), point_from(parts[1], ',', dim, where),
                    number_of(parts[2], where)};
    const auto& [from, to, count] = line;
    if (count != std::floor(count) || count < fewest || count > most_points)
        throw InputError(where, "N must be a whole number in [" + shortest(fewest) + ", 1e7]");
    for (std::size_t axis = 0; axis < from.size(); ++axis) {
        if (!std::isfinite(to[axis] - from[axis])) throw InputError(where, "spans more than a double holds");
    }
    return line;
}

/// N points, both ends included.
std::vector<double> points_on_line(const std::string& text, int dim, const std::string& where) {
    const Line line = line_from(text, dim, where, 2);
    return line.divided(line.count - 1);
}

/// --x X1,X2,... in one dimension, --x X1:Y1,X2:Y2,... in two.
std::vector<double> list(const std::string& text, int dim, const std::string& where) {
    std::vector<double> x;
    for (const auto& one : split(text, ',')) {
        const auto point = point_from(one, ':', dim, where);
        x.insert(x.end(), point.begin(), point.end());
    }
    return x;
}

/// CSV lines x[,y[,z]]; the first may be a head of names, empty ones are skipped.
std::vector<double> file(const std::string& path, int dim, const std::string& where) {
    std::ifstream stream(path);
    if (!stream || std::filesystem::is_directory(path)) throw InputError(where, "cannot read '" + one_line(path) + "'");
    std::vector<double> x;
    std::size_t number = 0;
    for (std::string row; std::getline(stream, row);) {
        ++number;
        std::erase_if(row, [](char c) { return c == ' ' || c == '\t' || c == '\r'; });
        const bool is_head = number == 1 && row.starts_with('x');
        if (row.empty() || is_head) continue;
        const auto point = point_from(row, ',', dim, where + ": " + one_line(path) + ":" + std::to_string(number));
        x.insert(x.end(), point.begin(), point.end());
    }
    if (x.empty()) throw InputError(where, "'" + one_line(path) + "' holds no point");
    return x;
}

/// N + 1 rising edges of N cells.
std::vector<double> edges(const std::string& text, int dim, const std::string& where) {
    if (dim != 1) throw InputError(where, "is for one dimension");
    const Line line = line_from(text, dim, where, 1);
    const auto x = line.divided(line.count);
    if (!(x.front() < x.back())) throw InputError(where, "must rise: FROM < TO");
    if (std::ranges::adjacent_find(x, std::greater_equal<>()) != x.end())
        throw InputError(where, "has more cells than there are numbers between FROM and TO");
    return x;
}

}  // namespace

double number_of(const std::string& text, const std::string& where) {
    const Value value = studies::value_from(text);
    const double* number = std::get_if<double>(&value);
    if (number == nullptr || !std::isfinite(*number))
        throw InputError(where, "'" + one_line(text).substr(0, 60) + "' is not a finite number, such as 0.5 or 2e-3");
    return *number;
}

std::vector<double> line_of(const std::string& text, const std::string& where) {
    return points_on_line(text, 1, where);
}

std::vector<double> Places::coordinate(int axis) const {
    std::vector<double> values(count());
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = cells ? x[i] + (x[i + 1] - x[i]) / 2
                          : x[i * static_cast<std::size_t>(dim) + static_cast<std::size_t>(axis)];
    }
    return values;
}

std::vector<double> Places::along() const {
    std::vector<double> distance = coordinate(0);
    if (dim == 1) return distance;
    for (std::size_t i = 0; i < distance.size(); ++i) {
        double square = 0;
        for (std::size_t axis = 0; axis < static_cast<std::size_t>(dim); ++axis)
            square += std::pow(x[i * static_cast<std::size_t>(dim) + axis] - x[axis], 2);
        distance[i] = std::sqrt(square);
    }
    return distance;
}

void declare_places(po::options_description& options) {
    // clang-format off
    options.add_options()
        ("x", po::value<std::string>()->value_name("X1,X2,..."),
         "positions [m]; coordinates of a point separated by ':'")
        ("grid", po::value<std::string>()->value_name("FROM:TO:N"),
         "N positions on a line, both ends included [m]; coordinates separated by ','")
        ("points", po::value<std::string>()->value_name("FILE"), "positions from a CSV file, x[,y[,z]] a line [m]")
        ("cells", po::value<std::string>()->value_name("FROM:TO:N"), "means over N equal cells; x is their centre [m]");
    // clang-format on
}

bool asks_for_places(const po::variables_map& options) {
    return std::any_of(kinds.begin(), kinds.end(), [&](const std::string& kind) { return options.contains(kind); });
}

Places places_from(const po::variables_map& options, int dim, const std::string& command) {
    if (std::count_if(kinds.begin(), kinds.end(), [&](const auto& kind) { return options.contains(kind); }) != 1)
        throw InputError(command, "takes exactly one of --x, --grid, --points and --cells");
    const auto text = [&](const std::string& kind) { return options[kind].as<std::string>(); };
    if (options.contains("x")) return {dim, list(text("x"), dim, command + " --x")};
    if (options.contains("grid")) return {dim, points_on_line(text("grid"), dim, command + " --grid")};
    if (options.contains("points")) return {dim, file(text("points"), dim, command + " --points")};
    return {dim, edges(text("cells"), dim, command + " --cells"), true};
}

}  // namespace ordo::app
