#pragma once
// gnuplot as a program: what every script opens with, how texts stand in it, and how it becomes a picture.
#include <array>
#include <string>
#include <vector>

namespace ordo::reports {

enum class PlotFormat { svg, pdf, png };

/// ".svg", ".pdf" or ".png"
std::string ending_of(PlotFormat format);

/// Okabe and Ito's colours without the yellow.
inline constexpr std::array colours{"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000"};

/// The format that a picture's name ends in. Throws InputError on another ending.
PlotFormat format_by_ending(const std::string& picture);

/// `text` as a gnuplot string: single quotes, doubled inside, line ends and other control characters as spaces.
std::string quoted(const std::string& text);

/// The head of a script: terminal of 900 px (9 in) width and the given height, and its output: the file `picture` in
/// its folder, or the file that a variable `output` names.
std::string opening(PlotFormat format, int height, const std::string& picture);

/// Rows of numbers as the data block $name.
std::string data_block(const std::string& name, const std::string& rows);

/// Has gnuplot draw a script into `picture`, which appears whole or not at all. Throws EnvironmentError when gnuplot is
/// missing or fails.
void draw_picture(const std::string& script, const std::string& picture);

/// Writes the script `text` beside `picture`, with the ending .gp, and has it drawn; returns both paths. Throws
/// InputError on an unwritable path, EnvironmentError as draw_picture does; the script is then there all the same.
std::vector<std::string> draw_with_script(const std::string& text, const std::string& picture);

}  // namespace ordo::reports
