#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <regex>

#include "core/text.hpp"
#include "studies/reader/parts.hpp"

namespace ordo::studies {
namespace {

std::vector<std::string> axis_names(const Study& study) {
    std::vector<std::string> names;
    for (const auto& axis : study.sweep.axes) names.push_back(axis.name);
    return names;
}

std::vector<std::string> quantity_keys(const Study& study) {
    std::vector<std::string> keys;
    for (const auto& quantity : study.measure.quantities) keys.push_back(quantity.key());
    return keys;
}

std::vector<std::string> solver_labels(const Study& study) {
    std::vector<std::string> labels;
    for (const auto& solver : study.solvers) labels.push_back(solver.label);
    return labels;
}

/// "cells <= 32" as a condition on a swept axis.
Condition condition_from(const Node& node, const Study& study) {
    static const std::regex form(R"(\s*([A-Za-z_]\w*)\s*(<=|>=|<|>|=)\s*([-+.\w]+)\s*)");
    const std::string text = node.text();
    std::smatch parts;
    if (!std::regex_match(text, parts, form))
        node.refuse("is '" + text + "', but must be: axis op number, for instance 'cells <= 32'");
    const Value value = value_from(parts[3]);
    if (!std::holds_alternative<double>(value)) node.refuse("'" + parts[3].str() + "' is not a number");
    const auto names = axis_names(study);
    if (std::find(names.begin(), names.end(), parts[1].str()) == names.end()) {
        node.refuse("'" + parts[1].str() + "' is not an axis of the sweep" + did_you_mean(parts[1].str(), names));
    }
    return {parts[1], parts[2], std::get<double>(value)};
}

double positive_number(const Node& node) {
    const double value = node.number();
    if (!(value > 0) || !std::isfinite(value)) node.refuse("is " + shortest(value) + ", but must be > 0");
    return value;
}

/// The abscissa of an order, which the study must fit against; "" for those of the sweep's path.
std::string against_from(const Node& node, const Study& study, bool order) {
    auto fitted = study.measure.orders_against;
    if (fitted.empty()) fitted = own_abscissae(study.sweep.path);
    if (node.has("against")) {
        if (!order) node.at("against").refuse("belongs to 'order' only");
        node.at("against").one_of(fitted);
        return node.at("against").text();
    }
    const auto own = [](const std::string& abscissa) { return abscissa == "h" || abscissa == "dt"; };
    if (order && std::none_of(fitted.begin(), fitted.end(), own))
        node.refuse("must say 'against' what its order is: " + joined(fitted));
    return "";
}

/// "order": "expected".
bool order_follows(const Node& node) {
    if (!node.has("order") || !node.at("order").is_text()) return false;
    const std::string word = node.at("order").text();
    if (word != "expected") node.at("order").refuse("is '" + word + "', but must be a number or 'expected'");
    return true;
}

/// The other number that a number of the same run is held to.
void read_other(const Node& node, const Study& study, Expectation& expectation) {
    node.at("agrees_with").one_of(quantity_keys(study));
    expectation.other = node.at("agrees_with").text();
}

bool is_about_number(const Expectation& expectation) {
    return expectation.kind == Expectation::Kind::value || expectation.kind == Expectation::Kind::agreement;
}

/// What an order or a number is held to besides its value.
void read_band(const Node& node, bool order, bool number, Expectation& expectation) {
    if (order || number) expectation.within = positive_number(node.at("within"));
    else if (node.has("within")) node.at("within").refuse("belongs to 'order', 'value' and 'agrees_with' only");
    for (const std::string member : {"may_exceed", "levels"}) {
        if (!order && node.has(member)) node.at(member).refuse("belongs to 'order' only");
    }
    if (node.has("may_exceed")) {
        expectation.may_exceed = node.at("may_exceed").text();
        if (expectation.may_exceed.empty()) node.at("may_exceed").refuse("is empty, but must say why");
    }
    if (!node.has("levels")) return;
    const double levels = node.at("levels").number();
    if (!(levels >= 2 && levels <= 10'000 && levels == std::floor(levels)))
        node.at("levels").refuse("is " + shortest(levels) + ", but must be a whole number from 2 to 10000");
    expectation.levels = static_cast<int>(levels);
}

Expectation expectation_from(const Node& node, const Study& study) {
    static const std::array<std::string, 5> kinds{"order", "error_at_most", "exact_within", "value", "agrees_with"};
    node.only({"order", "within", "may_exceed", "levels", "error_at_most", "exact_within", "value", "agrees_with",
               "against", "where", "of", "solver", "source"});
    Expectation expectation;
    int claims = 0;
    for (std::size_t k = 0; k < kinds.size(); ++k) {
        if (!node.has(kinds[k])) continue;
        ++claims;
        expectation.kind = static_cast<Expectation::Kind>(k);
        if (expectation.kind == Expectation::Kind::agreement) read_other(node, study, expectation);
        else if (expectation.kind == Expectation::Kind::value) expectation.value = node.at(kinds[k]).number();
        else if (k > 0) expectation.value = positive_number(node.at(kinds[k]));
        else if (!order_follows(node)) expectation.value = node.at(kinds[k]).number();
    }
    if (claims != 1) node.refuse("must hold exactly one of: order, error_at_most, exact_within, value, agrees_with");
    const bool order = expectation.kind == Expectation::Kind::order;
    const bool number = is_about_number(expectation);
    read_band(node, order, number, expectation);
    expectation.against = against_from(node, study, order);
    if (node.has("where")) {
        for (const auto& item : node.at("where").items()) expectation.where.push_back(condition_from(item, study));
    }
    if (node.has("of")) {
        for (const auto& item : node.at("of").items()) {
            item.one_of(quantity_keys(study));
            expectation.quantities.push_back(item.text());
        }
    }
    if (node.has("solver")) {
        for (const auto& item : node.at("solver").items()) {
            item.one_of(solver_labels(study));
            expectation.solvers.push_back(item.text());
        }
    }
    if (number && expectation.quantities.empty()) {
        if (study.measure.quantities.size() != 1) node.refuse("must name in 'of' what has that value");
        expectation.quantities.push_back(study.measure.quantities.front().key());
    }
    for (const auto& quantity : study.measure.quantities) {
        const auto& spoken = expectation.quantities;
        const bool named = spoken.empty() || std::find(spoken.begin(), spoken.end(), quantity.key()) != spoken.end();
        if (named && number != is_value(quantity.norm))
            node.refuse("'" + quantity.key() + "' is " +
                        (number ? "an error, which has no value to hold it to (nearest: error_at_most)"
                                : "no error but a number (nearest: value, agrees_with)"));
        if (!order && named && quantity.against == Against::itself)
            node.refuse("bounds '" + quantity.key() + "', which is no error; name errors in 'of'");
    }
    expectation.source = node.at("source").text();
    return expectation;
}

PublishedValue published_value(const Node& row, const Study& study) {
    static const std::regex decimal(R"(-?\d+(\.\d+)?([eE][-+]?\d+)?)");
    PublishedValue value;
    auto allowed = axis_names(study);
    allowed.push_back("value");
    row.only(allowed);
    for (const auto& member : row.members()) {
        if (member.key() != "value") value.axes[member.key()] = member.number();
    }
    value.printed = row.at("value").text();
    if (!std::regex_match(value.printed, decimal))
        row.at("value").refuse("is '" + value.printed + "', but must be a decimal number as printed");
    double number = 0;
    if (std::from_chars(value.printed.data(), value.printed.data() + value.printed.size(), number).ec != std::errc{})
        row.at("value").refuse("is '" + value.printed + "', which no double holds");
    for (const auto& axis : study.sweep.axes) {
        if (axis.values.size() > 1 && !value.axes.contains(axis.name))
            row.refuse("does not say which '" + axis.name + "'");
    }
    return value;
}

Published published_table(const Node& node, const Study& study) {
    node.only({"table", "compare", "band", "because", "solver"});
    Published published;
    const Node table = node.at("table");
    table.only({"id", "title", "source", "quantity", "rows"});
    published.id = table.at("id").text();
    published.title = table.at("title").text();
    published.source = table.at("source").text();
    table.at("quantity").one_of(quantity_keys(study));
    published.quantity = table.at("quantity").text();
    published.compare = static_cast<Compare>(node.at("compare").one_of({"digits", "band", "none"}));
    if (published.compare == Compare::band) published.band = positive_number(node.at("band"));
    else if (node.has("band")) node.at("band").refuse("belongs to compare 'band' only");
    if (published.compare == Compare::none || node.has("because")) published.because = node.at("because").text();
    if (node.has("solver")) node.at("solver").one_of(solver_labels(study));
    else if (study.solvers.size() > 1)
        node.refuse("must name its 'solver', since the study has several (" + joined(solver_labels(study)) + ")");
    published.solver = node.has("solver") ? node.at("solver").text() : study.solvers.front().label;
    if (published.id.empty()) table.at("id").refuse("is empty");
    if (published.compare == Compare::none && published.because.empty()) node.at("because").refuse("is empty");
    for (const auto& row : table.at("rows").items()) {
        auto value = published_value(row, study);
        for (const auto& before : published.values) {
            if (before.axes == value.axes) row.refuse("repeats a row: its place in the sweep has a value already");
        }
        published.values.push_back(std::move(value));
    }
    if (published.values.empty()) table.at("rows").refuse("is an empty list");
    return published;
}

}  // namespace

std::vector<Expectation> expectations_from(const Node& node, const Study& study) {
    std::vector<Expectation> expectations;
    for (const auto& item : node.items()) {
        const Expectation expectation = expectation_from(item, study);
        if (!order_follows(item)) {
            expectations.push_back(expectation);
            continue;
        }
        for (auto& one : expected_orders(item.at("order"), expectation, study)) expectations.push_back(std::move(one));
    }
    return expectations;
}

void inline_published(Json& document, const std::string& where, const std::string& folder) {
    if (!document.is_object() || !document.contains("published")) return;
    auto& published = document["published"];
    if (!published.is_array()) published = Json::array({published});
    std::size_t index = 0;
    for (auto& entry : published) {
        const Node node(entry, where, "/published/" + std::to_string(index++));
        if (!node.has("file")) continue;
        node.only({"file", "compare", "band", "because", "solver"});
        const auto path = (std::filesystem::path(folder) / node.at("file").text()).string();
        Json table = parse_json(read_text(path), path);
        Json complete{{"table", std::move(table)}};
        for (const auto& [name, value] : entry.items()) {
            if (name != "file") complete[name] = value;
        }
        entry = std::move(complete);
    }
}

std::vector<Published> published_from(const Node& node, const Study& study) {
    std::vector<Published> tables;
    for (const auto& item : node.items()) {
        tables.push_back(published_table(item, study));
        for (std::size_t k = 0; k + 1 < tables.size(); ++k) {
            if (tables[k].id == tables.back().id) item.refuse("repeats the table '" + tables[k].id + "'");
        }
    }
    return tables;
}

}  // namespace ordo::studies
