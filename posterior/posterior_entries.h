#pragma once

/// Entries of a posterior's x, and the fit coordinates that each of them moves.

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "posterior/bounded_table.h"
#include "posterior/gauge.h"
#include "posterior/posterior_options.h"

namespace thenar {

/// Entry of x that represents one entry of z. It adds to coordinate c of one or all specimens
///   k sd z(x; lower / k, upper / k),    k the specimen_scale factor of its kind, or 1.
/// An entry of a specimen whose sum with the population is bounded adds specimen_deviation().
struct CoordinateEntry {
  int z = 0;                    // index of the entry of z
  int coordinate = 0;           // index of the coordinate of u
  int specimen = 0;             // index of the specimen, or kPopulation: all specimens
  double sd = 0;                // prior sd of the coordinate [SI]
  double lower = 0, upper = 0;  // bounds of z; infinite if not bounded [1]
  std::shared_ptr<const BoundedTable> table;  // table of the map, if the bounds are constant and
                                              // near enough; shared by entries of equal bounds
  int specimen_scale = -1;                    // index of the specimen_scale factor; -1: none
  int centre = -1;  // entry of x of the population relative to which the bounds hold; -1: none

  /// Returns the map of the bounds for a specimen_scale factor k; none: z = x.
  [[nodiscard]] std::optional<BoundedNormal> bounds(double k) const;
};

/// Both tilts of an axis, of the population or of a specimen, with a von Mises-Fisher prior.
struct TiltPair {
  int x[2]{};       // entries of the tilts
  int centre[2]{};  // entries of the population's tilts; -1: none, the population stays at the mean
  double mean[2]{};         // prior mean of the population [rad]
  double log_constant = 0;  // logarithm of the density's constant over that of normal tilts,
                            // without specimen_scale [1]
};

/// Layout of x: entries of z in their order, then noise factors, then specimen_scale factors.
struct PosteriorEntries {
  std::vector<CoordinateEntry> coordinates;
  std::vector<Gauge> gauges;                   // shifts along axes, which x leaves out
  std::vector<int> fixed;                      // entries of z between equal bounds
  std::vector<TiltPair> tilts;                 // pairs of tilts, populations first
  std::vector<ParameterKind> specimen_scales;  // parameter kind of each specimen_scale factor
  int noise_scales = 0;                        // number of noise factors, one per experiment

  /// Returns whether any entry has a centre.
  [[nodiscard]] bool has_centres() const {
    return std::any_of(coordinates.begin(), coordinates.end(),
                       [](const CoordinateEntry& entry) { return entry.centre >= 0; });
  }
  /// Return the index of the first noise factor, of the first specimen_scale factor, and the size
  /// of x.
  [[nodiscard]] int noise_scale_offset() const { return static_cast<int>(coordinates.size()); }
  [[nodiscard]] int specimen_scale_offset() const { return noise_scale_offset() + noise_scales; }
  [[nodiscard]] int size() const {
    return specimen_scale_offset() + static_cast<int>(specimen_scales.size());
  }
};

/// Lists the entries of x of a problem, with the factors and sphere priors that the options
/// request.
[[nodiscard]] PosteriorEntries list_entries(const FitProblem& problem,
                                            const PosteriorOptions& options);

}  // namespace thenar
