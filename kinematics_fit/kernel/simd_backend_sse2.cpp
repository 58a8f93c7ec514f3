#if defined(__x86_64__)
#define THENAR_LANES 2
#include "kinematics_fit/kernel/run.h"

namespace thenar::kernel {

extern const SimdBackend kSse2;
const SimdBackend kSse2 = {"sse2", kLanes, tape_length, scratch_length, run, run_adjoint};

}  // namespace thenar::kernel
#endif
