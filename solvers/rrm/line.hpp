#pragma once
// The line and its events: find the active front, chop out, flatten, put back.
#include <array>
#include <optional>
#include <vector>

#include "solvers/media/line.hpp"
#include "solvers/rrm/error_metric.hpp"
#include "solvers/rrm/jumps.hpp"
#include "solvers/rrm/schedule.hpp"
#include "solvers/solver.hpp"

namespace ordo::solvers::rrm {

/// What a chop-out keeps sharp.
enum class Keep { nothing, contacts, waves };

/// How fast a front's edges run: the extremes over both cells, or those of each edge's own cell.
enum class Speeds { davis, own };

struct Options {
    Keep keep = Keep::waves;
    Speeds speeds = Speeds::davis;
    Watched allowed{};       ///< flattening error that a chop-out may make: [field] m
    double most_events = 0;  ///< more than these are a refusal
};

struct Counts {
    double chop_outs = 0;
    double unions = 0;
    double kept_waves = 0;  ///< put back as waves of no width
};

/// A piece of the line as it is shown: mean contents of a unit of length, and those at its two ends, which differ where
/// it lies in a fan.
struct Piece {
    double from, to;  ///< [m]
    Contents mean, left, right;
};

/// The line of [Walker2012] as reconstructed: cells in uniform states, fronts between them, and one event after the
/// other. A front that has changed as much as it may is chopped out, flattened to one cell (or to the two on both sides
/// of a contact, or to the waves that its two neighbours send along) and put back, with new fronts to its neighbours. A
/// cell whose core is used up unites its two fronts. Contents move as whole intervals: mass, momentum and energy are
/// kept to round-off.
///
/// M   a medium, solvers/media/medium.hpp
template <class M>
class Line {
public:
    Line(const M& medium, const LineScene& scene, const Options& options);

    /// All events until t. Throws Diverged where matter becomes unphysical, and when there are too many events.
    void advance_to(double t, const Interrupt& interrupt);

    /// Of the whole line; an outer cell of a reservoir ends at reach(t).
    std::vector<Piece> pieces(double t) const;
    const Counts& counts() const { return counts_; }
    /// What came in through the ends until t: mass, momentum, energy.
    Contents received(double t) const;
    /// Half-open outer cells are counted to these places, out of every wave's reach until t.
    std::array<double, 2> reach(double t) const;

private:
    static constexpr std::size_t watched = M::has_temperature ? 4 : 3;
    static std::size_t at(int i) { return static_cast<std::size_t>(i); }
    Cell& cell(int c) { return cells_[at(c)]; }
    const Cell& cell(int c) const { return cells_[at(c)]; }
    Front& front(int f) { return fronts_[at(f)]; }
    const Front& front(int f) const { return fronts_[at(f)]; }

    /// What one front becomes: one cell, or two with a border at x.
    struct Flattened {
        int count;
        double x;
        std::array<State, 2> states;
    };
    /// A uniform stretch of the line at one time; `fan` is not 0 where the front on its right is a jump of a fan.
    struct Stretch {
        double from, to;
        State state;
        int fan;
        std::array<double, 2> birth;  ///< of that front: place and time
    };
    /// New cells side by side, and the places where they meet their neighbours.
    struct Row {
        int n = 0;
        std::array<int, 6> cells;  // two from each of two fronts, and one at each end
        std::array<double, 7> borders;
        std::array<bool, 7> tags{};
    };

    // storage.hpp: cells and fronts by number
    int add_cell(const State& state, double width);
    int add_front();
    int one_more_cell();
    int one_more_front();
    void release_cell(int c);
    void release_front(int f);
    void silence(int f);
    int side_of(int L, int R) const { return is_ghost(L, 0) ? 0 : is_ghost(R, 1) ? 1 : -1; }
    bool is_ghost(int c, std::size_t side) const { return c >= 0 && c == ghosts_[side]; }
    LineEnd::Kind end_between(int L, int R) const;
    std::size_t end_of(const Front& f) const { return lies_at(f, 1) ? 1 : 0; }  ///< where it lies at one
    bool lies_at(const Front& f, std::size_t side) const { return is_ghost(side == 0 ? f.left : f.right, side); }
    bool one_sided(const Front& f) const { return f.end == LineEnd::Kind::wall || f.end == LineEnd::Kind::free; }
    bool takes_from_left(const Front& f) const { return !one_sided(f) || f.right == ghosts_[1]; }
    bool takes_from_right(const Front& f) const { return !one_sided(f) || f.left == ghosts_[0]; }
    double shifted(const Front& f, int c) const { return f.wraps && f.right == c ? -length_ : 0; }
    void fill(const LineScene& scene);

    // find.hpp: when is which front active
    void set_speeds(Front& f, const Flow& l, const Flow& r) const;
    void set_contact_speed(Front& f, const Flow& l, const Flow& r) const;
    void hurry_release(Front& f, std::size_t side) const;
    void start(int id, int L, int R, double x, double t, bool tagged);
    double rate_of_change(const Watched& l, const Watched& r, double w_l, double w_r, bool tagged) const;
    double fresh_until(const Front& f, const Watched& l, const Watched& r) const;
    double end_until(Front& f) const;
    double open_until(const Front& f, const Watched& l, const Watched& r) const;
    double square_of_error(const Front& f, std::size_t k, const Moments& l, const Moments& r) const;
    bool too_much(const Front& f, const Side& l, const Side& r) const;
    /// Fields that a contact keeps apart, and those that a wall or a free end mirrors with the other sign.
    static bool apart(bool tagged, std::size_t k) { return tagged && (k == 0 || k == 3); }
    static bool odd(const Front& f, std::size_t k) {
        return (f.end == LineEnd::Kind::wall && k == 1) || (f.end == LineEnd::Kind::free && k == 2);
    }
    void reschedule(int id);
    void reschedule_from(int L, int R);
    void mirror_ghost(int L, int R);

    // chop_out.hpp: what is taken out
    template <bool with_moments = false>
    void bring(Front& f, double t) const;
    void chop_out(int id, double t);
    void use_up(int c, double t);
    void share_rest(Front& f1, Front& f2, const Contents& q) const;
    void untag(Front& f) const;
    bool unite(int c, double t);
    void chop_both(int c, double t);
    Contents passed_end(const Front& f, double t) const;
    Contents owed_by_wall(const Front& f) const;

    // flatten.hpp: what it becomes
    State flat(const Front& f) const;
    Flattened flattened(const Front& f) const;
    void add_flattened(Row& row, const Front& f);
    void add_flattened_special(Row& row, const Front& f);

    // put_back.hpp: new cells, and the fronts between them
    void put_back(int L, int R, Row& row, double t, bool wraps);
    bool prescribes(int c, std::size_t side) const {
        return is_ghost(c, side) && ends_[side].kind == LineEnd::Kind::prescribed;
    }
    void fill_up(Row& row, std::size_t side, int ghost);
    void clip(Row& row, std::size_t side, int ghost, int inner, double t);
    bool keeps_waves(int L, int R, double x, double t, bool wraps, bool& tagged);
    void meet(int L, int R, double x, double t, bool tagged, bool wraps);
    double room(int c, double x, double t, bool on_left) const;

    // waves.hpp: waves of no width in place of a front
    bool worth_keeping(const Cell& l, const Cell& r, double space) const;
    Strength resolved(const State& from, Strength wave, Toward toward, double length) const;
    std::optional<Meeting> resolved_meeting(const State& l, const State& r, double length) const;
    int keep(int L, int R, double x, double t, double speed);
    bool send_waves(int L, int R, double x, double t, bool wraps, double length);
    std::optional<double> waves_at_end(std::size_t side, const State& in, const State& out, double length);
    bool send_from_end(std::size_t side, int L, int R, double x, double t, double length);

    // show.hpp: as it is shown
    std::vector<Stretch> stretches(double t) const;
    int spreading(const Front& f) const;
    int first_cell() const;

    M medium_;
    Options options_;
    Watched per_allowed_, allowed_square_;  ///< 1 / allowed and its square
    std::array<LineEnd, 2> ends_;
    std::array<double, 2> bounds_;  ///< of the line at t = 0 [m]
    double length_;                 ///< between them [m]
    std::array<int, 2> ghosts_{-1, -1};
    std::array<int, 2> outer_{-1, -1};  ///< the first and the last cell, ghosts too
    std::vector<Cell> cells_;
    std::vector<Front> fronts_;
    int unused_cell_ = -1;   ///< the first of a chain
    int unused_front_ = -1;  ///< the same
    std::vector<Jump> row_left_, row_right_;
    Schedule schedule_;
    Counts counts_;
    long events_ = 0;
    Contents received_;
};

}  // namespace ordo::solvers::rrm
