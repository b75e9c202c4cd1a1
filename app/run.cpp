// ordo run: from study files to reports.
#include "studies/engine/run.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <iostream>
#include <set>
#include <thread>
#include <utility>

#include "app/command.hpp"
#include "app/terminal.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "reports/cache/build.hpp"
#include "reports/cache/run_cache.hpp"
#include "reports/reference_kernel.hpp"
#include "reports/report.hpp"
#include "reports/table/table.hpp"
#include "studies/amplification/warning.hpp"
#include "studies/engine/engine.hpp"
#include "studies/engine/judge.hpp"
#include "studies/reader/study_reader.hpp"

namespace ordo::app {
namespace {

std::atomic<bool> stop_asked{false};
static_assert(std::atomic<bool>::is_always_lock_free);

void ask_to_stop(int) { stop_asked = true; }

constexpr std::size_t most_kept = 20'000;  // runs in the cache, about 80 MB of disk

/// -o names the report of one study, or with a '/' at its end the folder for all of them.
std::string output_of(const std::string& out, const studies::Study& study, std::size_t studies) {
    if (out.empty()) return "ordo-reports/" + reports::safe_path(study.name) + ".json";
    if (out.back() == '/') return out + reports::safe_path(study.name) + ".json";
    if (studies > 1) throw InputError("ordo run -o " + out, "several studies need a folder (nearest: '" + out + "/')");
    return out;
}

struct Job {
    studies::Study study;
    std::string output;
};

/// Everything that can be wrong is found here, before the first run.
std::vector<Job> jobs_from(const po::variables_map& options, const std::vector<std::string>& files) {
    if (files.empty()) throw InputError("ordo run", "names no study; usage: ordo run STUDY...");
    std::vector<studies::Setting> settings;
    if (options.contains("set")) {
        for (const auto& text : options["set"].as<std::vector<std::string>>())
            settings.push_back(studies::setting_from(text));
    }
    std::vector<Job> jobs;
    std::set<std::string> outputs;
    for (const auto& file : files) {
        auto study = studies::read_study(file, settings);
        studies::specs_of(study);
        const auto output =
            output_of(options.contains("out") ? options["out"].as<std::string>() : "", study, files.size());
        std::error_code error;
        if (std::filesystem::equivalent(file, output, error))
            throw InputError(output, "the report would overwrite its study");
        if (!outputs.insert(output).second)
            throw InputError(file, "its report would overwrite that of another study: " + output);
        jobs.push_back({std::move(study), output});
    }
    for (const auto& job : jobs) reports::check_writable(job.output);
    return jobs;
}

int code_of(const studies::Result& result) {
    const auto broken = [&](const studies::Run& run) {
        return run.status == studies::Status::failed ||
               (run.status == studies::Status::timed_out && !result.study.time_out_allowed);
    };
    if (std::any_of(result.runs.begin(), result.runs.end(), broken)) return run_broken;
    return result.verdict == studies::Verdict::fail ? gate_failed : all_hold;
}

bool is_made(const studies::Run& run) {
    return run.origin == studies::Origin::made && run.status != studies::Status::skipped;
}

/// "runs: 2 made, 8 from the cache, 1 skipped"; "" where all were made.
std::string origin_line(const std::vector<studies::Run>& runs) {
    const auto made = std::ranges::count_if(runs, is_made);
    if (made == std::ssize(runs)) return "";
    std::string line = "runs: " + std::to_string(made) + " made";
    const auto add = [&](std::ptrdiff_t count, const char* words) {
        if (count > 0) line += ", " + std::to_string(count) + words;
    };
    add(std::ranges::count(runs, studies::Origin::cached, &studies::Run::origin), " from the cache");
    add(std::ranges::count(runs, studies::Origin::shared, &studies::Run::origin), " equal to others");
    add(std::ranges::count(runs, studies::Status::skipped, &studies::Run::status), " skipped");
    return line + '\n';
}

/// What the studies of one call share.
struct Session {
    int threads;
    bool timed;
    bool why_not_cached;
    bool verbose;
    reports::RunCache cache;
    double kernel_seconds = reports::reference_kernel_seconds();  ///< the last time that it was measured
};

/// What the cache has to say, on stderr.
void tell(Session& session) {
    for (const auto& description : session.cache.missed()) {
        if (session.why_not_cached)
            std::cerr << "ordo: not cached: " << one_line(session.cache.why_not(description)) << '\n';
    }
    for (const auto& complaint : session.cache.complaints()) {
        if (session.verbose) std::cerr << "ordo: cache: " << one_line(complaint) << '\n';
    }
}

/// The smaller of before and after the runs; NaN where none was made.
double kernel_beside(const std::vector<studies::Run>& runs, Session& session) {
    if (std::ranges::none_of(runs, is_made)) return std::nan("");
    const double before = std::exchange(session.kernel_seconds, reports::reference_kernel_seconds());
    return std::min(before, session.kernel_seconds);
}

int report_on(const Job& job, studies::Engine::Outcome outcome, Session& session) {
    tell(session);
    const double kernel_seconds = kernel_beside(outcome.runs, session);
    reports::Report report{studies::judged(job.study, std::move(outcome.runs)),
                           reports::provenance_here(session.threads, outcome.seconds)};
    report.provenance.kernel_seconds = kernel_seconds;
    reports::write_whole(job.output, reports::to_json(report));
    std::cout << reports::table(report, reports::TableFormat::text) << origin_line(report.result.runs)
              << "report: " << job.output << "\n"
              << std::flush;
    return code_of(report.result);
}

int run_jobs(const std::vector<Job>& jobs, Session& session) {
    std::vector<const studies::Study*> all;
    std::vector<std::string> names;
    for (const auto& job : jobs) {
        all.push_back(&job.study);
        names.push_back(job.study.name);
    }
    ProgressLines lines(names);
    studies::EngineOptions options{.jobs = session.threads,
                                   .progress = [&](const auto& now) { lines.show(now); },
                                   .interrupted = &stop_asked,
                                   .finished = session.timed ? nullptr : &session.cache};
    if (session.timed) options.timing.emplace();
    studies::Engine engine(std::move(all), options);
    int code = all_hold;
    for (const auto& job : jobs) {
        auto outcome = engine.next();
        lines.wipe();
        code = std::max(code, report_on(job, std::move(outcome), session));
        lines.next();
    }
    return code;
}

int run(const po::variables_map& options, const std::vector<std::string>& files) {
    const bool timed = options["time"].as<bool>();
    const int threads = timed ? 1 : options["jobs"].as<int>();
    if (threads < 1 || threads > 1024)
        throw InputError("ordo run --jobs", "is " + std::to_string(threads) + ", but must be in [1, 1024]");
    if (timed && !options["jobs"].defaulted() && options["jobs"].as<int>() != 1)
        throw InputError("ordo run --time", "times runs one at a time (nearest: --jobs 1)");
    const auto jobs = jobs_from(options, files);
    Session session{
        threads, timed, options["why-not-cached"].as<bool>(), options["verbose"].as<bool>(),
        reports::RunCache(options["no-cache"].as<bool>() ? "" : reports::cache_folder(), reports::build_of_figures())};
    if (session.why_not_cached) session.cache.read_entries();
    for (const auto& job : jobs) {
        for (const auto& line : studies::beyond_limits(job.study))
            std::cerr << "ordo: warning: " << one_line(line) << '\n';
    }
    std::signal(SIGINT, ask_to_stop);
    std::signal(SIGTERM, ask_to_stop);
    const int code = run_jobs(jobs, session);
    session.cache.trim(most_kept);
    return code;
}

}  // namespace

Command run_command() {
    const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    po::options_description options("options");
    // clang-format off
    options.add_options()
        ("out,o", po::value<std::string>()->value_name("REPORT"),
         "where the report goes; a folder if it ends with '/' (default ordo-reports/<study>.json)")
        ("jobs,j", po::value<int>()->value_name("N")->default_value(cores),
         "runs at a time; the results are the same for any number")
        ("time", po::bool_switch(),
         "time each run: alone, after a warm-up, again until the spread of the median is below 2 % (5 to 25 samples), or "
         "1 s is used")
        ("set", po::value<std::vector<std::string>>()->value_name("path=value"),
         "change one member of the study, for instance sweep.cells=4,8,16; may be repeated")
        ("no-cache", po::bool_switch(), "make every run, and keep none")
        ("why-not-cached", po::bool_switch(),
         "say of every run that is made which part of its key differs from the nearest one kept")
        ("verbose,v", po::bool_switch(), "say which files of the cache are ignored, and why");
    // clang-format on
    return {.name = "run",
            .about = "run studies, write their reports, print their tables",
            .usage = "STUDY... [-o REPORT] [--jobs N] [--time] [--set path=value]... [--no-cache]",
            .examples = {"ordo run studies/wobbes_tielen_2015/vibrating_bar.json",
                         "ordo run studies/wobbes_tielen_2015/vibrating_bar_dt.json -o dt.json --set sweep.ppc=6"},
            .options = options,
            .most_arguments = -1,
            .run = run};
}

}  // namespace ordo::app
