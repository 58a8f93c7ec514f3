#include "kinematics_fit/kernel/force_kernel.h"

#include <algorithm>

#include "base/error.h"
#include "kinematics_fit/kernel/batch.h"
#include "kinematics_fit/kernel/compile.h"

namespace thenar {

struct ForceKernel::Program : kernel::Program {};

class ForceKernel::Tape {
 public:
  explicit Tape(kernel::Batch completed) : batch(std::move(completed)) {}
  kernel::Batch batch;  // tapes of the run; its forces were moved out
};

ForceKernel::ForceKernel(const TendonDigit& digit, const FitParameters& parameters,
                         const ExperimentPlan& plan)
    : program_(std::make_unique<Program>()) {
  require(supports(digit, plan),
          "a compiled model has no extensor net and forces of the tip alone");
  kernel::compile(digit, parameters, plan, *program_);
}
bool ForceKernel::supports(const TendonDigit& digit, const ExperimentPlan& plan) {
  return !digit.net && plan.sites.empty();
}

ForceKernel::~ForceKernel() = default;
ForceKernel::ForceKernel(ForceKernel&&) noexcept = default;

int ForceKernel::coordinates() const { return program_->fit_coordinates; }
int ForceKernel::trials() const { return program_->trials; }
int ForceKernel::lanes() { return kernel::simd_backends().front().lanes; }

Eigen::MatrixXd ForceKernel::forces(const Eigen::Ref<const Eigen::MatrixXd>& u) const {
  require(u.rows() == coordinates(), "the digit has {} coordinates, u has {}", coordinates(),
          u.rows());
  return kernel::run_batch(*program_, kernel::simd_backends(), u, kernel::KeepTape::kNo).forces;
}

ForceKernel::Recorded ForceKernel::record(const Eigen::Ref<const Eigen::MatrixXd>& u) const {
  require(u.rows() == coordinates(), "the digit has {} coordinates, u has {}", coordinates(),
          u.rows());
  // Keep the tape for the adjoint.
  auto tape = std::make_shared<Tape>(
      kernel::run_batch(*program_, kernel::simd_backends(), u, kernel::KeepTape::kYes));
  Eigen::MatrixXd forces = std::move(tape->batch.forces);
  return {std::move(forces), std::move(tape)};
}

Eigen::MatrixXd ForceKernel::adjoint_product(
    const Recorded& recorded, const Eigen::Ref<const Eigen::MatrixXd>& weights) const {
  require(weights.rows() == 3 * trials() && weights.cols() == recorded.forces.cols(),
          "weights are wanted for {} forces of {} points, got {} x {}", 3 * trials(),
          recorded.forces.cols(), weights.rows(), weights.cols());
  return kernel::adjoint_batch(*program_, recorded.tape->batch, weights);
}

ForceKernel::Slopes ForceKernel::slopes(const Eigen::VectorXd& u) const {
  const Eigen::Index rows = 3 * Eigen::Index{trials()}, lane_count = lanes();
  Slopes out{Eigen::VectorXd(rows), Eigen::MatrixXd(rows, coordinates())};
  if (rows == 0) return out;
  // Run the point in all lanes, then apply adjoints to as many forces at a time as there are lanes.
  const Recorded recorded = record(u.replicate(1, lane_count));
  out.forces = recorded.forces.col(0);
  for (Eigen::Index first = 0; first < rows; first += lane_count) {
    const Eigen::Index count = std::min(lane_count, rows - first);
    Eigen::MatrixXd weights = Eigen::MatrixXd::Zero(rows, lane_count);
    weights.middleRows(first, count).leftCols(count).setIdentity();
    out.J.middleRows(first, count) = adjoint_product(recorded, weights).leftCols(count).transpose();
  }
  return out;
}

}  // namespace thenar
