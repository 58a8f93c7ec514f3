#define THENAR_LANES 1
#include "kinematics_fit/kernel/run.h"

namespace thenar::kernel {

extern const SimdBackend kScalar;
const SimdBackend kScalar = {"scalar", kLanes, tape_length, scratch_length, run, run_adjoint};

}  // namespace thenar::kernel
