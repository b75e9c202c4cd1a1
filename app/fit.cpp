// ordo fit: the order in a user's own numbers, whatever code they come from.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <iterator>
#include <limits>

#include "app/arguments.hpp"
#include "app/command.hpp"
#include "app/number_table.hpp"
#include "reports/order_view.hpp"
#include "studies/order/order_fit.hpp"
#include "studies/reader/json_input.hpp"

namespace ordo::app {
namespace {

using namespace studies;

const std::string name_of_command = "ordo fit";
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// What was found, for a reader and for a program.
struct Answer {
    Convergence verdict = Convergence::inconclusive;
    std::vector<std::string> lines;
    Json json;
};

/// Which columns are asked for.
struct Columns {
    std::vector<std::string> abscissae;  ///< one or two
    std::string measured;                ///< error or value
};

NumberTable table_from(const std::string& file) {
    if (file != "-") return number_table(read_text(file), file);
    return number_table(std::string(std::istreambuf_iterator<char>(std::cin), {}), "standard input");
}

std::vector<std::string> names_in(const std::string& list) {
    std::vector<std::string> names;
    std::size_t from = 0;
    for (auto at = list.find(','); at != std::string::npos; at = list.find(',', from)) {
        names.push_back(list.substr(from, at - from));
        from = at + 1;
    }
    names.push_back(list.substr(from));
    const std::string where = name_of_command + " --abscissa";
    if (names.size() > 2) throw InputError(where, "names more than two columns");
    if (names.size() == 2 && names[0] == names[1]) throw InputError(where, "'" + names[0] + "' stands twice");
    return names;
}

/// "cells" of "1/cells".
std::string column_name(const std::string& abscissa) {
    return abscissa.starts_with("1/") ? abscissa.substr(2) : abscissa;
}

/// The abscissa in that column, or one over it: what falls under refinement.
std::vector<double> abscissa_of(const NumberTable& table, const std::string& name, std::size_t place,
                                const std::string& file) {
    if (column_name(name) == name || table.has(name)) return table.column(name, place, file);
    std::vector<double> column = table.column(column_name(name), place, file);
    for (double& value : column) value = 1 / value;
    return column;
}

/// Numbers of cells taken for widths: whole, and larger than one.
bool are_counts(const std::vector<double>& abscissae) {
    return std::ranges::all_of(abscissae, [](double value) { return value > 1 && value == std::floor(value); });
}

/// The named columns; without names the first, and the one called `usual` or the only other one.
Columns columns_of(const po::variables_map& options, const NumberTable& table, const std::string& file,
                   const std::string& usual) {
    Columns columns{{table.names.empty() ? "h" : table.names.front()}, usual};
    if (options.contains("abscissa")) columns.abscissae = names_in(options["abscissa"].as<std::string>());
    const std::size_t asked = columns.abscissae.size() + 1;
    if (options.contains(usual)) columns.measured = options[usual].as<std::string>();
    else if (table.names.size() == 2 && asked == 2 && !table.has(usual))
        columns.measured = table.names[column_name(columns.abscissae[0]) == table.names[0] ? 1 : 0];
    for (const auto& abscissa : columns.abscissae) {
        if (column_name(abscissa) == columns.measured)
            throw InputError(name_of_command, "would fit the column '" + columns.measured +
                                                  "' against itself; name another one by --abscissa");
    }
    if (table.names.empty() && table.columns() != asked)
        throw InputError(
            file, fmt::format("has {} columns without names, but must have {} or a head line", table.columns(), asked));
    return columns;
}

/// The head of the JSON: which columns were read.
Json json_head(const Columns& columns, Convergence verdict) {
    return {{"abscissa", columns.abscissae}, {"measured", columns.measured}, {"verdict", text_of(verdict)}};
}

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json numbers(const std::vector<double>& values) {
    Json list = Json::array();
    for (const double value : values) list.push_back(number(value));
    return list;
}

void add_order(const FitOutcome& outcome, Answer& answer) {
    if (outcome.fit) {
        const OrderFit& fit = *outcome.fit;
        answer.lines.push_back("order " + reports::words_of({fit.order, fit.low, fit.high}) +
                               fmt::format(", coefficient {:.4g}", fit.coefficient));
        std::string neighbours;
        for (const double order : fit.neighbours) neighbours += fmt::format(" {:.3f}", order);
        answer.lines.push_back("orders between neighbours, coarse to fine:" + neighbours);
        if (fit.floor > 0) answer.lines.push_back(fmt::format("floor {:.4g}", fit.floor));
    }
    OrderFit none;
    none.order = none.low = none.high = none.coefficient = none.floor = nothing;
    const OrderFit fit = outcome.fit.value_or(none);
    answer.json["order"] = {{"value", number(fit.order)},
                            {"low", number(fit.low)},
                            {"high", number(fit.high)},
                            {"coefficient", number(fit.coefficient)},
                            {"neighbours", numbers(fit.neighbours)},
                            {"model", outcome.fit ? text_of(outcome.fit->model) : ""},
                            {"floor", number(fit.floor)},
                            {"reason", outcome.reason}};
}

Answer joint_answer(const NumberTable& table, const Columns& columns, const std::string& file) {
    const auto h = abscissa_of(table, columns.abscissae[0], 0, file);
    const auto dt = abscissa_of(table, columns.abscissae[1], 1, file);
    const auto errors = table.column(columns.measured, 2, file);
    std::vector<JointPoint> points;
    for (std::size_t i = 0; i < h.size(); ++i) points.push_back({h[i], dt[i], errors[i]});
    const JointFit fit = fit_joint(points);
    Answer answer{fit.verdict, reports::lines_of(fit), json_head(columns, fit.verdict)};
    answer.lines.insert(answer.lines.begin(), "h = " + columns.abscissae[0] + ", dt = " + columns.abscissae[1]);
    answer.json["joint"] = reports::json_of(fit);
    return answer;
}

Answer order_answer(const NumberTable& table, const Columns& columns, const std::string& file) {
    const auto h = abscissa_of(table, columns.abscissae[0], 0, file);
    const auto errors = table.column(columns.measured, 1, file);
    std::vector<FitPoint> points;
    for (std::size_t i = 0; i < h.size(); ++i) points.push_back({h[i], errors[i]});
    const FitOutcome outcome = fit_order(points);
    Answer answer{outcome.verdict, {}, json_head(columns, outcome.verdict)};
    add_order(outcome, answer);
    for (const auto& [place, why] : outcome.left_out)
        answer.lines.push_back(fmt::format("left out: row {} ({})", place + 1, why));
    answer.lines.push_back(text_of(outcome.verdict) + ": " + outcome.reason);
    const bool inverted = column_name(columns.abscissae[0]) != columns.abscissae[0];
    if (outcome.verdict == Convergence::diverges && are_counts(h) && !inverted)
        answer.lines.push_back(
            "the abscissa counts something; where it should fall under refinement, take one over it: "
            "--abscissa 1/" +
            columns.abscissae[0]);
    return answer;
}

/// Verdict and reason on values without an exact solution. Four grids are judged by Eca-Hoekstra, and their order by
/// the formal one where it is given; fewer have no interval, so that they prove nothing but that order, by GCI.
std::pair<Convergence, std::string> judged(const FitOutcome& order, const std::vector<Extrapolation>& found,
                                           std::size_t grids, double formal) {
    if (found.size() == 1) return {found[0].verdict, found[0].reason};
    const bool formal_given = !std::isnan(formal);
    if (grids < 4 && !formal_given)
        return {Convergence::inconclusive, "fewer than four grids and no --formal order to hold them to"};
    const auto& judge = found[grids > 3 ? 2 : 1];
    const bool off =
        grids > 3 && formal_given && order.fit && !(order.fit->low <= formal + 0.1 && formal - 0.1 <= order.fit->high);
    if (judge.verdict == Convergence::converges && off)
        return {Convergence::inconclusive, fmt::format("the order found is not the formal one, {}", formal)};
    return {judge.verdict, judge.reason.empty() ? "by " + judge.method : judge.reason};
}

Answer value_answer(const NumberTable& table, const Columns& columns, const std::string& file, double formal) {
    const auto h = abscissa_of(table, columns.abscissae[0], 0, file);
    const auto values = table.column(columns.measured, 1, file);
    std::vector<GridValue> grids;
    for (std::size_t i = 0; i < h.size(); ++i) grids.push_back({h[i], values[i]});
    const auto found = extrapolations(grids, formal);
    const FitOutcome order = fit_order_of_values(grids);
    const auto [verdict, reason] = judged(order, found, grids.size(), formal);
    Answer answer{verdict, {}, json_head(columns, verdict)};
    add_order(order, answer);
    answer.json["extrapolations"] = Json::array();
    for (const auto& each : found) {
        answer.lines.push_back(reports::line_of(each));
        if (!each.assumes.empty()) answer.lines.push_back("  assumes: " + each.assumes);
        answer.json["extrapolations"].push_back(reports::json_of(each));
    }
    answer.lines.push_back(text_of(verdict) + ": " + reason);
    return answer;
}

Answer answer_to(const po::variables_map& options, const std::string& file) {
    const bool values = options.contains("value");
    if (values && options.contains("error")) throw InputError(name_of_command, "takes --error or --value, not both");
    if (options.contains("formal") && !values) throw InputError(name_of_command + " --formal", "belongs to --value");
    const double formal = options.contains("formal") ? options["formal"].as<double>() : std::nan("");
    if (options.contains("formal") && !(formal > 0)) throw InputError(name_of_command + " --formal", "must be > 0");
    const NumberTable table = table_from(file);
    const Columns columns = columns_of(options, table, file, values ? "value" : "error");
    if (!values)
        return columns.abscissae.size() == 2 ? joint_answer(table, columns, file) : order_answer(table, columns, file);
    if (columns.abscissae.size() == 2) throw InputError(name_of_command + " --value", "takes one abscissa");
    return value_answer(table, columns, file, formal);
}

int run(const po::variables_map& options, const std::vector<std::string>& files) {
    if (files.size() != 1) throw InputError(name_of_command, "takes one table; usage: ordo fit FILE|-");
    const bool text = format_of<bool>(options, {{"text", true}, {"json", false}}, name_of_command);
    const Answer answer = answer_to(options, files.front());
    if (text) {
        for (const auto& line : answer.lines) std::cout << one_line(line) << '\n';
    } else {
        std::cout << answer.json.dump(1, ' ', false, Json::error_handler_t::replace) << '\n';
    }
    return answer.verdict == Convergence::converges ? all_hold : gate_failed;
}

}  // namespace

Command fit_command() {
    po::options_description options("options");
    // clang-format off
    options.add_options()
        ("abscissa", po::value<std::string>()->value_name("NAME"),
         "column that is refined (default the first), or one over it, 1/cells; two, h,dt, for a joint fit")
        ("error", po::value<std::string>()->value_name("NAME"), "column of errors (default 'error', or the other one)")
        ("value", po::value<std::string>()->value_name("NAME"), "column of values instead: there is no exact solution")
        ("formal", po::value<double>()->value_name("P"), "order that the method should have; with --value")
        ("format", po::value<std::string>()->value_name("NAME")->default_value("text"), "text or json");
    // clang-format on
    return {.name = "fit",
            .about = "the order in your own numbers: of errors, of a dx-dt grid, or without an exact solution",
            .usage = "FILE|- [--abscissa NAME[,NAME]] [--error NAME | --value NAME [--formal P]] [--format text|json]",
            .examples = {"ordo fit errors.csv", "ordo fit errors.csv --abscissa 1/cells",
                         "ordo fit grid.csv --abscissa h,dt --error l2",
                         "printf '1 0.9705\\n2 0.96854\\n4 0.96178\\n' | ordo fit - --value f"},
            .options = options,
            .most_arguments = 1,
            .run = run};
}

}  // namespace ordo::app
