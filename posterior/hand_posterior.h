#pragma once

/// What forces and muscle activity tell of a digit: a posterior density over all real numbers.

#include <memory>
#include <string>
#include <vector>

#include "kinematics_fit/fit_problem.h"
#include "posterior/force_kernel.h"
#include "sampling/methods/target.h"

namespace thenar {

/// What the posterior asks beyond the least-squares problem.
struct PosteriorOptions {
  bool learn_noise = true;           // a factor on every experiment's noise, log-normal beforehand
  double noise_sd = 0.5;             // sd of its logarithm [1]
  bool learn_specimen_scale = true;  // with several specimens: a factor on between_sd of each kind
  double specimen_scale_sd = 0.5;    // sd of its logarithm [1]
  bool sphere_priors = true;         // von Mises-Fisher on axis directions instead of normal tilts
};

/// What a settings file says of them; a sd of zero learns nothing.
[[nodiscard]] PosteriorOptions posterior_options(const PosteriorPriors& beliefs);

/// The parameters of a digit as people read them.
struct PosteriorValues {
  Eigen::MatrixXd population;              // [SI] (parameters that move, points)
  std::vector<Eigen::MatrixXd> specimens;  // each the same, by FitProblem::specimens()
  Eigen::MatrixXd noise;                   // factor on the stated noise [1] (experiments, points)
  Eigen::MatrixXd specimen_scale;          // factor on between_sd [1] (kinds, points)
};

/// The posterior of a FitProblem, without its gauge freedoms:
///   log p(x) = log prior(z(x)) + log |dz/dx| + sum log N(f; f(z), (s sd)^2) + activations.
///
/// x is unbounded: bounded entries of z go through a smooth map; shifts of a point along its own
/// axis, about which nothing can be known, are left out. docs/theory/fitting.md derives it.
class HandPosterior : public Target {
 public:
  /// @throws InputError if nothing is left to sample.
  HandPosterior(FitProblem problem, const PosteriorOptions& options = {});
  ~HandPosterior() override;

  [[nodiscard]] int size() const override;
  [[nodiscard]] int preferred_batch_size() const override;
  [[nodiscard]] Densities evaluate(const Eigen::Ref<const Eigen::MatrixXd>& x,
                                   WithGradient want) const override;

  [[nodiscard]] const FitProblem& problem() const;
  [[nodiscard]] const PosteriorOptions& options() const;
  [[nodiscard]] std::vector<std::string> names() const;      // of x: "noise/H01" (size)
  [[nodiscard]] std::vector<int> moving_parameters() const;  // indices in parameters().all
  [[nodiscard]] std::vector<std::string> specimen_scale_kinds()
      const;  // of PosteriorValues::specimen_scale

  [[nodiscard]] PosteriorValues values(const Eigen::Ref<const Eigen::MatrixXd>& x) const;
  /// z of FitProblem and back; entries that x lacks are zero, noise and specimen_scale factors 1
  /// (size).
  [[nodiscard]] Eigen::VectorXd fit_coordinates(const Eigen::VectorXd& x) const;
  [[nodiscard]] Eigen::VectorXd from_fit(const Eigen::VectorXd& z) const;

  /// Forces of experiment e [N] (3 trials, points).
  [[nodiscard]] Eigen::MatrixXd forces(const Eigen::Ref<const Eigen::MatrixXd>& x, int e) const;
  /// Log likelihood of every trial of every experiment in turn, and every activation row
  /// (observations, points).
  [[nodiscard]] Eigen::MatrixXd pointwise(const Eigen::Ref<const Eigen::MatrixXd>& x) const;

  /// A point drawn from the prior (size).
  [[nodiscard]] Eigen::VectorXd draw_prior(unsigned seed, unsigned number) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace thenar
