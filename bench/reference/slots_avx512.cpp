#include "bench/reference/slots.hpp"

namespace ordo::bench {

using V_avx512 [[gnu::vector_size(64)]] = double;

SlotSteps slots_avx512() { return slot_steps<V_avx512>("avx512"); }

}  // namespace ordo::bench
