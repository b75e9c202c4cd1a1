#pragma once
// Whether two studies ask the same, and where they differ.
#include <string>
#include <vector>

#include "studies/engine/study.hpp"

namespace ordo::reports {

/// One member in which two studies differ: its JSON pointer, and both values as JSON; "absent" where there is none.
struct Difference {
    std::string member;  ///< "/scene/E"
    std::string before;
    std::string now;
};

/// What the study asks, as JSON with sorted members: a study again, without the words `about` it and its top-level
/// `source`, but with every value of scene and solvers, defaults too. So an explicit default is no difference, a
/// default that has changed is one, and a parameter that is new since the question was written down takes its default.
std::string question_of(const studies::Study& study);

/// Members in which `now` differs from `before`, both from `question_of`; empty where they ask the same.
std::vector<Difference> differences(const std::string& before, const std::string& now);

/// "/scene/E was 100, is 50", the first three of them and how many more there are.
std::string text_of(const std::vector<Difference>& differences);

}  // namespace ordo::reports
