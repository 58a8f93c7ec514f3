#pragma once

/// How the entries of a posterior's x move the coordinates of a fit.

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "posterior/bounded_table.h"
#include "posterior/gauge.h"

namespace thenar {

/// One entry of x that stands for one of z: it adds to coordinate c of one or all specimens
///   k sd z(x; lower / k, upper / k),    k the specimen_scale factor of its kind, or 1;
/// a specimen's whose sum with its population is bounded adds specimen_deviation().
struct CoordinateEntry {
  int z;                                      // entry of z
  int coordinate;                             // of u
  int specimen;                               // -1: the population, so all
  double sd;                                  // [SI]
  double lower, upper;                        // of z; infinite if not bounded [1]
  std::shared_ptr<const BoundedTable> table;  // of their map where they are fixed and not too far;
                                              // shared by entries of the same bounds
  int specimen_scale = -1;                    // index of the specimen_scale factor; -1: none
  int centre = -1;  // entry of x of the population that bounds count from; -1: none

  /// The map of bounds, where the specimen_scale factor is k; absent: z = x.
  [[nodiscard]] std::optional<BoundedNormal> bounds(double k) const;
};

/// Both tilts of an axis, of the population or of a specimen, with a von Mises-Fisher prior.
struct TiltPair {
  int x[2];             // entries of the tilts
  int centre[2];        // entries of the population's; -1: it has none, and stays at the mean
  double mean[2];       // prior mean of the population [rad]
  double log_constant;  // of its density without specimen_scale, over that of normal tilts [1]
};

/// x: entries of z in their order, then noise factors, then specimen_scale factors.
struct PosteriorEntries {
  std::vector<CoordinateEntry> coordinates;
  std::vector<Gauge> gauges;                   // what x leaves out
  std::vector<int> fixed;                      // entries of z whose bounds leave them no room
  std::vector<TiltPair> tilts;                 // populations first
  std::vector<ParameterKind> specimen_scales;  // of each specimen_scale factor
  int noise_scales = 0;                        // number of noise factors, of experiments in turn

  /// Does any entry count its bounds from another?
  [[nodiscard]] bool has_centres() const {
    return std::any_of(coordinates.begin(), coordinates.end(),
                       [](const CoordinateEntry& entry) { return entry.centre >= 0; });
  }
  [[nodiscard]] int noise_scale_offset() const { return static_cast<int>(coordinates.size()); }
  [[nodiscard]] int specimen_scale_offset() const { return noise_scale_offset() + noise_scales; }
  [[nodiscard]] int size() const {
    return specimen_scale_offset() + static_cast<int>(specimen_scales.size());
  }
};

[[nodiscard]] PosteriorEntries list_entries(const FitProblem& problem, bool learn_noise,
                                            bool learn_specimen_scale, bool sphere_priors);

}  // namespace thenar
