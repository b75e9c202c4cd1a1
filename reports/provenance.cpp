#include <array>
#include <ctime>
#include <fstream>
#include <thread>

#include "build_facts.hpp"
#include "reports/report.hpp"

namespace ordo::reports {
namespace {

/// What stands behind `key` and the separator in the first such line of a file, or "unknown".
std::string fact(const char* path, const std::string& key, char separator) {
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) {
        if (line.rfind(key, 0) != 0) continue;
        std::string value = line.substr(line.find(separator) + 1);
        while (!value.empty() && (value.front() == ' ' || value.front() == '"')) value.erase(0, 1);
        while (!value.empty() && value.back() == '"') value.pop_back();
        return value;
    }
    return "unknown";
}

std::string now_utc() {
    const std::time_t now = std::time(nullptr);
    std::tm utc{};
    gmtime_r(&now, &utc);
    std::array<char, 32> text{};
    std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &utc);
    return text.data();
}

}  // namespace

Provenance provenance_here(int jobs, double seconds) {
    using namespace build_facts;
    return {.time_utc = now_utc(),
            .ordo_version = version,
            .revision = revision,
            .compiler = compiler,
            .flags = flags,
            .build_type = build_type,
            .libraries = {std::string("Boost ") + boost, std::string("Eigen ") + eigen,
                          std::string("fmt ") + build_facts::fmt, std::string("GSL ") + build_facts::gsl,
                          std::string("nlohmann-json ") + json},
            .cpu = fact("/proc/cpuinfo", "model name", ':'),
            .cores = static_cast<int>(std::thread::hardware_concurrency()),
            .os = fact("/etc/os-release", "PRETTY_NAME", '='),
            .jobs = jobs,
            .seconds = seconds,
            .kernel_seconds = std::numeric_limits<double>::quiet_NaN()};
}

}  // namespace ordo::reports
