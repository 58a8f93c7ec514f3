#include "kinematics_fit/kernel/force_kernel.h"

#include "base/error.h"
#include "kinematics_fit/kernel/batch.h"
#include "kinematics_fit/kernel/compile.h"

namespace thenar {

struct ForceKernel::Program : kernel::Program {};

class ForceKernel::Tape {
 public:
  explicit Tape(kernel::Batch of) : batch(std::move(of)) {}
  kernel::Batch batch;  // its forces have moved out
};

ForceKernel::ForceKernel(const TendonDigit& digit, const FitParameters& parameters,
                         const ExperimentPlan& plan)
    : program_(std::make_unique<Program>()) {
  require(plan.sites.empty(),
          "a posterior knows forces of the tip alone; leave out the trials that were measured at "
          "other segments ('at'), or ask `thenar fit` and `thenar predict`");
  kernel::compile(digit, parameters, plan, *program_);
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
  // The tape stays with whoever asks for the adjoint.
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
  const Eigen::Index rows = 3 * Eigen::Index{trials()};
  const Recorded recorded = record(u.replicate(1, rows));
  return {recorded.forces.col(0),
          adjoint_product(recorded, Eigen::MatrixXd::Identity(rows, rows)).transpose()};
}

}  // namespace thenar
