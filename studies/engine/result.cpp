#include "studies/engine/result.hpp"

#include <cmath>
#include <limits>

namespace ordo::studies {
namespace {

double figure(const std::vector<RunFigure>& figures, const std::string& name) {
    for (const auto& figure : figures) {
        if (figure.name == name) return figure.value;
    }
    return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

std::string text_of(Status status) {
    switch (status) {
        case Status::ok: return "ok";
        case Status::reference: return "reference";
        case Status::diverged: return "diverged";
        case Status::failed: return "failed";
        case Status::timed_out: return "timed_out";
        case Status::skipped: break;
    }
    return "skipped";
}

std::string text_of(Verdict verdict) {
    return verdict == Verdict::pass ? "pass" : verdict == Verdict::fail ? "fail" : "inconclusive";
}

double Run::axis(const std::string& name) const {
    if (name == "h") return h;
    if (name == "dt") return dt;
    return figure(axes, name);
}

double Run::at(const std::string& name) const {
    const std::string counter = counter_of(name);
    if (!counter.empty()) return 1 / at(counter);
    const double known = axis(name);
    return std::isnan(known) ? figure(work, name) : known;
}

double Run::error(const std::string& key) const { return figure(errors, key); }

}  // namespace ordo::studies
