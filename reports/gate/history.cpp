#include "reports/gate/history.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "reports/gate/question.hpp"
#include "reports/gate/steps.hpp"
#include "reports/gate/tolerance.hpp"

namespace ordo::reports {
namespace {

/// Reports of one revision.
struct Revision {
    std::string name;
    std::vector<const Entry*> entries;
};

/// Reports of one study that ask the same.
struct Line {
    std::string study;
    std::string question;
    std::vector<Revision> revisions;
};

/// Entries must be sorted by time, so that a revision stands where its first report does.
std::vector<Line> lines_of(const std::vector<Entry>& entries) {
    std::vector<Line> lines;
    for (const auto& entry : entries) {
        auto line = std::ranges::find_if(
            lines, [&](const Line& known) { return known.study == entry.study && known.question == entry.question; });
        if (line == lines.end()) line = lines.insert(lines.end(), {entry.study, entry.question, {}});
        auto& revisions = line->revisions;
        auto revision = std::ranges::find(revisions, entry.revision, &Revision::name);
        if (revision == revisions.end()) revision = revisions.insert(revisions.end(), {entry.revision, {}});
        revision->entries.push_back(&entry);
    }
    return lines;
}

/// Values of each figure at each revision, in the order in which figures first appear; a report without it has a NaN.
std::vector<std::pair<Figure, std::vector<std::vector<double>>>> series_of(const Line& line) {
    std::vector<std::pair<Figure, std::vector<std::vector<double>>>> series;
    std::map<std::string, std::size_t> places;
    for (std::size_t i = 0; i < line.revisions.size(); ++i) {
        for (const Entry* entry : line.revisions[i].entries) {
            for (const auto& figure : entry->figures) {
                const auto [found, fresh] = places.try_emplace(figure.name(), series.size());
                if (fresh) series.emplace_back(figure, std::vector<std::vector<double>>(line.revisions.size()));
                series[found->second].second[i].push_back(figure.value);
            }
        }
    }
    for (auto& [figure, values] : series) {
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i].resize(line.revisions[i].entries.size(), std::nan(""));
    }
    return series;
}

/// What a change must at least be to count: any of a count; some units in the last place of the largest value else.
double least_change(Figure figure, const std::vector<std::vector<double>>& places) {
    if (figure.kind == FigureKind::work) return 0.5;
    figure.value = 0;
    for (const auto& values : places) {
        for (const double value : values) {
            if (std::isfinite(value)) figure.value = std::max(figure.value, std::abs(value));
        }
    }
    return least_tolerance(figure);
}

void add_steps(const Line& line, History& history) {
    bool few = false;
    for (const auto& [figure, places] : series_of(line)) {
        ++history.figures;
        const Steps found = steps_in(places, least_change(figure, places));
        few = few || (found.few_places && !found.steps.empty());
        for (const auto& [at, before, now] : found.steps) {
            history.steps.push_back(
                {line.study, figure.name(), line.revisions[at - 1].name, line.revisions[at].name, before, now});
        }
    }
    if (line.revisions.size() == 1)
        history.notes.push_back(fmt::format("{}: one revision ({} reports): no step can be told", line.study,
                                            line.revisions.front().entries.size()));
    else if (few)
        history.notes.push_back(
            fmt::format("{}: {} revisions are too few to tell noise between them: its steps hold for figures that are "
                        "the same bits on every repetition",
                        line.study, line.revisions.size()));
}

/// A study that asks something else from some revision on.
void add_new_question(const std::vector<Line>& lines, std::size_t i, History& history) {
    for (std::size_t k = i; k-- > 0;) {
        if (lines[k].study != lines[i].study) continue;
        history.notes.push_back(fmt::format("{}: asks another question at {}: {}; its figures begin anew there",
                                            lines[i].study, lines[i].revisions.front().name,
                                            text_of(differences(lines[k].question, lines[i].question))));
        return;
    }
}

}  // namespace

Entry entry_of(const Report& report) {
    return {report.result.study.name, question_of(report.result.study), report.provenance.revision,
            report.provenance.time_utc, figures_of(report.result)};
}

History history_of(const std::vector<Entry>& entries) {
    auto sorted = entries;
    std::ranges::stable_sort(sorted, {}, &Entry::time_utc);
    std::set<std::string> studies, revisions;
    History history;
    history.reports = entries.size();
    for (const auto& entry : sorted) {
        studies.insert(entry.study);
        revisions.insert(entry.revision);
    }
    history.studies = studies.size();
    history.revisions = revisions.size();
    if (revisions.contains("unknown"))
        history.notes.emplace_back(
            "reports whose revision is 'unknown' are taken for one revision: build in a checkout");
    const auto lines = lines_of(sorted);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        add_new_question(lines, i, history);
        add_steps(lines[i], history);
    }
    return history;
}

}  // namespace ordo::reports
