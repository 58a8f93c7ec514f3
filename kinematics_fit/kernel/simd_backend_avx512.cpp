#if defined(__x86_64__)
#define THENAR_LANES 8
#include "kinematics_fit/kernel/run.h"

namespace thenar::kernel {

extern const SimdBackend kAvx512;
const SimdBackend kAvx512 = {"avx512", kLanes, tape_length, scratch_length, run, run_adjoint};

}  // namespace thenar::kernel
#endif
