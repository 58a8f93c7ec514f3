#include "bench/sampler_rivals/thumb_density.h"

#include <limits>

#include "base/error.h"
#include "kinematics_fit/specimen_prior.h"

namespace thenar::bench {

ThumbDensity::Compiled::Compiled(const FitProblem& problem) {
  require(problem.experiments().size() == 1 && problem.specimens().size() == 1,
          "one experiment of one specimen is wanted, got {} of {}", problem.experiments().size(),
          problem.specimens().size());
  kernel::compile(problem.digit(), problem.parameters(), problem.plans().front(), program);
}

ThumbDensity::ThumbDensity(const FitProblem& problem)
    : compiled_(problem),
      unit_(&kernel::simd_backends().back()),
      lower_(problem.coordinates().lower()),
      upper_(problem.coordinates().upper()),
      scale_(displacement_jacobian(problem.coordinates(), Eigen::VectorXd::Zero(problem.size()), 0)
                 .diagonal()),
      measured_(problem.plans().front().force.reshaped()),
      precision_(problem.plans().front().sd.cwiseInverse().reshaped()),
      u_(problem.size()),
      force_(3 * compiled_.program.trials),
      tape_(unit_->lanes * unit_->tape_length(compiled_.program)),
      scratch_(unit_->lanes * unit_->scratch_length(compiled_.program)) {
  require(compiled_.program.fit_coordinates == problem.size(),
          "{} coordinates, but z has {} entries", compiled_.program.fit_coordinates,
          problem.size());
}

double ThumbDensity::operator()(const Eigen::VectorXd& z) {
  if ((z.array() < lower_.array()).any() || (z.array() > upper_.array()).any())
    return -std::numeric_limits<double>::infinity();
  u_ = scale_.cwiseProduct(z);
  const double* u = u_.data();
  double* force = force_.data();
  unit_->run(compiled_.program, &u, 1, tape_.first(), scratch_.first(), &force,
             kernel::KeepTape::kNo);
  return -0.5 * (z.squaredNorm() + (force_ - measured_).cwiseProduct(precision_).squaredNorm());
}

}  // namespace thenar::bench
