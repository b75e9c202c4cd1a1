#pragma once
// The one way in which a user is told that an input is wrong.
#include <stdexcept>
#include <string>

namespace ordo {

/// A bad input: what was wrong, where it stands, which rule it breaks and the nearest valid choice, on one line.
/// Thrown at the door only; the command answers with exit code 2, nothing run and nothing written.
class InputError : public std::runtime_error {
public:
    /// where    file, JSON pointer or option, for instance "bar.json: /scene/E"; may be empty
    /// problem  the sentence, rule and nearest choice included
    InputError(const std::string& where, const std::string& problem)
        : std::runtime_error(where.empty() ? problem : where + ": " + problem) {}
};

/// The surroundings failed us (disk full, a program missing): exit code 4.
class EnvironmentError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace ordo
