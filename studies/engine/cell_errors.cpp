#include "studies/engine/cell_errors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "studies/engine/cell_parts.hpp"

namespace ordo::studies {
namespace {

using oracles::Exact;

/// Adds up the integrals of one field's error.
class Integration {
public:
    Integration(const CellField& field, const Exact& exact, double t) : field_(field), exact_(exact), t_(t) {}

    /// Over all parts, with the rows of the exact solution at their nodes.
    CellErrors over(std::vector<CellPart> parts, std::vector<double> rows) {
        constexpr int deepest = 50;
        constexpr double nan = std::numeric_limits<double>::quiet_NaN();
        const std::size_t most = 64 * parts.size() + 1024;  // more come from round-off, which never ends
        const bool any_fan = std::ranges::any_of(parts, &CellPart::in_fan);
        if (parts.empty()) return {nan, nan, nan, nan, nan};
        set_scale(parts.size(), rows);
        for (int level = 0; !parts.empty(); ++level) {
            const bool last = level == deepest || parts.size() > most;
            std::vector<CellPart> halves;
            for (std::size_t i = 0; i < parts.size(); ++i) {
                const auto e = errors_at_nodes(parts[i], rows, i);
                if (last || resolved(parts[i], e)) add(parts[i], e);
                else halve(parts[i], halves);
            }
            parts = std::move(halves);
            rows = rows_at_nodes(exact_, t_, parts);
        }
        return {near_ + away_, std::sqrt(squares_), any_fan ? fans_ : nan, near_, away_};
    }

private:
    /// What counts as nothing, from the field's values, exact and found.
    void set_scale(std::size_t parts, std::span<const double> rows) {
        const Profile& found = field_.found;
        double low = found.at_left(0), high = low;
        const auto include = [&](double value) {
            low = std::min(low, value);
            high = std::max(high, value);
        };
        const std::size_t width = exact_.width();
        for (std::size_t k = field_.offset; k < rows.size(); k += width) include(rows[k]);
        for (std::size_t i = 0; i < found.cells(); ++i) {
            include(found.at_left(i));
            include(found.at_right(i));
        }
        const double size = std::max(std::abs(low), std::abs(high));
        const double length = found.edges.back() - found.edges.front();
        noise_ = 1e-14 * size;
        tolerance_ = (1e-10 * (high - low) + 1e-12 * size) * length / static_cast<double>(parts);
    }

    Kronrod::Values errors_at_nodes(const CellPart& part, std::span<const double> rows, std::size_t number) const {
        Kronrod::Values e;
        const std::size_t width = exact_.width();
        for (std::size_t i = 0; i < Kronrod::size; ++i) {
            const double exact = rows[(number * Kronrod::size + i) * width + field_.offset];
            e[i] = field_.found.at(part.cell, part.node(i)) - exact;
        }
        return e;
    }

    /// Whether Gauss's rule agrees with Kronrod's, for e and, since an odd e has no integral, for e times s - 1/2.
    bool resolved(const CellPart& part, const Kronrod::Values& e) const {
        const auto& [place, weight, coarse, barycentric] = kronrod();
        double plain = 0, turned = 0;
        for (std::size_t i = 0; i < Kronrod::size; ++i) {
            const double difference = (weight[i] - coarse[i]) * e[i];
            plain += difference;
            turned += difference * (2 * place[i] - 1);
        }
        const double doubt = std::max(std::abs(plain), std::abs(turned)) * (part.b - part.a);
        return !(doubt > tolerance_);
    }

    /// e is the polynomial through its values at the nodes; |e| is integrated between its zeros.
    void add(const CellPart& part, const Kronrod::Values& e) {
        const Kronrod& rule = kronrod();
        const double width = part.b - part.a;
        double sizes = 0, squares = 0;
        for (std::size_t i = 0; i < Kronrod::size; ++i) {
            sizes += rule.weight[i] * std::abs(e[i]);
            squares += rule.weight[i] * e[i] * e[i];
        }
        const auto zeros = std::isfinite(sizes) ? rule.sign_changes(e, noise_) : std::vector<double>{};
        if (!zeros.empty()) {
            double from = 0;
            sizes = 0;
            for (const double zero : zeros) {
                sizes += std::abs(rule.integral(e, from, zero));
                from = zero;
            }
            sizes += std::abs(rule.integral(e, from, 1));
        }
        (part.near_wave ? near_ : away_) += sizes * width;
        squares_ += squares * width;
        if (part.in_fan) fans_ += sizes * width;
    }

    static void halve(const CellPart& part, std::vector<CellPart>& halves) {
        const double middle = part.a + 0.5 * (part.b - part.a);
        for (const auto& [a, b] : {std::array{part.a, middle}, std::array{middle, part.b}}) {
            const CellPart half{a, b, part.cell, part.in_fan, part.near_wave};
            if (half.has_inside()) halves.push_back(half);
        }
    }

    const CellField& field_;
    const Exact& exact_;
    double t_;
    double noise_ = 0;      ///< of e
    double tolerance_ = 0;  ///< of the integral over one part
    double near_ = 0, away_ = 0, squares_ = 0, fans_ = 0;
};

}  // namespace

std::vector<CellErrors> cell_errors(std::span<const CellField> fields, const Exact& exact, double t, double near) {
    if (exact.dim != 1 || exact.coordinates != oracles::Coordinates::spatial)
        throw std::logic_error("cells are compared with a solution in space and one dimension only");
    std::vector<CellErrors> errors;
    if (fields.empty()) return errors;
    const auto edges = fields.front().found.edges;
    const auto falls = [](double a, double b) { return !(a <= b); };
    if (std::ranges::adjacent_find(edges, falls) != edges.end()) throw std::logic_error("the cells' edges do not rise");
    exact.check(std::array{edges.front(), edges.back()}, t, "the cells and the exact solution");
    const auto parts = parts_of(exact, t, edges, near);
    const auto rows = rows_at_nodes(exact, t, parts);
    for (const auto& field : fields) errors.push_back(Integration(field, exact, t).over(parts, rows));
    return errors;
}

}  // namespace ordo::studies
