#pragma once
// Wave curves: which states one gas can reach through a single shock or fan.

namespace ordo::oracles {

/// A uniform stiffened gas, p = (gamma - 1) rho e - gamma p_inf; p_inf = 0 is the ideal gas.
struct Gas {
    double rho = 1;      ///< density [kg/m^3]; 0 is a vacuum, whose other numbers but p mean nothing
    double v = 0;        ///< velocity [m/s]
    double p = 1;        ///< pressure, p + p_inf >= 0 [Pa]
    double gamma = 1.4;  ///< ratio of the specific heats, > 1 [-]
    double p_inf = 0;    ///< stiffness [Pa]

    bool operator==(const Gas&) const = default;
};

/// The gas ahead of a wave. With P = p + p_inf and a^2 = gamma P / rho, f is what the gas behind has lost in velocity:
///
///   shock, d = p* - p >= 0      f = d / sqrt(rho (gamma P + (gamma + 1) d / 2))
///                               rho* / rho = 1 + d / (gamma P + (gamma - 1) d / 2)
///   fan, s = ln(P* / P) <= 0    f = n a (c - 1),   c = a* / a = exp(m s),   rho* / rho = exp(s / gamma)
///                               n = 2 / (gamma - 1),   m = (gamma - 1) / (2 gamma)
///
/// v* = v - f on the left, v + f on the right. Differences are never formed from nearly equal numbers, so that weak
/// waves are as exact as strong ones; a cold gas (P = 0) has shocks only.
struct GasSide {
    Gas gas;
    double P;          ///< p + p_inf [Pa]
    double a;          ///< speed of sound [m/s]
    double n;          ///< 2 / (gamma - 1)
    double m;          ///< (gamma - 1) / (2 gamma)
    double root_rho;   ///< sqrt(rho)
    double fan_slope;  ///< a / gamma, of f by s at s = 0

    explicit GasSide(const Gas& ahead);

    bool empty() const { return gas.rho == 0; }

    /// f with its derivative by p* (shock) or by s (fan).
    struct Wave {
        double f;
        double slope;
    };
    Wave shock(double d) const;
    Wave fan(double s) const;

    /// The wave to p* = p + d, derivative by p*. P_star = P + d is given apart because there d may cancel P.
    Wave wave(double d, double P_star) const;
    double curvature(double d) const;                 ///< second derivative of f by p*, for d >= 0 (d = 0: fans too)
    double log_ratio(double d, double P_star) const;  ///< s = ln(P* / P)
    double shock_speed(double d) const;               ///< relative to the gas ahead, positive [m/s]

    /// The state behind a wave.
    struct Behind {
        double rho = 0;
        double P = 0;
        double a = 0;
        double c = 1;  ///< a* / a, of a fan
        double f = 0;
        double d = 0;  ///< p* - p: positive behind a shock, negative behind a fan, 0 where there is no wave
    };
    Behind behind_shock(double d) const;
    Behind behind_fan(double s) const;

private:
    struct Cooling {
        double c;       // a* / a
        double change;  // c - 1
    };
    Cooling cooling(double s) const;
};

}  // namespace ordo::oracles
