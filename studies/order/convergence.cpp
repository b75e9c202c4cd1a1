#include "studies/order/convergence.hpp"

namespace ordo::studies {

std::string text_of(Convergence convergence) {
    switch (convergence) {
        case Convergence::converges: return "converges";
        case Convergence::at_floor: return "at_floor";
        case Convergence::pre_asymptotic: return "pre_asymptotic";
        case Convergence::stalled: return "stalled";
        case Convergence::diverges: return "diverges";
        case Convergence::inconclusive: return "inconclusive";
        case Convergence::invalid: break;
    }
    return "invalid";
}

}  // namespace ordo::studies
