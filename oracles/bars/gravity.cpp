#include "oracles/bars/gravity.hpp"

namespace ordo::oracles::bars {

double Ramp::value(double t) const {
    const double s = T > 0 ? std::clamp(t / T, 0.0, 1.0) : (t > 0 ? 1.0 : 0.0);
    return s * s * s * (10 + s * (6 * s - 15));
}

double Ramp::rate(double t) const {
    if (t <= 0 || t >= T) return 0;
    const double s = t / T;
    return 30 * s * s * (1 - s) * (1 - s) / T;
}

double Fall::front(double t) const {
    const Transit way(t, c, H);
    return way.outward() ? H * way.part : H * (1 - way.part);
}

/// u = -(g / 2c^2) f(y, r) of the path r = c t, folded into [0, 2H]: y (2r - y) below the front on its first way up,
/// r^2 above, and y (2r - y) - (r + y - 2H)^2 above it on its way down.
Fields Fall::at(double y, double t) const {
    const Transit way(t, c, H);
    const bool forth = way.phase < 2;  // back in the second half of the period
    const double q = H * (forth ? way.part : 1 - way.part);
    const double scale = -g / (2 * c * c);
    double f, f_r, f_y;
    if (way.phase == 0 || way.phase == 3) {
        const bool falling = y >= q;
        f = falling ? q * q : y * (2 * q - y);
        f_r = falling ? 2 * q : 2 * y;
        f_y = falling ? 0 : 2 * (q - y);
    } else {
        const double above = std::max(0.0, y - H + q);
        f = y * (2 * (H + q) - y) - above * above;
        f_r = 2 * (y - above);
        f_y = above > 0 ? 4 * (H - y) : 2 * (q + (H - y));
    }
    return {scale * f, scale * (forth ? c : -c) * f_r, scale * f_y};
}

Fields Gravity::ramped(double y) const {
    const auto& [H, c, g] = fall_;
    Fields sum;
    double high = std::min(t_, ramp_.T);  // increments of gravity not yet summed: those of the times s < high
    for (double visit = 2 * std::floor(c * (t_ - high) / (2 * H)); high > 0; ++visit) {
        const bool upward = visit == 2 * std::floor(visit / 2);
        const double age = (upward ? visit * H + y : (visit + 1) * H - y) / c;  // of the front that passes y now
        const double low = std::max(0.0, t_ - age);
        if (low >= high) continue;
        const auto share = [&](double s) { return ramp_.rate(s) * fall_.at(y, t_ - s); };
        sum = sum + (high - low) * polynomial_mean(low, high, share);
        high = low;
    }
    return sum;
}

Fields Gravity::mean(double a, double b) const {
    const auto smooth = [&](double low, double high) {
        return polynomial_mean(low, high, [&](double y) { return at(y); });
    };
    const double first = fall_.front(t_);
    if (t_ <= ramp_.T || ramp_.T == 0) return mean_in_parts(a, b, first, smooth);
    const double second = fall_.front(t_ - ramp_.T);
    return mean_in_parts(a, b, std::min(first, second), [&](double low, double high) {
        return mean_in_parts(low, high, std::max(first, second), smooth);
    });
}

}  // namespace ordo::oracles::bars
