#pragma once
// Runs at a Courant number: do they stay bounded?
#include <functional>
#include <string>

#include "studies/amplification/scheme.hpp"
#include "studies/engine/study.hpp"

namespace ordo::studies {

/// How a run went on. `growth` is its largest norm over the largest of the reference; infinite where it blew up. `kept`
/// is the mean square of the norm in the last quarter over that at the start: of a body its energy; 0 where it was
/// ended.
struct Growth {
    enum class Class { stable, growing, blown_up };
    Class kind = Class::stable;
    double growth = 0;
    double kept = 0;
    std::string why = {};  ///< of a run that blew up
};

/// Runs of a scheme, each as long as a wave takes to cross `crossings` cells, against the one at the lowest Courant
/// number. The norm of a body is sqrt(sum V0 (v^2 / c^2 + |F - 1|^2)), twice its energy over that of a unit strain
/// where moduli are alike; of a line, field by field, the root mean square.
class Growths {
public:
    Growths(Scheme scheme, const Stability& asked, const solvers::Interrupt& interrupt);

    /// `to_the_end`: growth alone does not end it.
    Growth at(double courant, bool to_the_end) const;

private:
    using Sizes = std::vector<double>;
    Sizes sizes(const solvers::Snapshot& shot) const;
    /// tell(sizes) at the start and 64 later times; false ends it. Throws Diverged.
    void run(double courant, const std::function<bool(const Sizes&)>& tell) const;

    Scheme scheme_;
    Stability asked_;
    solvers::Interrupt interrupt_;
    solvers::Scene scene_;  ///< as it is run
    double c_ = 1;          ///< of a body
    std::vector<std::string> fields_;
    Sizes reference_;
};

}  // namespace ordo::studies
