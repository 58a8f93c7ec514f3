#define THENAR_LANES 1
#include "posterior/kernel/run.h"

namespace thenar::kernel {

extern const Unit kScalar;
const Unit kScalar = {"scalar", kLanes, tape_length, scratch_length, run, pull};

}  // namespace thenar::kernel
