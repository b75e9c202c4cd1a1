#pragma once
// Numbers and names as text: round-trip digits, and the nearest valid name for a misspelt one.
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ordo {

/// The shortest decimal that reads back as the same double; "nan", "inf" and "-inf" by name.
std::string shortest(double value);

/// 17 significant digits, the form `ordo oracle` and `ordo solve` print; reads back as the same double.
std::string seventeen_digits(double value);

/// `text` with every control character, line ends too, as a space: safe in a line, a terminal and a script.
std::string one_line(std::string text);

/// "a, b, c".
std::string joined(std::span<const std::string> words, std::string_view separator = ", ");

/// The member of `names` with the smallest edit distance to `word`, or "" when that passes half the word.
std::string nearest_name(std::string_view word, std::span<const std::string> names);

/// " (nearest: 'E')" or, when nothing is near, " (valid: E, L, rho)": the tail of a message about a wrong name.
std::string did_you_mean(std::string_view word, std::span<const std::string> names);

}  // namespace ordo
