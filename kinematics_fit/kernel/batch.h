#pragma once

/// Evaluation of many points by SIMD backends, one group of lanes at a time.

#include <memory>
#include <vector>

#include <Eigen/Core>

#include "kinematics_fit/kernel/simd_backend.h"

namespace thenar::kernel {

/// Memory aligned for the registers of any backend.
class SimdBuffer {
 public:
  explicit SimdBuffer(long doubles);
  [[nodiscard]] double* first() const { return first_.get(); }

 private:
  struct Free {
    void operator()(double* p) const;
  };
  std::unique_ptr<double, Free> first_;
};

/// Points evaluated together by a backend, and their tape.
struct Group {
  const SimdBackend* backend;
  Eigen::Index first;  // index of the first point
  int count;           // number of points
  double* tape;        // tape within the memory of the batch
};

/// Forces of all points, with the tapes of their computation.
struct Batch {
  Eigen::MatrixXd forces;  // [N] (3 trials, points)
  std::vector<Group> groups;
  SimdBuffer memory;  // memory of all tapes, or of one that all groups overwrite
};

/// Predicts the forces at many points.
/// @param choice  backends to use, widest first; the last points use the narrowest backend that
///         holds them
/// @param u       displacements (fit coordinates, points)
[[nodiscard]] Batch run_batch(const Program& program, const std::vector<SimdBackend>& choice,
                              const Eigen::Ref<const Eigen::MatrixXd>& u, KeepTape keep);

/// Computes J' w (fit coordinates, points) for weights w (3 trials, points).
[[nodiscard]] Eigen::MatrixXd adjoint_batch(const Program& program, const Batch& batch,
                                            const Eigen::Ref<const Eigen::MatrixXd>& weights);

}  // namespace thenar::kernel
