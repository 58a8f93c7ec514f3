#pragma once

/// Internal data of a HandPosterior, for its own sources.

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
  ForceNoise model;                   // distribution of the measured forces
  std::vector<ObservedForces> data;   // measurements of each experiment
  std::vector<ForceKernel> kernels;   // force kernel of each experiment
  std::vector<Eigen::VectorXd> rest;  // u of each specimen if all entries add zero [SI]
};

/// Contributions of the entries of x to the coordinates, at several points.
struct EntryMotion {
  SimdRows x;                      // points [1] (entries of x, points)
  SimdRows y;                      // contribution of each entry [SI] (coordinate entries, points)
  SimdRows by_x;                   // dy/dx [SI] (coordinate entries, points)
  SimdRows by_log_specimen_scale;  // dy/d log k [SI]; empty without specimen_scales (coordinate
                                   // entries, points)
  SimdRows
      by_centre;  // dy/dy of the centre [1]; empty without centres (coordinate entries, points)
  Eigen::MatrixXd log_noise;       // logarithm of the noise factors [1] (experiments, points)
  Eigen::MatrixXd specimen_scale;  // factors k [1] (kinds, points)
};

/// Computes the contributions of the entries at the points x (size, points).
[[nodiscard]] EntryMotion move_entries(const PosteriorParts& parts,
                                       const Eigen::Ref<const Eigen::MatrixXd>& x);

/// Coordinates of every specimen at every point.
struct SpecimenCoordinates {
  std::vector<Eigen::MatrixXd> u;  // coordinates of each specimen [SI] (coordinates, points)
  std::vector<char> non_finite;    // 1 for each point at which u was not finite and was set to zero
};
/// Adds the contributions of the entries to the coordinates of every specimen.
[[nodiscard]] SpecimenCoordinates displace_specimens(const PosteriorParts& parts,
                                                     const EntryMotion& motion);

/// Computes the log prior of the points, and its gradient by x if `gradient` has columns.
void set_prior(const PosteriorParts& parts, const EntryMotion& motion, Eigen::VectorXd& log_prior,
               Eigen::MatrixXd& gradient);

}  // namespace internal

struct HandPosterior::Parts : internal::PosteriorParts {};

}  // namespace thenar
