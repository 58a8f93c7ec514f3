#pragma once

/// The force model compiled for several processors, one of which is chosen at run time.

#include <vector>

#include "kinematics_fit/kernel/program.h"

namespace thenar::kernel {

/// Announces whether run_adjoint() will follow. With kNo all postures use the same part of the
/// tape, which then stays in the cache.
enum class KeepTape { kNo, kYes };

/// One backend. Sizes are in registers of `lanes` doubles; memory is aligned to 64 bytes.
struct SimdBackend {
  const char* name;
  int lanes;                               // points at a time
  long (*tape_length)(const Program&);     // tape of run() for run_adjoint() [registers]
  long (*scratch_length)(const Program&);  // work space of either [registers]

  /// Forces [N] of the first `count` of `lanes` points; the results of the other points are
  /// dropped, so repeat a point there.
  void (*run)(const Program&, const double* const* u, int count, double* tape, double* scratch,
              double* const* forces, KeepTape keep);
  /// Adjoint: gradients from weights of the forces.
  void (*run_adjoint)(const Program&, double* tape, const double* const* weights, int count,
                      double* scratch, double* const* gradient);
};

/// Backends that this processor can run, the widest first; the last takes points one by one.
[[nodiscard]] const std::vector<SimdBackend>& simd_backends();

}  // namespace thenar::kernel
