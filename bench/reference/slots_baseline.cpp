#include "bench/reference/slots.hpp"

namespace ordo::bench {

using V_baseline [[gnu::vector_size(16)]] = double;

SlotSteps slots_baseline() { return slot_steps<V_baseline>("baseline"); }

}  // namespace ordo::bench
