#include "oracles/riemann/elastic_line.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "core/text.hpp"

namespace ordo::oracles {
namespace {

using elastic::State;

const char* where = "elastic line";

void check(const std::vector<double>& edges, const std::vector<State>& cells) {
    if (edges.empty() || cells.size() != edges.size() + 1)
        throw InputError(where, std::to_string(edges.size()) + " edges for " + std::to_string(cells.size()) +
                                    " cells, but n edges, n >= 1, part n + 1 cells");
    for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
        if (!(edges[i] < edges[i + 1]))
            throw InputError(
                where, "edge " + shortest(edges[i + 1]) + " follows " + shortest(edges[i]) + ", but edges must rise");
    }
    for (const auto& cell : cells) {
        if (!(cell.lambda > 0)) throw InputError(where, "lambda = " + shortest(cell.lambda) + ", but must be > 0");
    }
}

/// When the first piece is crushed: where what goes right from cell i and left from cell j > i meets, lambda is half
/// the sum of their slopes.
double first_crush(const std::vector<double>& P_slope, const std::vector<double>& Q_slope,
                   const std::vector<double>& edges, double c) {
    double first = std::numeric_limits<double>::infinity();
    for (std::size_t j = 1; j < Q_slope.size(); ++j) {
        for (std::size_t i = 0; i < j; ++i) {
            if (P_slope[i] + Q_slope[j] > 0) continue;
            first = std::min(first, (edges[j - 1] - edges[i]) / (2 * c));
        }
    }
    return first;
}

}  // namespace

const ElasticProfile::Piece& ElasticProfile::at(double x) const {
    const auto next = std::upper_bound(pieces.begin() + 1, pieces.end(), x,
                                       [](double value, const Piece& piece) { return value < piece.x; });
    return *(next - 1);
}

double ElasticProfile::reference(double x) const {
    const Piece& piece = at(x);
    return piece.X + (x - piece.x) / piece.state.lambda;
}

ElasticLine::ElasticLine(double E, double rho0, double c_v, std::vector<double> edges, std::vector<State> cells,
                         double place)
    : material_{{E}, {c_v, 0}, rho0}, c_(std::sqrt(E / rho0)), edges_(std::move(edges)), cells_(std::move(cells)) {
    check(edges_, cells_);
    for (const auto& [lambda, v, T] : cells_) {
        P_slope_.push_back(lambda - v / c_);
        Q_slope_.push_back(lambda + v / c_);
    }
    P_.push_back(place);
    Q_.push_back(place);
    for (std::size_t i = 1; i < edges_.size(); ++i) {
        P_.push_back(P_.back() + (edges_[i] - edges_[i - 1]) * P_slope_[i]);
        Q_.push_back(Q_.back() + (edges_[i] - edges_[i - 1]) * Q_slope_[i]);
    }
    crushed_at_ = first_crush(P_slope_, Q_slope_, edges_, c_);
    if (crushed_at_ == 0)
        throw InputError(where,
                         "two cells that touch collide too fast: lambda <= 0 between them, but v_L - v_R must be "
                         "< c (lambda_L + lambda_R)");
}

std::size_t ElasticLine::cell(double X) const {
    return static_cast<std::size_t>(std::upper_bound(edges_.begin(), edges_.end(), X) - edges_.begin());
}

double ElasticLine::right_going(double X) const {
    const std::size_t i = cell(X);
    const std::size_t edge = i == 0 ? 0 : i - 1;
    return P_[edge] + (X - edges_[edge]) * P_slope_[i];
}

double ElasticLine::left_going(double X) const {
    const std::size_t i = cell(X);
    const std::size_t edge = i == 0 ? 0 : i - 1;
    return Q_[edge] + (X - edges_[edge]) * Q_slope_[i];
}

double ElasticLine::position(double X, double t) const {
    return 0.5 * (right_going(X - c_ * t) + left_going(X + c_ * t));
}

State ElasticLine::state(double X, double t) const {
    const double p = P_slope_[cell(X - c_ * t)];
    const double q = Q_slope_[cell(X + c_ * t)];
    return {0.5 * (p + q), 0.5 * c_ * (q - p), cells_[cell(X)].T};
}

ElasticProfile ElasticLine::profile(double t) const {
    if (!(t < crushed_at_))
        throw InputError(where, "t = " + shortest(t) + " s, but from " + shortest(crushed_at_) +
                                    " s on waves have met that crush the material to lambda <= 0");
    enum Kind { leftwards, material, rightwards };
    struct Border {
        double X;
        Kind kind;
        std::size_t edge;
    };
    std::vector<Border> borders;
    for (std::size_t i = 0; i < edges_.size(); ++i) {
        borders.push_back({edges_[i] - c_ * t, leftwards, i});
        borders.push_back({edges_[i], material, i});
        borders.push_back({edges_[i] + c_ * t, rightwards, i});
    }
    std::stable_sort(borders.begin(), borders.end(), [](const Border& a, const Border& b) { return a.X < b.X; });

    std::array<std::size_t, 3> at{};  // cells that the left-going, material and right-going data come from
    const auto state = [&] {
        const double p = P_slope_[at[rightwards]];
        const double q = Q_slope_[at[leftwards]];
        return State{0.5 * (p + q), 0.5 * c_ * (q - p), cells_[at[material]].T};
    };
    const auto place = [&](const Border& border) {
        if (border.kind == leftwards) return 0.5 * (right_going(border.X - c_ * t) + Q_[border.edge]);
        if (border.kind == rightwards) return 0.5 * (P_[border.edge] + left_going(border.X + c_ * t));
        return position(border.X, t);
    };
    ElasticProfile profile;
    profile.pieces.reserve(borders.size() + 1);
    profile.pieces.push_back({place(borders.front()), borders.front().X, state()});
    for (const auto& border : borders) {
        at[border.kind] = border.edge + 1;
        profile.pieces.push_back({std::max(place(border), profile.pieces.back().x), border.X, state()});
    }
    return profile;
}

elastic::Row ElasticLine::averages(const ElasticProfile& profile, double a, double b) const {
    elastic::Row sum{};
    profile.over(a, b, [&](const ElasticProfile::Piece& piece, double from, double to) {
        const elastic::Row row = fields(piece.state);
        for (std::size_t k = 0; k < row.size(); ++k) sum[k] += row[k] * ((to - from) / (b - a));
    });
    return sum;
}

std::vector<double> ElasticLine::jumps(double t) const {
    std::vector<double> places;
    const ElasticProfile now = profile(t);
    const ElasticProfile::Piece* last = &now.pieces.front();  // the last one that is not empty
    for (std::size_t i = 1; i < now.pieces.size(); ++i) {
        const auto& piece = now.pieces[i];
        if (i + 1 < now.pieces.size() && now.pieces[i + 1].x == piece.x) continue;
        const State& a = last->state;
        const State& b = piece.state;
        if (a.lambda != b.lambda || a.v != b.v || a.T != b.T) places.push_back(piece.x);
        last = &piece;
    }
    return places;
}

}  // namespace ordo::oracles
