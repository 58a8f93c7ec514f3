#include "kinematics_fit/kernel/simd_backend.h"

namespace thenar::kernel {

extern const SimdBackend kScalar, kSse2, kAvx2, kAvx512;

const std::vector<SimdBackend>& simd_backends() {
  // Query the processor once.
  static const std::vector<SimdBackend> all = [] {
    std::vector<SimdBackend> fit;
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx512f")) fit.push_back(kAvx512);
    if (__builtin_cpu_supports("avx2")) fit.push_back(kAvx2);
    fit.push_back(kSse2);
#endif
    fit.push_back(kScalar);
    return fit;
  }();
  return all;
}

}  // namespace thenar::kernel
