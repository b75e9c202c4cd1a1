// The door: from declared values to a running line.
#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "solvers/media/fields.hpp"
#include "solvers/rrm/options.hpp"
#include "solvers/rrm/rrm.hpp"

namespace ordo::solvers::rrm {
namespace {

/// The part of the pieces within [lower, upper].
std::vector<Piece> within(std::vector<Piece> pieces, double lower, double upper) {
    std::erase_if(pieces, [&](const Piece& p) { return !(p.to > lower) || !(p.from < upper); });
    for (Piece& p : pieces) {
        const double from = std::max(p.from, lower);
        const double to = std::min(p.to, upper);
        if (from == p.from && to == p.to) continue;
        const Contents rise = (1 / (p.to - p.from)) * (p.right - p.left);
        p.mean += 0.5 * ((from + to) - (p.from + p.to)) * rise;
        p.left += (from - p.from) * rise;
        p.right += (to - p.to) * rise;
        p.from = from;
        p.to = to;
    }
    return pieces;
}

/// The pieces of a ring, brought back between its ends.
std::vector<Piece> unrolled(const std::vector<Piece>& ring, double lower, double upper) {
    const double length = upper - lower;
    std::vector<Piece> line;
    for (Piece p : ring) {
        const double shift = -length * std::floor((p.from - lower) / length);
        p.from += shift;
        p.to += shift;
        for (const double back : {0.0, length}) {
            Piece copy = p;
            copy.from -= back;
            copy.to -= back;
            const auto part = within({copy}, lower, upper);
            line.insert(line.end(), part.begin(), part.end());
        }
    }
    std::ranges::sort(line, {}, &Piece::from);
    return line;
}

Contents sum_of(const std::vector<Piece>& pieces, bool absolute) {
    Contents sum;
    for (const Piece& p : pieces) {
        const Contents part = (p.to - p.from) * p.mean;
        sum += absolute ? Contents{std::abs(part.mass), std::abs(part.momentum), std::abs(part.energy)} : part;
    }
    return sum;
}

template <class M>
class Running final : public Simulation {
public:
    Running(const M& medium, const LineScene& scene, const Options& options, std::span<const std::string> fields)
        : scene_(scene), fields_(line_fields(scene.medium, fields)), line_(medium, scene, options) {
        for (const Contents& q : scene.pieces) {
            const Flow f = medium.flow(q);
            pressure_ = std::max(pressure_, std::abs(f.p));
            fastest_ = std::max(fastest_, std::abs(f.v) + f.a);
        }
    }

    void advance_to(double t, const Interrupt& interrupt) override {
        line_.advance_to(t, interrupt);
        t_ = t;
    }

    Snapshot snapshot() const override {
        const auto pieces = shown();
        std::vector<double> edges{pieces.front().from};
        for (const Piece& p : pieces) edges.push_back(p.to);
        Snapshot shot = snapshot_of_cells(t_, std::move(edges), scene_.medium, fields_,
                                          [&](std::size_t i) { return pieces[i].mean; });
        shot.slopes = rises_over_cells(
            scene_.medium, fields_, pieces.size(), [&](std::size_t i) { return pieces[i].left; },
            [&](std::size_t i) { return pieces[i].right; });
        return shot;
    }

    std::vector<Figure> work() const override {
        const Counts& counts = line_.counts();
        return {{"chop_outs", counts.chop_outs},
                {"unions", counts.unions},
                {"kept_waves", counts.kept_waves},
                {"cells_alive", static_cast<double>(shown().size())}};
    }

    /// Contents now against those at the start and what came in through the ends, relative to the sum of absolute
    /// contents and what the pressure could have brought: momentum p t, energy p t times the fastest wave.
    std::vector<Figure> drift() const override {
        const auto pieces = line_.pieces(t_);
        const auto places = line_.reach(t_);
        const Contents defect = sum_of(pieces, false) - line_.received(t_) - initial(places);
        const Contents size = sum_of(pieces, true);
        const double push = pressure_ * t_;
        const double work = push * fastest_;
        return {{"mass", std::abs(defect.mass) / size.mass},
                {"momentum", std::abs(defect.momentum) / (size.momentum + push)},
                {"energy", std::abs(defect.energy) / (size.energy + work)}};
    }

private:
    std::vector<Piece> shown() const {
        const auto pieces = line_.pieces(t_);
        const double lower = scene_.edges.front();
        const double upper = scene_.edges.back();
        if (scene_.ends[0].kind == LineEnd::Kind::periodic) return unrolled(pieces, lower, upper);
        const auto moves = [](const LineEnd& end) {
            return end.kind == LineEnd::Kind::wall || end.kind == LineEnd::Kind::free;
        };
        if (pieces.empty()) throw Diverged("at t = " + shortest(t_) + " s nothing is left of the line");
        const auto seen = within(pieces, moves(scene_.ends[0]) ? pieces.front().from : lower,
                                 moves(scene_.ends[1]) ? pieces.back().to : upper);
        if (seen.empty())
            throw Diverged("at t = " + shortest(t_) + " s nothing is left of the line where it is observed");
        return seen;
    }

    /// Contents at t = 0 between places that may lie beyond the ends, where the outer states go on.
    Contents initial(const std::array<double, 2>& places) const {
        Contents sum;
        for (std::size_t i = 0; i < scene_.pieces.size(); ++i)
            sum += (scene_.edges[i + 1] - scene_.edges[i]) * scene_.pieces[i];
        const std::array beyond{scene_.edges.front() - places[0], places[1] - scene_.edges.back()};
        for (const std::size_t side : {0, 1}) {
            const LineEnd& end = scene_.ends[side];
            if (end.kind == LineEnd::Kind::prescribed) sum += beyond[side] * end.outside;
            if (end.kind == LineEnd::Kind::reservoir)
                sum += beyond[side] * (side == 0 ? scene_.pieces.front() : scene_.pieces.back());
        }
        return sum;
    }

    LineScene scene_;
    std::vector<LineField> fields_;
    Line<M> line_;
    double pressure_ = 0;  ///< the largest at t = 0 [Pa]
    double fastest_ = 0;   ///< speed of a wave at t = 0 [m/s]
    double t_ = 0;
};

Claim claim(const Values& options) {
    const bool waves = options.word("keep") == "waves";
    std::vector<std::string> sharp;
    if (waves) sharp = {"shock", "contact", "linear", "fan_corner"};
    if (options.word("keep") == "contacts") sharp = {"contact"};
    return {.order_in_space = waves ? 1 : 0.5,
            .order_in_time = 0,
            .conserves = {"mass", "momentum", "energy"},
            .provided = waves ? "in l1 against delta, where waves do not meet: second order against the number of cells"
                              : "in l1 against delta; shocks 1, fans 0.33 to 0.5, contacts that are not kept 0.33",
            .source = "Walker2017",
            .sharp = sharp};
}

Plan plan(const Scene& scene, const Values& options, const Values& resolution) {
    const auto& line = std::get<LineScene>(scene);
    check(line);
    options_from(line, options, resolution);
    return {.h = resolution.number("delta"),
            .dt = 1,
            .points = static_cast<double>(line.pieces.size()) / resolution.number("delta")};
}

std::unique_ptr<Simulation> start(const Scene& scene, const Values& options, const Values& resolution,
                                  std::span<const std::string> fields) {
    const auto& line = std::get<LineScene>(scene);
    check(line);
    const Options chosen = options_from(line, options, resolution);
    return std::visit(
        [&](const auto& medium) -> std::unique_ptr<Simulation> {
            return std::make_unique<Running<std::decay_t<decltype(medium)>>>(medium, line, chosen, fields);
        },
        line.medium);
}

}  // namespace

Solver solver() {
    return {
        .name = "rrm",
        .about =
            "Repeated Replacement Method: intervals of a gas or an elastic line are chopped out, flattened, put back",
        .source = {"Walker2012", "Walker2017"},
        .options = declared_options(),
        .resolution = declared_resolution(),
        .width_axis = "delta",
        .width = "error control delta [-]",
        .fields = line_field_names(),
        .fields_in = line_fields_in,
        .claim = claim,
        .accepts = is_line,
        .plan = plan,
        .start = start};
}

}  // namespace ordo::solvers::rrm
