#include "app/basis_view.hpp"

#include <algorithm>
#include <limits>

#include "core/text.hpp"

namespace ordo::app {
namespace {

using namespace solvers::mpm;
using reports::Curves;
using reports::FunctionPanel;

double number_of(Mapping mapping) { return mapping == Mapping::weighted ? 1 : 2; }

/// Columns that grow by rows: the name of a basis, then numbers; numbers that a row lacks are NaN.
class Rows {
public:
    explicit Rows(const std::vector<std::string>& names) {
        columns_.push_back({"basis", {}});
        for (const auto& name : names) columns_.push_back({name, {}});
    }
    void add(const std::string& basis, const std::vector<double>& numbers) {
        columns_.front().words.push_back(basis);
        for (std::size_t k = 1; k < columns_.size(); ++k)
            columns_[k].values.push_back(k <= numbers.size() ? numbers[k - 1]
                                                             : std::numeric_limits<double>::quiet_NaN());
    }
    const std::vector<Column>& columns() const { return columns_; }

private:
    std::vector<Column> columns_;
};

std::vector<double> appended(std::vector<double> numbers, const Weights& weights, std::size_t row) {
    for (Eigen::Index k = 0; k < weights.cols(); ++k) numbers.push_back(weights(static_cast<Eigen::Index>(row), k));
    return numbers;
}

/// `head`, and behind it "S_0", "S_1", ... from `first` on.
std::vector<std::string> numbered(std::vector<std::string> head, const std::string& letter, long first, long count) {
    for (long k = 0; k < count; ++k) head.push_back(letter + "_" + std::to_string(first + k));
    return head;
}

Weights grid_part(Show show, const Picture& picture, const std::vector<double>& x) {
    return show == Show::grid ? grid_basis(picture, x) : interpolated_tents(picture, x);
}

std::vector<Column> grid_columns(Show show, const std::vector<Shown>& all) {
    long nodes = 0;
    for (const auto& one : all) nodes = std::max<long>(nodes, one.picture.nodes());
    Rows rows(numbered({"x"}, "S", 0, nodes));
    for (const auto& [basis, picture] : all) {
        const auto x = drawing_points(picture);
        const Weights S = grid_part(show, picture, x);
        for (std::size_t k = 0; k < x.size(); ++k) rows.add(basis, appended({x[k]}, S, k));
    }
    return rows.columns();
}

std::vector<Column> particle_columns(const std::vector<Shown>& all, const Mappings& mappings) {
    Rows rows(numbered({"option", "x"}, "Phi", 1, all.front().picture.count()));
    for (const auto& [basis, picture] : all) {
        const auto x = drawing_points(picture);
        for (const Mapping mapping : mappings) {
            const Weights Phi = particle_basis(picture, nodal_map(picture, mapping), x);
            for (std::size_t k = 0; k < x.size(); ++k) rows.add(basis, appended({number_of(mapping), x[k]}, Phi, k));
        }
    }
    return rows.columns();
}

/// f = 1 and f = x, back at the particles first, then as fields between them.
std::vector<Column> reproduction_columns(const std::vector<Shown>& all, const Mappings& mappings) {
    Rows rows({"option", "at_particle", "x", "constant", "linear"});
    for (const auto& [basis, picture] : all) {
        const Eigen::VectorXd x_p = picture.positions();
        const auto x = points_between_particles(picture);
        for (const Mapping mapping : mappings) {
            const NodalMap map = nodal_map(picture, mapping);
            const auto constant = reproduced(picture, map, Eigen::VectorXd::Ones(x_p.size()), x);
            const auto linear = reproduced(picture, map, x_p, x);
            for (Eigen::Index p = 0; p < x_p.size(); ++p)
                rows.add(basis, {number_of(mapping), 1, x_p[p], constant.at_particles[p], linear.at_particles[p]});
            for (std::size_t k = 0; k < x.size(); ++k) {
                const auto row = static_cast<Eigen::Index>(k);
                rows.add(basis, {number_of(mapping), 0, x[k], constant.at_x[row], linear.at_x[row]});
            }
        }
    }
    return rows.columns();
}

std::vector<Column> error_columns(const std::vector<Shown>& all, const Mappings& mappings) {
    Rows rows({"option", "ppc", "translate", "stretch", "particles", "nodes", "rank", "constant_at_particles",
               "linear_at_particles", "constant_between", "linear_between", "without_field", "amplification"});
    for (const auto& [basis, picture] : all) {
        for (const Mapping mapping : mappings) {
            const NodalMap map = nodal_map(picture, mapping);
            const Errors e = errors_of(picture, map);
            const Lineup& l = picture.lineup;
            rows.add(basis, {number_of(mapping), l.ppc, l.translate, l.stretch, static_cast<double>(picture.count()),
                             static_cast<double>(std::ranges::count(picture.touched, true)),
                             static_cast<double>(map.rank), e.at_particles[0], e.at_particles[1], e.between[0],
                             e.between[1], e.without_field, e.amplification});
        }
    }
    return rows.columns();
}

/// A function a column, NaN where it and its neighbours vanish: lines along the axis would hide the others.
std::vector<std::vector<double>> by_column(const Weights& weights) {
    constexpr double round_off = 1e-12;
    std::vector<std::vector<double>> columns;
    for (const auto& column : weights.colwise()) {
        columns.emplace_back(column.begin(), column.end());
        for (Eigen::Index k = 0; k < column.size(); ++k) {
            const Eigen::Index first = std::max<Eigen::Index>(k - 1, 0);
            const Eigen::Index count = std::min<Eigen::Index>(k + 2, column.size()) - first;
            if (column.segment(first, count).cwiseAbs().maxCoeff() < round_off)
                columns.back()[static_cast<std::size_t>(k)] = std::numeric_limits<double>::quiet_NaN();
        }
    }
    return columns;
}

Curves backdrop(const Picture& picture, const std::vector<double>& x) {
    return {x, by_column(grid_functions(picture, x)), {}, Curves::Style::backdrop};
}

FunctionPanel grid_panel(Show show, const Shown& one) {
    const auto x = drawing_points(one.picture);
    const std::string what =
        show == Show::grid ? ": S_i seen by a particle at x" : ": tents interpolated over the boxes";
    return {one.basis + what, {backdrop(one.picture, x), {x, by_column(grid_part(show, one.picture, x))}}};
}

/// Over the body only: where it has no particles, option 2 goes on in steep lines that would flatten all others.
FunctionPanel particle_panel(const Shown& one, Mapping mapping) {
    auto x = drawing_points(one.picture);
    const auto& corners = one.picture.corners;
    std::erase_if(x, [&](double at) { return at < corners.front() || at > corners.back(); });
    const Weights Phi = particle_basis(one.picture, nodal_map(one.picture, mapping), x);
    const std::string option = mapping == Mapping::weighted ? ", option 1" : ", option 2";
    return {one.basis + ": particle basis Phi_p" + option, {{x, by_column(Phi)}}};
}

/// What is wrong with f = 1 and f = x, lines between the particles and dots at them.
FunctionPanel reproduction_panel(const Shown& one, const Mappings& mappings) {
    const Eigen::VectorXd x_p = one.picture.positions();
    const auto x = points_between_particles(one.picture);
    Curves lines{x, {}, {}, Curves::Style::lines};
    Curves dots{{x_p.begin(), x_p.end()}, {}, {}, Curves::Style::points};
    for (const Mapping mapping : mappings) {
        const NodalMap map = nodal_map(one.picture, mapping);
        for (const bool linear : {false, true}) {
            const Eigen::VectorXd f = linear ? x_p : Eigen::VectorXd::Ones(x_p.size());
            const auto [at_particles, at_x] = reproduced(one.picture, map, f, x);
            lines.names.push_back(std::string(linear ? "x" : "1") + ", option " + shortest(number_of(mapping)));
            lines.values.emplace_back();
            for (std::size_t k = 0; k < x.size(); ++k)
                lines.values.back().push_back(at_x[static_cast<Eigen::Index>(k)] - (linear ? x[k] : 1));
            const Eigen::VectorXd error = at_particles - f;
            dots.values.emplace_back(error.begin(), error.end());
        }
    }
    return {one.basis + ": error of f = 1 and f = x", {lines, dots}};
}

std::vector<FunctionPanel> panels_of(Show show, const Shown& one, const Mappings& mappings) {
    if (show == Show::reproduction) return {reproduction_panel(one, mappings)};
    if (show != Show::particle) return {grid_panel(show, one)};
    std::vector<FunctionPanel> panels;
    for (const Mapping mapping : mappings) panels.push_back(particle_panel(one, mapping));
    return panels;
}

}  // namespace

std::vector<Column> columns_of(Show show, const std::vector<Shown>& all, const Mappings& mappings) {
    switch (show) {
        case Show::particle: return particle_columns(all, mappings);
        case Show::reproduction: return reproduction_columns(all, mappings);
        case Show::errors: return error_columns(all, mappings);
        default: return grid_columns(show, all);
    }
}

reports::FunctionFigure figure_of(const std::vector<Show>& shows, const std::vector<Shown>& all,
                                  const Mappings& mappings) {
    const Picture& first = all.front().picture;
    const Lineup& l = first.lineup;
    const Eigen::VectorXd x_p = first.positions();
    reports::FunctionFigure figure;
    figure.title = "grid and particle basis";
    figure.subtitle =
        "ppc = " + shortest(l.ppc) + ", translate = " + shortest(l.translate) + ", stretch = " + shortest(l.stretch);
    figure.abscissa = "x [cells]";
    figure.to = l.cells;
    figure.particles.assign(x_p.begin(), x_p.end());
    figure.corners = first.corners;
    for (const auto& one : all) {
        std::size_t count = 0;
        for (const Show show : shows) {
            for (auto& panel : panels_of(show, one, mappings)) {
                figure.panels.push_back(std::move(panel));
                ++count;
            }
        }
        figure.across = count < 4 ? count : 2;
    }
    return figure;
}

}  // namespace ordo::app
