#include "studies/engine/crew.hpp"

#include <algorithm>
#include <map>

#include "studies/engine/decided.hpp"
#include "studies/engine/description.hpp"
#include "studies/engine/judge.hpp"
#include "studies/engine/measure.hpp"

namespace ordo::studies {
namespace {

bool needs_reference(const Quantity& quantity) { return quantity.against == Against::finest; }

/// The figures of `made` as those of another run that does the same.
Run as_that_of(const RunSpec& spec, Run made, Origin origin) {
    Run run = planned_run(spec);
    run.status = made.status;
    run.reason = std::move(made.reason);
    run.errors = std::move(made.errors);
    run.drift = std::move(made.drift);
    run.work = std::move(made.work);
    run.skipped = std::move(made.skipped);
    run.seconds = made.seconds;
    run.repeats = made.repeats;
    run.origin = origin;
    return run;
}

/// What a run is kept as: whether it came to its end by itself, well or not.
bool lasts(const Run& run) {
    return run.status == Status::ok || run.status == Status::reference || run.status == Status::diverged;
}

/// Of a study whose runs have nothing to do with each other one line a run; else those of the sweep's path.
std::vector<Series> series_from(const Study& study, const std::vector<Run>& runs, bool together) {
    if (together) return lines_of(study, runs);
    std::vector<Series> alone;
    for (const auto& run : runs) alone.push_back({"", "", "", {run.id}});
    return alone;
}

std::vector<Line> lines_from(const Study& study, const std::vector<RunSpec>& specs, const std::vector<Run>& runs,
                             bool compares) {
    std::vector<Line> lines;
    std::map<std::vector<std::string>, std::size_t> known;
    for (auto& series : series_from(study, runs, compares || study.stops_when_decided)) {
        Line line{.series = std::move(series)};
        for (const int id : line.series.runs) line.runs.push_back(static_cast<std::size_t>(id));
        for (const auto i : line.runs) {
            line.descriptions.push_back(compares ? description_of(specs[i], specs[line.runs.back()])
                                                 : description_of(specs[i]));
        }
        const auto [place, is_new] = known.emplace(line.descriptions, lines.size());
        if (!is_new) line.twin = place->second;
        lines.push_back(std::move(line));
    }
    return lines;
}

}  // namespace

Crew::Crew(const Study& study, std::size_t place, const EngineOptions& options, std::function<bool()> stop)
    : study_(study),
      options_(options),
      stop_(std::move(stop)),
      specs_(specs_of(study)),
      shots_(specs_.size()),
      found_(specs_.size()) {
    const auto& quantities = study.measure.quantities;
    compares_ = std::any_of(quantities.begin(), quantities.end(), needs_reference);
    for (const auto& spec : specs_) {
        runs_.push_back(planned_run(spec));
        planned_ += spec.cost;
    }
    lines_ = lines_from(study, specs_, runs_, compares_);
    if (options.timing) timer_.emplace(*options.timing);
    now_.study = place;
    now_.total = static_cast<int>(specs_.size());
}

std::vector<std::string> Crew::descriptions() const {
    std::vector<std::string> all;
    for (const auto& line : lines_) all.insert(all.end(), line.descriptions.begin(), line.descriptions.end());
    return all;
}

double Crew::seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
}

void Crew::begins() {
    const std::lock_guard lock(mutex_);
    ++now_.running;
}

void Crew::ends(std::size_t i) {
    const std::lock_guard lock(mutex_);
    --now_.running;
    ++now_.done;
    done_ += specs_[i].cost;
    now_.work_done = planned_ > 0 ? done_ / planned_ : 1;
    now_.seconds = seconds();
    now_.last = &runs_[i];
    if (options_.progress) options_.progress(now_);
}

/// Of runs that are compared with each other all or none, since a snapshot is not kept.
void Crew::find_finished(Line& line) {
    line.left = line.runs.size();
    if (options_.finished == nullptr || line.twin) return;
    std::vector<std::optional<Run>> found;
    for (const auto& description : line.descriptions) found.push_back(options_.finished->find(description));
    const auto there = [](const std::optional<Run>& run) { return run.has_value(); };
    if (compares_ && !std::ranges::all_of(found, there)) return;
    for (std::size_t k = 0; k < found.size(); ++k) {
        if (!found[k]) continue;
        const std::size_t i = line.runs[k];
        const Origin origin = found[k]->origin;
        runs_[i] = as_that_of(specs_[i], std::move(*found[k]), origin);
        found_[i] = true;
        --line.left;
        if (study_.stops_when_decided) continue;  // it may be skipped
        begins();
        ends(i);
    }
}

void Crew::make(Line& line, std::size_t place) {
    const std::size_t i = line.runs[place];
    begins();
    RunOutcome outcome = timer_ ? (*timer_)(specs_[i], stop_) : executed(specs_[i], stop_);
    runs_[i] = std::move(outcome.run);
    if (compares_) shots_[i] = std::move(outcome.snapshot);
    else keep(line, place);
    ends(i);
    if (!compares_) return;
    const std::lock_guard lock(mutex_);
    if (--line.left == 0) compare_with_finest(line);
}

/// Coarse to fine, until the coarser levels have decided.
void Crew::go_down(Line& line) {
    std::string why;
    for (std::size_t k = 0; k < line.runs.size() && !stop_(); ++k) {
        const std::size_t i = line.runs[k];
        if (why.empty()) why = why_decided(study_, runs_, line.series, k);
        if (why.empty() && !found_[i]) {
            make(line, k);
            continue;
        }
        begins();
        if (!why.empty()) {
            runs_[i] = planned_run(specs_[i]);
            runs_[i].status = Status::skipped;
            runs_[i].reason = why;
        }
        ends(i);
    }
}

/// Every run of the line with the one of smallest dt; then no snapshot of it is needed any more.
void Crew::compare_with_finest(const Line& line) {
    const auto finest = line.runs.back();
    const auto& reference = shots_[finest];
    for (const auto i : line.runs) {
        if (i == finest || !shots_[i] || !reference) continue;
        for (const auto& quantity : study_.measure.quantities) {
            if (needs_reference(quantity))
                runs_[i].errors.push_back({quantity.key(), error_against(quantity, *shots_[i], *reference)});
        }
    }
    if (runs_[finest].status == Status::ok) runs_[finest].status = Status::reference;
    for (const auto i : line.runs) shots_[i].reset();
    const auto lasting = [&](std::size_t i) { return lasts(runs_[i]); };
    if (!std::ranges::all_of(line.runs, lasting)) return;
    for (std::size_t k = 0; k < line.runs.size(); ++k) keep(line, k);
}

void Crew::keep(const Line& line, std::size_t place) {
    const Run& run = runs_[line.runs[place]];
    if (options_.finished != nullptr && lasts(run)) options_.finished->keep(line.descriptions[place], run);
}

void Crew::copy_from_twin(const Line& line) {
    for (std::size_t k = 0; k < line.runs.size(); ++k) {
        const std::size_t i = line.runs[k];
        const Run& made = runs_[lines_[*line.twin].runs[k]];
        begins();
        const bool is_shared = made.origin == Origin::made && made.status != Status::skipped;
        runs_[i] = as_that_of(specs_[i], made, is_shared ? Origin::shared : made.origin);
        ends(i);
    }
}

/// The most expensive first, so that threads end together; to be timed, the cheapest first.
std::vector<Task> Crew::begin() {
    begin_ = std::chrono::steady_clock::now();
    for (auto& line : lines_) find_finished(line);
    std::vector<Task> tasks;
    for (auto& line : lines_) {
        if (line.twin) continue;
        double whole = 0;
        for (std::size_t k = 0; k < line.runs.size(); ++k) {
            const double cost = specs_[line.runs[k]].cost;
            whole += cost;
            if (!study_.stops_when_decided && !found_[line.runs[k]])
                tasks.push_back({cost, {line.descriptions[k]}, [this, &line, k] { make(line, k); }});
        }
        if (study_.stops_when_decided) tasks.push_back({whole, line.descriptions, [this, &line] { go_down(line); }});
    }
    if (timer_) std::ranges::stable_sort(tasks, std::less{}, &Task::cost);
    else std::ranges::stable_sort(tasks, std::greater{}, &Task::cost);
    return tasks;
}

Engine::Outcome Crew::end() {
    for (const auto& line : lines_) {
        if (line.twin) copy_from_twin(line);
    }
    return {std::move(runs_), seconds()};
}

}  // namespace ordo::studies
