#pragma once

/// Posterior density of a digit given forces and muscle activations, defined on all real vectors.

#include <memory>
#include <string>
#include <vector>

#include "kinematics_fit/fit_problem.h"
#include "kinematics_fit/kernel/force_kernel.h"
#include "posterior/posterior_options.h"
#include "sampling/methods/target.h"

namespace thenar {

/// Parameters of a digit, and scale factors, at several points.
struct PosteriorValues {
  Eigen::MatrixXd population;              // parameters that move [SI] (parameters, points)
  std::vector<Eigen::MatrixXd> specimens;  // parameters of each specimen [SI] (parameters, points)
  Eigen::MatrixXd noise;                   // factor on the stated noise [1] (experiments, points)
  Eigen::MatrixXd specimen_scale;          // factor on between_sd [1] (kinds, points)
};

/// Posterior of a FitProblem without its gauge freedoms:
///   log p(x) = log prior(z(x)) + log |dz/dx| + sum log N(f; f(z), (s sd)^2) + activations.
///
/// x is unbounded: bounded entries of z are smooth maps of x. Shifts of an axis along itself, which
/// no data can identify, are left out. Derivation: docs/theory/fitting.md.
class HandPosterior : public Target {
 public:
  /// @throws InputError if nothing is left to sample, or the digit has a net.
  HandPosterior(FitProblem problem, const PosteriorOptions& options = {});
  ~HandPosterior() override;

  [[nodiscard]] int size() const override;
  [[nodiscard]] int preferred_batch_size() const override;
  [[nodiscard]] Densities evaluate(const Eigen::Ref<const Eigen::MatrixXd>& x,
                                   WithGradient want) const override;

  [[nodiscard]] const FitProblem& problem() const;
  [[nodiscard]] const PosteriorOptions& options() const;
  [[nodiscard]] std::vector<std::string> names()
      const;  // names of the entries of x: "noise/H01" (size)
  [[nodiscard]] std::vector<int> moving_parameters() const;  // indices in parameters().all
  /// Returns the kinds of parameters that have a factor in PosteriorValues::specimen_scale.
  [[nodiscard]] std::vector<std::string> specimen_scale_kinds() const;

  /// Returns parameters and factors at the points x (size, points).
  [[nodiscard]] PosteriorValues values(const Eigen::Ref<const Eigen::MatrixXd>& x) const;
  /// Converts x to z of the fit. Entries of z without an entry of x become zero (size of z).
  [[nodiscard]] Eigen::VectorXd fit_coordinates(const Eigen::VectorXd& x) const;
  /// Converts z of the fit to x. Factors of noise and specimen_scale become 1 (size).
  [[nodiscard]] Eigen::VectorXd from_fit_coordinates(const Eigen::VectorXd& z) const;

  /// Predicts the forces of experiment e [N] (3 trials, points).
  [[nodiscard]] Eigen::MatrixXd forces(const Eigen::Ref<const Eigen::MatrixXd>& x, int e) const;
  /// Computes the log likelihood of every trial of all experiments in turn, then of every
  /// activation row (observations, points).
  [[nodiscard]] Eigen::MatrixXd pointwise(const Eigen::Ref<const Eigen::MatrixXd>& x) const;

  /// Draws a point from the prior (size).
  /// @param number  index of the draw; the same seed and number give the same point
  [[nodiscard]] Eigen::VectorXd draw_prior(unsigned seed, unsigned number) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace thenar
