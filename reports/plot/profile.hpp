#pragma once
// Fields along a line as one picture, a panel a field.
#include <string>
#include <vector>

#include "reports/plot/gnuplot.hpp"

namespace ordo::reports {

/// One field: its name, unit and components, each with as many values as the profile has places. NaN breaks a line.
struct Panel {
    std::string field;
    std::string unit;
    std::vector<std::string> components;
    std::vector<std::vector<double>> values;
};

struct Profile {
    std::string title;
    std::string subtitle;
    std::string abscissa;        ///< "x [m]"
    std::vector<double> places;  ///< in drawing order
    std::vector<Panel> panels;
};

/// The picture as a gnuplot script that holds its own data.
std::string script_of(const Profile& profile, PlotFormat format, const std::string& picture);

/// Writes `picture` (its ending says the format: .svg, .pdf or .png) and its script .gp beside it; returns both paths.
/// Throws InputError on another ending, an unwritable path or a single place, EnvironmentError when gnuplot is missing
/// or fails; the script is then there all the same.
std::vector<std::string> draw(const Profile& profile, const std::string& picture);

}  // namespace ordo::reports
