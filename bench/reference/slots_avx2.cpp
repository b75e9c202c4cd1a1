#include "bench/reference/slots.hpp"

namespace ordo::bench {

using V_avx2 [[gnu::vector_size(32)]] = double;

SlotSteps slots_avx2() { return slot_steps<V_avx2>("avx2"); }

}  // namespace ordo::bench
