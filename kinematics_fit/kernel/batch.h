#pragma once

/// Runs many points through a backend, a group of lanes at a time.

#include <memory>
#include <vector>

#include <Eigen/Core>

#include "kinematics_fit/kernel/simd_backend.h"

namespace thenar::kernel {

/// Aligned memory for the registers of any backend.
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

/// Points that a backend ran together, and their tape.
struct Group {
  const SimdBackend* backend;
  Eigen::Index first;  // point
  int count;           // of points
  double* tape;        // in the batch's memory
};

struct Batch {
  Eigen::MatrixXd forces;  // [N] (3 trials, points)
  std::vector<Group> groups;
  SimdBuffer memory;  // of all tapes, or of one that all groups wrote over
};

/// @param choice  backends to take, widest first; the last points go to the narrowest backend that
///                holds them
/// @param u       (fit coordinates, points)
[[nodiscard]] Batch run_batch(const Program& program, const std::vector<SimdBackend>& choice,
                              const Eigen::Ref<const Eigen::MatrixXd>& u, KeepTape keep);

/// J' w (fit coordinates, points) for weights w (3 trials, points).
[[nodiscard]] Eigen::MatrixXd adjoint_batch(const Program& program, const Batch& batch,
                                            const Eigen::Ref<const Eigen::MatrixXd>& weights);

}  // namespace thenar::kernel
