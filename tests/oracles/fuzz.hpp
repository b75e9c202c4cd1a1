#pragma once
// Random parameters for exact solutions: seeded, spread over decades, and counted, so that a test can say how many
// calls were admissible. ORDO_FUZZ=100 in the environment makes every such test a hundred times as long.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>

namespace ordo::oracles::gate {

/// Numbers of one seeded sequence.
class Random {
public:
    explicit Random(unsigned seed) : engine_(seed) {}
    double uniform(double low, double high) { return low + (high - low) * real_(engine_); }
    double log_uniform(double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); }
    int whole(int low, int high) { return low + static_cast<int>(engine_() % static_cast<unsigned>(high - low + 1)); }
    bool coin() { return engine_() % 2 == 0; }

private:
    // Not std::uniform_*_distribution: their sequences differ between standard libraries.
    std::mt19937 engine_;
    struct {
        double operator()(std::mt19937& engine) const {
            return static_cast<double>((static_cast<unsigned long long>(engine() >> 5) << 26) | (engine() >> 6)) *
                   0x1p-53;
        }
    } real_;
};

/// How often a fuzz test runs its body: `rounds` in the default suite.
inline int fuzz_rounds(int rounds) {
    const char* factor = std::getenv("ORDO_FUZZ");
    return factor == nullptr ? rounds : rounds * std::max(1, std::atoi(factor));
}

/// What became of random calls: an identity was checked, or the input was refused (InputError) where theory allows it.
struct Tally {
    int checked = 0;
    int refused = 0;
    bool mostly_checked() const { return checked >= refused; }
};

}  // namespace ordo::oracles::gate
