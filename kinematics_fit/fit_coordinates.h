#pragma once

/// Whitened coordinates of a fit: which entries of z move which parameter of which specimen.

#include <limits>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "kinematics_fit/model/fit_parameters.h"

namespace thenar {

/// Index that denotes the population instead of a specimen.
inline constexpr int kPopulation = -1;

/// Entries of z that move one coordinate of every specimen:
///   u = p + deviation_sd d,   p = population_sd z[population],
/// with d computed from x = z[deviation + specimen * deviations]. Without bounds of the sum, d = x;
/// with bounds, d = Z(x; l, h), the map of BoundedNormal with l = (lower - p) / deviation_sd and h
/// = (upper - p) / deviation_sd, so that every specimen satisfies the bounds of its parameter. An
/// entry of -1 contributes nothing.
struct CoordinateEntries {
  int population = -1;       // index of the population's entry of z; -1: none
  double population_sd = 0;  // prior sd of the population [SI]
  int deviation = -1;        // index of the entry of z of specimen 0; -1: none
  double deviation_sd = 0;   // sd between specimens [SI]
  // Bounds of the sum u if both entries exist; infinite if not bounded [SI].
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
};

/// Layout, bounds and names of z: the population's entries, then each specimen's deviations from
/// the population. The prior of every entry is N(0, 1).
///
/// The data of a single specimen cannot separate its deviation from the population's value. In that
/// case z holds only their sum, whose prior variances add; the most probable share of the
/// population is sd^2 / (sd^2 + between^2). Bounds of a parameter apply to the population and to
/// every specimen: as bounds of z if a single entry moves a coordinate, and by the map of
/// CoordinateEntries if two entries do. Tilts of axes are bounded for the population only.
class FitCoordinates {
 public:
  /// @param specimens  names of all specimens, without duplicates
  FitCoordinates(FitParameters parameters, std::vector<std::string> specimens);

  [[nodiscard]] int size() const {
    return static_cast<int>(lower_.size());
  }                                                                      // number of entries of z
  [[nodiscard]] const Eigen::VectorXd& lower() const { return lower_; }  // bounds of z [1] (size)
  [[nodiscard]] const Eigen::VectorXd& upper() const { return upper_; }  // bounds of z [1] (size)

  /// Returns the name of every entry of z: the leading parameter, with "specimen: " before
  /// deviations.
  [[nodiscard]] std::vector<std::string> names() const;

  /// Return the entries of z of coordinate c, and the number of entries of the population and of
  /// each specimen.
  [[nodiscard]] const CoordinateEntries& entries(int c) const { return entries_.at(c); }
  [[nodiscard]] int population_entries() const { return population_size_; }
  [[nodiscard]] int deviations() const { return deviation_size_; }

  /// Returns the entries of z that move a specimen (or kPopulation); no other entry affects it.
  [[nodiscard]] std::vector<int> entries_of_specimen(int specimen) const;

  /// Returns the share of coordinate c that belongs to the population; below 1 only for a single
  /// specimen [1].
  [[nodiscard]] double population_share(int c) const { return population_share_[c]; }

  [[nodiscard]] const FitParameters& parameters() const { return parameters_; }
  [[nodiscard]] const std::vector<std::string>& specimens() const { return specimens_; }

 private:
  void list_entries();
  void bound_coordinates();
  [[nodiscard]] const Parameter& leader(int c) const {
    return parameters_.all[parameters_.leader[c]];
  }

  FitParameters parameters_;
  std::vector<std::string> specimens_;
  std::vector<CoordinateEntries> entries_;  // (coordinates)
  Eigen::VectorXd population_share_;        // [1] (coordinates)
  int population_size_ = 0, deviation_size_ = 0;
  Eigen::VectorXd lower_, upper_;  // bounds of z [1] (size)
};

/// Returns "hood/UI/slope" for "H01: hood/UI/slope", the name of an entry of one specimen.
[[nodiscard]] std::string without_specimen(const std::string& entry);

}  // namespace thenar
