#include "reports/cache/run_cache.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <utility>

#include "core/error.hpp"
#include "reports/cache/kept_run.hpp"
#include "reports/files.hpp"
#include "reports/gate/question.hpp"
#include "studies/reader/json_input.hpp"

namespace ordo::reports {
namespace {

namespace fs = std::filesystem;
using studies::Json;

std::string variable(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? "" : value;
}

/// XXH3, 128 bits, as 32 hexadecimal digits. It names files; that an entry is the right one is seen from the entry.
std::string digest(const std::string& text) {
    const XXH128_hash_t hash = XXH3_128bits(text.data(), text.size());
    return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

/// Ours are named by a digest; what a writer that died has left begins like them.
bool is_ours(const fs::path& file) {
    const std::string name = file.filename().string();
    const auto hexadecimal = [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); };
    return name.size() > 32 && std::all_of(name.begin(), name.begin() + 32, hexadecimal) &&
           name.compare(32, 5, ".json") == 0;
}

/// Our files in the folder; none where it is not there.
std::vector<fs::directory_entry> files_in(const std::string& folder) {
    std::vector<fs::directory_entry> files;
    std::error_code error;
    for (fs::directory_iterator next(folder, error), end; !error && next != end; next.increment(error)) {
        if (is_ours(next->path())) files.push_back(*next);
    }
    return files;
}

/// "mpm on bar_vibration at cells = 4, dt = 0.01"
std::string words_of(const Json& run) {
    std::string resolution;
    for (const auto& [name, value] : run.at("resolution").items())
        resolution += (resolution.empty() ? "" : ", ") + name + " = " + value.dump();
    return fmt::format("{} on {} at {}", run.at("solver").at("name").get<std::string>(),
                       run.at("scene").at("name").get<std::string>(), resolution);
}

/// Of the same scene, solver and resolution, whatever their values and options.
bool comparable(const Json& a, const Json& b) {
    const auto name = [](const Json& run, const char* part) { return run.at(part).at("name"); };
    return name(a, "scene") == name(b, "scene") && name(a, "solver") == name(b, "solver") &&
           a.at("resolution") == b.at("resolution");
}

std::string key_text(const std::string& build, const std::string& description) {
    return R"({"build":)" + build + R"(,"run":)" + description + "}";
}

}  // namespace

std::string cache_folder() {
    const std::string own = variable("ORDO_CACHE");
    if (own == "off") return "";
    if (!own.empty()) return own;
    if (const auto caches = variable("XDG_CACHE_HOME"); !caches.empty()) return caches + "/ordo";
    const auto home = variable("HOME");
    return home.empty() ? "" : home + "/.cache/ordo";
}

RunCache::RunCache(std::string folder, std::string build) : folder_(std::move(folder)), build_(std::move(build)) {}

std::string RunCache::path_of(const std::string& description) const {
    return folder_ + "/" + digest(key_text(build_, description)) + ".json";
}

std::optional<studies::Run> RunCache::find(const std::string& description) {
    const std::lock_guard lock(mutex_);
    if (const auto made = made_.find(description); made != made_.end()) return made->second;
    if (folder_.empty()) return {};
    const std::string path = path_of(description);
    std::error_code error;
    if (!fs::exists(path, error)) {
        missed_.push_back(description);
        return {};
    }
    try {
        KeptRun entry = kept_run_from(studies::read_text(path), path);
        if (entry.build != build_ || entry.description != description)
            throw InputError(path, "is the entry of another run");
        entry.run.origin = studies::Origin::cached;
        return entry.run;
    } catch (const InputError& damaged) {
        missed_.push_back(description);
        complaints_.push_back(std::string(damaged.what()) + "; the run is made again");
        return {};
    }
}

void RunCache::keep(const std::string& description, const studies::Run& run) {
    const std::lock_guard lock(mutex_);
    auto& made = made_[description] = run;
    made.origin = studies::Origin::shared;
    if (folder_.empty() || !writable_) return;
    try {
        fs::create_directories(folder_);
        write_whole(path_of(description), text_of(KeptRun{build_, description, run}));
    } catch (const std::exception& error) {
        writable_ = false;
        complaints_.push_back(std::string(error.what()) + "; runs are not kept");
    }
}

void RunCache::read_entries() {
    for (const auto& file : files_in(folder_)) {
        const std::string path = file.path().string();
        try {
            const KeptRun entry = kept_run_from(studies::read_text(path), path);
            entries_.emplace_back(entry.build, entry.description);
        } catch (const InputError&) {
            continue;  // said where it is asked for
        }
    }
}

std::string RunCache::why_not(const std::string& description) const {
    const Json run = Json::parse(description);
    std::vector<Difference> fewest;
    bool any = false;
    for (const auto& [build, other] : entries_) {
        if (!comparable(run, Json::parse(other))) continue;
        auto found = differences(key_text(build, other), key_text(build_, description));
        if (!any || found.size() < fewest.size()) fewest = std::move(found);
        any = true;
    }
    return words_of(run) + ": " + (any ? text_of(fewest) : "no such run is kept");
}

std::vector<std::string> RunCache::missed() {
    const std::lock_guard lock(mutex_);
    return std::exchange(missed_, {});
}

std::vector<std::string> RunCache::complaints() {
    const std::lock_guard lock(mutex_);
    return std::exchange(complaints_, {});
}

void RunCache::trim(std::size_t most) {
    if (folder_.empty()) return;
    auto files = files_in(folder_);
    if (files.size() <= most) return;
    std::vector<std::pair<fs::file_time_type, fs::path>> by_age;
    std::error_code ignored;
    for (const auto& file : files) {
        if (file.is_regular_file(ignored)) by_age.emplace_back(file.last_write_time(ignored), file.path());
    }
    std::ranges::sort(by_age);
    const std::size_t left = most - most / 4;
    for (std::size_t i = 0; i + left < by_age.size(); ++i) fs::remove(by_age[i].second, ignored);
}

}  // namespace ordo::reports
