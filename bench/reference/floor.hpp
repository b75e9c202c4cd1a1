#pragma once
// The floor and the scalar loop as running problems of one shape.
#include <memory>
#include <string>

#include "bench/reference/slots.hpp"
#include "bench/reference/wave.hpp"

namespace ordo::bench {

/// Doubles on pages of 2 MiB where the system gives such, aligned to them.
class Pages {
public:
    explicit Pages(std::size_t count);
    double* begin() { return data_.get(); }
    const double* begin() const { return data_.get(); }
    std::size_t size() const { return count_; }

private:
    struct Free {
        void operator()(double* data) const;
    };
    std::unique_ptr<double, Free> data_;
    std::size_t count_;
};

/// The slots of `slots.hpp`. The last axis must have a multiple of 8 cells, at least 8 times the degree.
class Floor {
public:
    /// `set`: "avx512", "avx2", "baseline", or empty for the best that this machine has.
    /// Throws std::invalid_argument where the machine or the wave does not fit.
    explicit Floor(const Wave& wave, const std::string& set = "");

    void step();
    Particles particles() const;  ///< in the order of `seeded`
    double bytes_per_particle() const;
    const char* set() const { return loops_.name; }

private:
    void close();  ///< joins strips and mirrors at walls what lies in run_.next, and makes it run_.nodes
    template <class Visit>
    void each_value(Particles& p, Visit&& visit) const;

    Wave wave_;
    SlotSteps loops_;
    Pages slots_;
    Pages nodes_;  ///< of a step and of the next one
    SlotRun run_;
};

}  // namespace ordo::bench
