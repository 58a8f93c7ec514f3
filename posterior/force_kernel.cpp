#include "posterior/force_kernel.h"

#include <vector>

#include "base/error.h"
#include "kinematics_fit/force_jacobian.h"

namespace thenar {

struct ForceKernel::Program {
  TendonDigit digit;
  FitParameters parameters;
  ExperimentPlan plan;
};

class ForceKernel::Tape {
 public:
  std::vector<Eigen::MatrixXd> J;  // of each point (3 trials, coordinates)
};

ForceKernel::ForceKernel(const TendonDigit& digit, const FitParameters& parameters,
                         const ExperimentPlan& plan)
    : program_(new Program{digit, parameters, plan}) {}
ForceKernel::~ForceKernel() = default;
ForceKernel::ForceKernel(ForceKernel&&) noexcept = default;

int ForceKernel::coordinates() const { return program_->parameters.coordinates(); }
int ForceKernel::trials() const { return static_cast<int>(program_->plan.force.cols()); }
int ForceKernel::lanes() { return 1; }

Eigen::MatrixXd ForceKernel::forces(const Eigen::Ref<const Eigen::MatrixXd>& u) const {
  require(u.rows() == coordinates(), "the digit has {} coordinates, u has {}", coordinates(),
          u.rows());
  Eigen::MatrixXd forces(3 * trials(), u.cols());
  for (Eigen::Index k = 0; k < u.cols(); ++k)
    forces.col(k) =
        force_values(program_->digit, program_->parameters, program_->plan, u.col(k)).reshaped();
  return forces;
}

ForceKernel::Recorded ForceKernel::record(const Eigen::Ref<const Eigen::MatrixXd>& u) const {
  Recorded out{forces(u), std::make_shared<Tape>()};
  for (Eigen::Index k = 0; k < u.cols(); ++k)
    out.tape->J.push_back(
        force_jacobian(program_->digit, program_->parameters, program_->plan, u.col(k)).J);
  return out;
}

Eigen::MatrixXd ForceKernel::pull_back(const Recorded& recorded,
                                       const Eigen::Ref<const Eigen::MatrixXd>& weights) const {
  require(weights.rows() == 3 * trials() && weights.cols() == recorded.forces.cols(),
          "weights are wanted for {} forces of {} points, got {} x {}", 3 * trials(),
          recorded.forces.cols(), weights.rows(), weights.cols());
  Eigen::MatrixXd gradient(coordinates(), weights.cols());
  for (Eigen::Index k = 0; k < weights.cols(); ++k)
    gradient.col(k) = recorded.tape->J[static_cast<std::size_t>(k)].transpose() * weights.col(k);
  return gradient;
}

}  // namespace thenar
