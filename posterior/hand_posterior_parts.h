#pragma once

/// What a HandPosterior is made of; for its own sources.

#include "posterior/hand_posterior.h"
#include "posterior/posterior_data.h"
#include "posterior/posterior_entries.h"

namespace thenar {

namespace internal {

struct PosteriorParts {
  FitProblem problem;
  PosteriorOptions options;
  PosteriorEntries entries;
  ForceNoise model;
  std::vector<ObservedForces> data;   // of each experiment
  std::vector<ForceKernel> kernels;   // of each experiment
  std::vector<Eigen::VectorXd> rest;  // u of each specimen where all entries add nothing [SI]

  /// The map of an entry where its spread factor is k.
  [[nodiscard]] std::optional<BoundedNormal> bounds(const CoordinateEntry& entry, double k) const;
};

/// What the entries of some points add to coordinates.
struct EntryMotion {
  Eigen::MatrixXd y;          // [SI] (entries, points)
  Eigen::MatrixXd by_x;       // dy/dx [SI] (entries, points)
  Eigen::MatrixXd by_spread;  // dy/d log k [SI] (entries, points)
  Eigen::MatrixXd scale;      // k sd [SI] (entries, points)
  Eigen::MatrixXd noise;      // factors [1] (experiments, points)
  Eigen::MatrixXd spread;     // factors k [1] (kinds, points)
};

/// Log prior of the points; its gradient by x where it has columns.
void add_prior(const PosteriorEntries& entries, double spread_sd, const EntryMotion& motion,
               const Eigen::Ref<const Eigen::MatrixXd>& x, Eigen::VectorXd& log_prior,
               Eigen::MatrixXd& gradient);

}  // namespace internal

struct HandPosterior::Parts : internal::PosteriorParts {};

}  // namespace thenar
