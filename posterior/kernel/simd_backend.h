#pragma once

/// The same steps compiled for several processors, to be chosen from at run time.

#include <vector>

#include "posterior/kernel/program.h"

namespace thenar::kernel {

/// Will run_adjoint() be asked? If not, all postures are written over the same part of the tape,
/// which then stays in the cache.
enum class KeepTape { kNo, kYes };

/// One of them. Sizes are in packs of `lanes` doubles; memory is aligned to 64 bytes.
struct SimdBackend {
  const char* name;
  int lanes;                               // points at a time
  long (*tape_length)(const Program&);     // of what run() leaves for run_adjoint()
  long (*scratch_length)(const Program&);  // of what either needs meanwhile

  /// Forces of `count` of the `lanes` points whose coordinates are given; those beyond are computed
  /// and dropped, so repeat a point there.
  void (*run)(const Program&, const double* const* u, int count, double* tape, double* scratch,
              double* const* forces, KeepTape keep);
  /// Their adjoint.
  void (*run_adjoint)(const Program&, double* tape, const double* const* weights, int count,
                      double* scratch, double* const* gradient);
};

/// All that this processor can run, the widest first; the last takes points one by one.
[[nodiscard]] const std::vector<SimdBackend>& simd_backends();

}  // namespace thenar::kernel
