#include "live/excited_muscles.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "base/lists.h"
#include "base/nearest_name.h"
#include "tendons/net/net_tendons.h"

namespace thenar {
namespace {

/// Computes the lengths of the muscles' lines at zero tension [m] (muscles). Lengths of tendons
/// without a net do not depend on tension.
Eigen::VectorXd whole_lengths(const DigitTendons& tendons, const Eigen::VectorXd& q) {
  const auto muscles = static_cast<Eigen::Index>(tendons.digit().names.muscles.size());
  return tendons.lengths(q, Eigen::VectorXd::Zero(muscles), {});
}

}  // namespace

ExcitedMuscles::ExcitedMuscles(const Subject& subject, std::shared_ptr<const DigitTendons> tendons)
    : tendons_(std::move(tendons)) {
  // Take lengths from the linear tendons: those of a net depend on tension.
  const auto* net = dynamic_cast<const NetTendons*>(tendons_.get());
  whole_tendons_ = net != nullptr ? &net->linear() : tendons_.get();
  // Collect the constants of the muscles.
  const TendonDigit& digit = tendons_->digit();
  for (std::size_t m = 0; m < digit.names.muscles.size(); ++m) {
    const std::string& name = digit.names.muscles[m];
    const MuscleUnit* unit = find_named(subject.muscles, name);
    require(unit != nullptr, "subject '{}' has no muscle '{}'", subject.name, name);
    muscles_.push_back(
        {name, digit.max_tension[m], unit->fibre_length, unit->tendon_slack, unit->pennation});
  }
  // Compute the reference lengths with all joints at 0, and check their reliability.
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(digit.model.coordinates);
  length_at_zero_ = whole_lengths(*whole_tendons_, zero);
  const TendonTorque pull = whole_tendons_->evaluate(
      zero, Eigen::VectorXd::Zero(static_cast<Eigen::Index>(muscles_.size())));
  if (!is_trusted(pull.status)) zero_warning_ = pull.warning;
}

Eigen::VectorXd ExcitedMuscles::lengthening(const Eigen::VectorXd& q) const {
  return whole_lengths(*whole_tendons_, q) - length_at_zero_;
}

Eigen::VectorXd ExcitedMuscles::tensions(const Eigen::VectorXd& excitation,
                                         const Eigen::VectorXd& t, const Eigen::VectorXd& q) const {
  Eigen::VectorXd held = t;
  // NaN marks a muscle with a given tension; without excited muscles there is nothing to compute.
  if (excitation.array().isNaN().all()) return held;
  const Eigen::VectorXd longer = lengthening(q);
  for (Eigen::Index m = 0; m < held.size(); ++m) {
    if (std::isnan(excitation[m])) continue;
    const Musculotendon& muscle = muscles_[m];
    require(excitation[m] >= 0 && excitation[m] <= 1,
            "wanted an excitation of '{}' from 0 to 1, got {}", muscle.name, excitation[m]);
    // Evaluate Hill's model, or excitation times F0 if the fibre length is unknown.
    require(std::isfinite(muscle.F0),
            "the largest force of muscle '{}' is unknown: set its tension instead", muscle.name);
    held[m] = muscle.optimal_fibre_length > 0
                  ? rigid_tendon_tension(muscle, {}, excitation[m],
                                         musculotendon_length_at_optimum(muscle) + longer[m], 0)
                  : excitation[m] * muscle.F0;
  }
  return held;
}

std::vector<std::string> ExcitedMuscles::warnings(const Eigen::VectorXd& excitation) const {
  // Warn about excited muscles without a force-length relation, and about unreliable lengths.
  std::vector<std::string> without, all;
  for (Eigen::Index m = 0; m < excitation.size(); ++m) {
    const Musculotendon& muscle = muscles_[m];
    if (!std::isnan(excitation[m]) && !(muscle.optimal_fibre_length > 0))
      without.push_back(muscle.name);
  }
  if (!without.empty())
    all.push_back(fmt::format(
        "the fibre length of {} is unknown: excitation times largest force, at any length",
        listed(without)));
  if (!zero_warning_.empty() && !excitation.array().isNaN().all())
    all.push_back(
        "lengths of muscles are counted from all joints at 0, where tendons are not to "
        "be trusted: " +
        zero_warning_);
  return all;
}

}  // namespace thenar
