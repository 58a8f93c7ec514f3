#if defined(__x86_64__)
#define THENAR_LANES 4
#include "posterior/kernel/run.h"

namespace thenar::kernel {

extern const Unit kAvx2;
const Unit kAvx2 = {"avx2", kLanes, tape_length, scratch_length, run, pull};

}  // namespace thenar::kernel
#endif
