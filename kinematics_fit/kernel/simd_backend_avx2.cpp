#if defined(__x86_64__)
#define THENAR_LANES 4
#include "kinematics_fit/kernel/run.h"

namespace thenar::kernel {

extern const SimdBackend kAvx2;
const SimdBackend kAvx2 = {"avx2", kLanes, tape_length, scratch_length, run, run_adjoint};

}  // namespace thenar::kernel
#endif
