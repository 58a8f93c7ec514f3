#pragma once

/// Internal parts of a HandPosterior, for its own sources.

#include "posterior/hand_posterior.h"
#include "posterior/posterior_data.h"
#include "posterior/posterior_entries.h"
#include "posterior/simd_loops.h"

namespace thenar {
namespace internal {

/// Problem, layout of x, measurements and kernels.
struct PosteriorParts {
  FitProblem problem;
  PosteriorOptions options;
  PosteriorEntries entries;
  ForceNoise model;
  std::vector<ObservedForces> data;   // of each experiment
  std::vector<ForceKernel> kernels;   // of each experiment
  std::vector<Eigen::VectorXd> rest;  // u of each specimen where all entries add nothing [SI]
};

/// Contributions of the entries of x to the coordinates, at several points.
struct EntryMotion {
  SimdRows x;     // the points [1] (entries of x, points)
  SimdRows y;     // [SI] (coordinate entries, points)
  SimdRows by_x;  // dy/dx [SI] (coordinate entries, points)
  SimdRows
      by_log_specimen_scale;  // dy/d log k [SI]; empty without specimen_scales (the same, points)
  SimdRows by_centre;         // dy/dy of the centre [1]; empty without centres (the same, points)
  Eigen::MatrixXd log_noise;  // log of the factors [1] (experiments, points)
  Eigen::MatrixXd specimen_scale;  // factors k [1] (kinds, points)
};

[[nodiscard]] EntryMotion move(const PosteriorParts& parts,
                               const Eigen::Ref<const Eigen::MatrixXd>& x);

/// Coordinates of every specimen at every point.
struct Displaced {
  std::vector<Eigen::MatrixXd> u;  // of each specimen [SI] (coordinates, points)
  std::vector<char> non_finite;    // of each point: u is not finite, and was put to zero
};
[[nodiscard]] Displaced displace(const PosteriorParts& parts, const EntryMotion& motion);

/// Log prior of the points; its gradient by x where it has columns.
void set_prior(const PosteriorParts& parts, const EntryMotion& motion, Eigen::VectorXd& log_prior,
               Eigen::MatrixXd& gradient);

}  // namespace internal

struct HandPosterior::Parts : internal::PosteriorParts {};

}  // namespace thenar
