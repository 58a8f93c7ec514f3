#include "kinematics_fit/fit_coordinates.h"

#include <cmath>
#include <numeric>

namespace thenar {

FitCoordinates::FitCoordinates(FitParameters parameters, std::vector<std::string> specimens)
    : parameters_(std::move(parameters)), specimens_(std::move(specimens)) {
  list_entries();
  bound_coordinates();
}

void FitCoordinates::list_entries() {
  const bool alone = specimens_.size() == 1;
  const int n = parameters_.coordinates();
  entries_.resize(n);
  population_share_ = Eigen::VectorXd::Ones(n);

  // Number the population's entries first; a single specimen adds its own variance to them.
  for (int c = 0; c < n; ++c) {
    const Parameter& p = leader(c);
    CoordinateEntries& coordinate = entries_[c];
    coordinate.population_sd = alone ? std::hypot(p.sd, p.between_sd) : p.sd;
    if (alone) population_share_[c] = std::pow(p.sd / coordinate.population_sd, 2);
    if (coordinate.population_sd > 0) coordinate.population = population_size_++;
  }

  // Number the deviations of each specimen, bounded so that the sum keeps the parameter's bounds.
  for (int c = 0; c < n && !alone; ++c) {
    const Parameter& p = leader(c);
    CoordinateEntries& coordinate = entries_[c];
    coordinate.deviation_sd = p.between_sd;
    if (coordinate.deviation_sd > 0) coordinate.deviation = population_size_ + deviation_size_++;
    // Leave tilts unbounded: their prior is on the sphere, and limits of its chart are not
    // anatomical.
    const bool tilt = p.kind == ParameterKind::kAxisDirection;
    if (coordinate.deviation_sd <= 0 || coordinate.population < 0 || tilt) continue;
    coordinate.lower = p.lower - p.mean;
    coordinate.upper = p.upper - p.mean;
  }
}

void FitCoordinates::bound_coordinates() {
  const int size = population_size_ + deviation_size_ * static_cast<int>(specimens_.size());
  lower_ = Eigen::VectorXd::Constant(size, -std::numeric_limits<double>::infinity());
  upper_ = -lower_;
  for (int c = 0; c < parameters_.coordinates(); ++c) {
    const Parameter& p = leader(c);
    const CoordinateEntries& coordinate = entries_[c];
    // Apply the parameter's bounds to the population.
    if (coordinate.population >= 0) {
      lower_[coordinate.population] = (p.lower - p.mean) / coordinate.population_sd;
      upper_[coordinate.population] = (p.upper - p.mean) / coordinate.population_sd;
      continue;
    }
    // Apply the bounds to each specimen's deviation where the population does not move.
    for (std::size_t s = 0; s < specimens_.size(); ++s) {
      const auto at = static_cast<int>(coordinate.deviation + s * deviation_size_);
      lower_[at] = (p.lower - p.mean) / coordinate.deviation_sd;
      upper_[at] = (p.upper - p.mean) / coordinate.deviation_sd;
    }
  }
}

std::vector<int> FitCoordinates::entries_of_specimen(int specimen) const {
  std::vector<int> entries(population_size_ + (specimen < 0 ? 0 : deviation_size_));
  std::iota(entries.begin(), entries.end(), 0);
  for (std::size_t k = population_size_; k < entries.size(); ++k)
    entries[k] += specimen * deviation_size_;
  return entries;
}

std::vector<std::string> FitCoordinates::names() const {
  // Name entries by their leaders, for all parameters tied to them.
  std::vector<std::string> names(size());
  for (int c = 0; c < parameters_.coordinates(); ++c) {
    const std::string& name = leader(c).name;
    const CoordinateEntries& coordinate = entries_[c];
    if (coordinate.population >= 0) names[coordinate.population] = name;
    for (std::size_t s = 0; s < specimens_.size() && coordinate.deviation >= 0; ++s)
      names[coordinate.deviation + s * deviation_size_] = specimens_[s] + ": " + name;
  }
  return names;
}

std::string without_specimen(const std::string& entry) {
  const std::size_t at = entry.find(": ");
  return at == std::string::npos ? entry : entry.substr(at + 2);
}

}  // namespace thenar
