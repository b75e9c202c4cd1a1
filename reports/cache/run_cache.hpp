#pragma once
// Finished runs on disk: a run that was made once by the same sources is not made again. docs/cache.md says where they
// lie, what they are known by, and how many are kept.
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "studies/engine/engine.hpp"

namespace ordo::reports {

/// $ORDO_CACHE, or ordo/ in $XDG_CACHE_HOME or in ~/.cache; "" where ORDO_CACHE is "off" or there is no home.
std::string cache_folder();

/// Runs made by this program and those kept in a folder. May be used from several threads, and the folder by several
/// programs at once: files appear whole. What cannot be read or written is left alone; `complaints` says so.
class RunCache : public studies::FinishedRuns {
public:
    /// An empty folder: what this program made is known, and nothing is kept.
    explicit RunCache(std::string folder, std::string build);

    std::optional<studies::Run> find(const std::string& description) override;
    void keep(const std::string& description, const studies::Run& run) override;

    /// Reads all entries that are there now, for `why_not`.
    void read_entries();
    /// Which parts of the key differ from the nearest of those entries of that scene, solver and resolution. One line.
    std::string why_not(const std::string& description) const;

    /// Descriptions that were asked for and not there, since the last call.
    std::vector<std::string> missed();
    /// What was ignored and why, since the last call: damaged or foreign files, a folder that cannot be written.
    std::vector<std::string> complaints();

    /// Where more than `most` runs are kept, the oldest go until three quarters of that are left.
    void trim(std::size_t most);

private:
    std::string path_of(const std::string& description) const;

    std::string folder_;
    std::string build_;  ///< JSON: what else figures follow from
    std::mutex mutex_;
    std::map<std::string, studies::Run> made_;  ///< by description
    std::vector<std::string> missed_;
    std::vector<std::string> complaints_;
    std::vector<std::pair<std::string, std::string>> entries_;  ///< build and description
    bool writable_ = true;
};

}  // namespace ordo::reports
