#include "reports/plot/layout.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "studies/engine/judge.hpp"

namespace ordo::reports {
namespace {

using namespace ordo::studies;

Point logarithm(const Point& point) { return {std::log10(point.x), std::log10(point.y)}; }

Point power_of_ten(const Point& point) { return {std::pow(10, point.x), std::pow(10, point.y)}; }

Interval power_of_ten(const Interval& range) { return {std::pow(10, range.low), std::pow(10, range.high)}; }

constexpr Interval nothing{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

std::string counted(std::ptrdiff_t n, const std::string& one, const std::string& many, const std::string& rest) {
    return n == 0 ? "" : "; " + std::to_string(n) + " " + (n == 1 ? one : many) + " " + rest;
}

/// The orders found, then what is missing, then why an order is: "ppc = 4: 1.992 [1.98, 2.00]; 1 run diverged".
std::string legend_of(const Result& result, const Series& series, const std::vector<const SeriesFit*>& fits,
                      const std::string& key) {
    std::string orders, refusals;
    for (const SeriesFit* fit : fits) {
        const std::string where = fits.size() > 1 && !fit->where.empty() ? " where " + fit->where : "";
        if (fit->outcome.fit) orders += "; " + order_words(*fit->outcome.fit) + where;
        else refusals += "; no order (" + fit->outcome.reason + ")" + where;
    }
    const std::string text = orders + missing_words(result, series, key) + refusals;
    return clipped(series.label, 50) + (text.empty() ? "" : ":" + text.substr(1));
}

/// The fitted line over the runs that the fit used and no further; a power law is straight, so two points are enough.
std::vector<Point> line_of(const Result& result, const View& view, const SeriesFit& fit) {
    const auto& found = *fit.outcome.fit;
    const auto abscissa = [&](int id) { return run_of(result, id).at(view.abscissa); };
    const auto [fine, coarse] = std::ranges::minmax(fit.used, {}, abscissa);
    const int pieces = found.model == studies::ErrorModel::power ? 1 : 48;
    std::vector<Point> line;
    for (int k = 0; k <= pieces; ++k) {
        const double x = abscissa(coarse) * std::pow(abscissa(fine) / abscissa(coarse), double(k) / pieces);
        line.push_back({x, found.error_at(x)});
    }
    return line;
}

Curve curve_of(const Result& result, const View& view, const Series& series) {
    const auto fits = fits_along(result, view, series);
    const std::string key = view.quantity.key();
    Curve curve{legend_of(result, series, fits, key), {}, {}};
    for (const int id : series.runs) {
        const Run& run = run_of(result, id);
        const Point at{run.at(view.abscissa), run.error(key)};
        const auto uses = [&](const SeriesFit* fit) { return std::ranges::find(fit->used, id) != fit->used.end(); };
        curve.points.push_back({at, !stopped(run) && drawable(at), fits.empty() || std::ranges::any_of(fits, uses)});
    }
    for (const SeriesFit* fit : fits) {
        if (!fit->outcome.fit) continue;
        auto line = line_of(result, view, *fit);
        if (std::ranges::all_of(line, [](const Point& point) { return drawable(point); }))
            curve.fits.push_back(std::move(line));
    }
    return curve;
}

/// Everything that a slope triangle must stay clear of, in decimal logarithms.
std::vector<Segment> segments_of(const std::vector<Curve>& curves) {
    std::vector<Segment> segments;
    for (const auto& curve : curves) {
        for (const auto& fit : curve.fits) {
            for (std::size_t k = 1; k < fit.size(); ++k) segments.push_back({logarithm(fit[k - 1]), logarithm(fit[k])});
        }
        const CurvePoint* before = nullptr;
        for (const auto& point : curve.points) {
            const bool connected = before != nullptr && before->drawn;
            if (point.drawn) segments.push_back({logarithm(connected ? before->at : point.at), logarithm(point.at)});
            before = &point;
        }
    }
    return segments;
}

Interval at_least_wide(const Interval& range, double width) {
    return range.widened(std::max(0.0, 0.5 * (width - range.span())));
}

/// The box around the segments, wide enough for ticks: half a decade by two thirds. Any box where there are none.
Box box_of(const std::vector<Segment>& segments) {
    if (segments.empty()) return {{-1, 0}, {-1, 0}};
    Box box{nothing, nothing};
    for (const auto& [a, b] : segments) {
        for (const Point& point : {a, b}) {
            box.x.include(point.x);
            box.y.include(point.y);
        }
    }
    return {at_least_wide(box.x, 0.5), at_least_wide(box.y, 0.67)};
}

/// The series that the expectation holds to an order.
std::vector<const Series*> subjects_of(const Result& result, const View& view, const Expectation& expectation) {
    std::vector<const Series*> subjects;
    for (const Series* series : view.series) {
        const auto speaks = [&](int id) {
            return speaks_of(expectation, view.quantity.key(), run_of(result, id).solver);
        };
        const bool about_order = expectation.kind == Expectation::Kind::order && expectation.value != 0 &&
                                 speaks_along(expectation, view.abscissa);
        if (about_order && std::ranges::any_of(series->runs, speaks)) subjects.push_back(series);
    }
    return subjects;
}

/// Middle of the runs that the fits of this range used, in decimal logarithms.
double centre_of(const Result& result, const View& view, const std::vector<const Series*>& subjects,
                 const std::string& where, const Box& box) {
    Interval x = nothing;
    for (const Series* series : subjects) {
        for (const SeriesFit* fit : fits_along(result, view, *series)) {
            if (fit->where != where || !fit->outcome.fit) continue;
            for (const int id : fit->used) x.include(std::log10(run_of(result, id).at(view.abscissa)));
        }
    }
    const Interval& middle = x.low <= x.high ? x : box.x;
    return 0.5 * (middle.low + middle.high);
}

/// One triangle for each expected order; a later one stays clear of the earlier ones. Widens the box where it must.
std::vector<Triangle> triangles_of(const Result& result, const View& view, std::vector<Segment> segments, Box& box) {
    std::vector<Triangle> triangles;
    for (const auto& expectation : result.study.expect) {
        const auto subjects = subjects_of(result, view, expectation);
        const bool stands = std::ranges::find(triangles, expectation.value, &Triangle::order) != triangles.end();
        if (subjects.empty() || stands) continue;
        const double centre = centre_of(result, view, subjects, text_of(expectation.where), box);
        auto triangle = placed_triangle(expectation.value, centre, segments, box);
        const auto [left, right, angle] = triangle.corners;
        segments.insert(segments.end(), {{left, right}, {right, angle}, {angle, left}});
        for (auto& corner : triangle.corners) {
            box.y.include(corner.y);
            corner = power_of_ten(corner);
        }
        triangles.push_back(triangle);
    }
    return triangles;
}

void set_ranges(Layout& layout, const Box& box) {
    layout.x = power_of_ten(box.x.widened(0.06 * box.x.span()));
    layout.y = power_of_ten(box.y.widened(0.06 * box.y.span()));
}

}  // namespace

bool drawable(double value) { return std::isfinite(value) && value > 0; }

bool drawable(const Point& point) { return drawable(point.x) && drawable(point.y); }

std::string missing_words(const Result& result, const Series& series, const std::string& key) {
    const auto with = [&](Status status) {
        return std::ranges::count_if(series.runs, [&](int id) { return run_of(result, id).status == status; });
    };
    const auto off_the_axes = std::ranges::count_if(series.runs, [&](int id) {
        return run_of(result, id).status == Status::ok && !drawable(run_of(result, id).error(key));
    });
    return counted(with(Status::diverged), "run", "runs", "diverged") +
           counted(with(Status::failed), "run", "runs", "failed") +
           counted(with(Status::timed_out), "run", "runs", "timed out") +
           counted(with(Status::skipped), "level", "levels", "skipped") +
           counted(off_the_axes, "error", "errors", "zero or not finite");
}

Layout layout_of(const Result& result, const View& view) {
    Layout layout;
    for (const Series* series : view.series) layout.curves.push_back(curve_of(result, view, *series));
    const auto segments = segments_of(layout.curves);
    layout.empty = segments.empty();
    Box box = box_of(segments);
    if (!layout.empty) layout.triangles = triangles_of(result, view, segments, box);
    set_ranges(layout, box);
    return layout;
}

Layout layout_of(std::vector<Curve> curves) {
    Layout layout;
    layout.curves = std::move(curves);
    layout.solid = true;
    const auto segments = segments_of(layout.curves);
    layout.empty = segments.empty();
    set_ranges(layout, box_of(segments));
    return layout;
}

}  // namespace ordo::reports
