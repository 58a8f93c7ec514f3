#pragma once

/// Force model compiled for several processors, one of which is chosen at run time.

#include <vector>

#include "kinematics_fit/kernel/program.h"

namespace thenar::kernel {

/// Choice of the tape: kYes keeps it for run_adjoint(); with kNo all postures use the same part of
/// it, which then stays in the cache.
enum class KeepTape { kNo, kYes };

/// Functions compiled for one processor. Sizes are in registers of `lanes` doubles; memory must be
/// aligned to 64 bytes.
struct SimdBackend {
  const char* name;
  int lanes;                            // number of points at a time
  long (*tape_length)(const Program&);  // length of the tape of run() for run_adjoint() [registers]
  long (*scratch_length)(const Program&);  // length of the scratch memory of either [registers]

  /// Evaluates the forces [N] of the first `count` of `lanes` points. Unused lanes must hold valid
  /// points, e.g. repeated ones; their results are discarded.
  void (*run)(const Program&, const double* const* u, int count, double* tape, double* scratch,
              double* const* forces, KeepTape keep);
  /// Evaluates the adjoint: gradients from weights of the forces.
  void (*run_adjoint)(const Program&, double* tape, const double* const* weights, int count,
                      double* scratch, double* const* gradient);
};

/// Returns the backends that this processor supports, widest first; the last evaluates single
/// points.
[[nodiscard]] const std::vector<SimdBackend>& simd_backends();

}  // namespace thenar::kernel
