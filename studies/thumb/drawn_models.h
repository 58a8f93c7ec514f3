#pragma once

/// Digits at points of a posterior of one specimen.

#include <Eigen/Core>

#include "posterior/hand_posterior.h"
#include "tendons/tendon_model.h"

namespace thenar::internal {

/// Models of the digit at points of a posterior, which must outlive it.
class DrawnModels {
 public:
  /// @param x  points of the posterior as columns (size, count)
  DrawnModels(const HandPosterior& posterior, const Eigen::Ref<const Eigen::MatrixXd>& x);

  [[nodiscard]] Eigen::Index count() const { return values_.cols(); }

  /// Returns the model of the first specimen at point k, 0 .. count() - 1.
  [[nodiscard]] TendonModel<double> at(Eigen::Index k) const;

  /// Returns the models at all points.
  [[nodiscard]] std::vector<TendonModel<double>> all() const;

  /// Returns the values of free parameters of one kind at all points [SI] (parameters, count).
  [[nodiscard]] Eigen::MatrixXd values(ParameterKind kind) const;

  /// Returns the names of the rows of values().
  [[nodiscard]] std::vector<std::string> names(ParameterKind kind) const;

 private:
  const HandPosterior& posterior_;
  std::vector<int> moving_;
  Eigen::MatrixXd values_;  // [SI] (parameters that move, count)
};

}  // namespace thenar::internal
