#include "kinematics_fit/trivial_prediction.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"

namespace thenar {
namespace {

/// Tensions of the muscles that pull [N].
std::map<std::string, double> pulls_of(const Trial& trial) {
  std::map<std::string, double> pulls;
  for (const auto& [muscle, tension] : trial.tension)
    if (tension > 0) pulls[muscle] = tension;
  return pulls;
}

double total(const std::map<std::string, double>& pulls) {
  double sum = 0;
  for (const auto& [muscle, tension] : pulls) sum += tension;
  return sum;
}

/// Whether the same muscles pull in the same proportion.
bool same_loads(const std::map<std::string, double>& a, const std::map<std::string, double>& b) {
  constexpr double kSame = 0.1;  // of each muscle's own share [1]
  if (a.size() != b.size() || a.empty()) return false;
  const double total_a = total(a), total_b = total(b);
  return std::equal(a.begin(), a.end(), b.begin(), [&](const auto& one, const auto& other) {
    const double share = one.second / total_a;
    return one.first == other.first && std::abs(other.second / total_b - share) <= kSame * share;
  });
}

const PostureRecord* posture_of(const Experiment& experiment, const std::string& name) {
  const auto& all = experiment.postures;
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.name == name; });
  return found == all.end() ? nullptr : &*found;
}

double angle_of(const PostureRecord& posture, const std::string& joint) {
  const auto found = posture.angles.find(joint);
  return found == posture.angles.end() ? 0 : found->second;
}

/// Whether all joints stand alike; a joint that one of the two does not name is at 0 there.
bool same_posture(const PostureRecord* a, const PostureRecord* b) {
  const double kSame = radians(2);
  if (a == nullptr || b == nullptr) return false;
  const auto alike = [&](const auto& joint) {
    return std::abs(angle_of(*a, joint.first) - angle_of(*b, joint.first)) <= kSame;
  };
  return std::all_of(a->angles.begin(), a->angles.end(), alike) &&
         std::all_of(b->angles.begin(), b->angles.end(), alike);
}

/// Sum and number of forces per tension, in axes of the digit.
struct MeanForce {
  Eigen::Vector3d sum{0, 0, 0};  // [1] (3)
  int count = 0;                 // [1]

  void add(const Eigen::Vector3d& force) {
    sum += force;
    ++count;
  }
};

}  // namespace

std::optional<Eigen::Vector3d> trivial_force(const Experiment& experiment, const Trial& trial,
                                             const std::vector<Experiment>& seen) {
  const std::map<std::string, double> pulls = pulls_of(trial);
  const PostureRecord* posture = posture_of(experiment, trial.posture);
  // The same loads: at this posture, at others of the same specimen, anywhere.
  MeanForce here, own, all;
  for (const Experiment& other : seen) {
    if (other.components < experiment.components || other.digit != experiment.digit) continue;
    for (const Trial& row : other.trials) {
      const std::map<std::string, double> others = pulls_of(row);
      if (!same_loads(pulls, others)) continue;
      const Eigen::Vector3d force =
          other.axes_of_digit.cast<double>().transpose() * row.force / total(others);
      if (same_posture(posture, posture_of(other, row.posture))) here.add(force);
      if (other.specimen == experiment.specimen) own.add(force);
      all.add(force);
    }
  }
  // The nearest of the three that there is.
  for (const MeanForce& mean : {here, own, all})
    if (mean.count > 0)
      return experiment.axes_of_digit.cast<double>() * mean.sum * (total(pulls) / mean.count);
  return std::nullopt;
}

std::optional<BesideTrivial> beside_trivial(const Prediction& prediction) {
  std::vector<PredictedTrial> model, trivial;
  bool measured = false;
  for (const PredictedTrial& trial : prediction.trials) {
    if (!trial.trivial) continue;
    measured = measured || trial.measured.squaredNorm() > 0;
    model.push_back(trial);
    trivial.push_back(trial);
    trivial.back().predicted = *trial.trivial;
    trivial.back().sd.setZero();
  }
  if (!measured) return std::nullopt;
  return BesideTrivial{force_error(model), force_error(trivial)};
}

std::vector<ErrorsOfLoad> errors_by_load(const Prediction& prediction) {
  std::vector<ErrorsOfLoad> out;
  for (const PredictedTrial& trial : prediction.trials) {
    if (!trial.trivial) continue;
    // The load's sums, begun with its first trial.
    auto of = std::find_if(out.begin(), out.end(),
                           [&](const ErrorsOfLoad& one) { return one.loads == trial.loads; });
    const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
    if (of == out.end()) of = out.insert(of, {trial.loads, 0, zero, zero, zero});
    ++of->trials;
    of->measured += trial.measured.cwiseAbs2();
    of->model += (trial.predicted - trial.measured).cwiseAbs2();
    of->trivial += (*trial.trivial - trial.measured).cwiseAbs2();
  }
  for (ErrorsOfLoad& one : out)
    for (Eigen::Vector3d* sum : {&one.measured, &one.model, &one.trivial})
      *sum = (*sum / one.trials).cwiseSqrt();
  return out;
}

}  // namespace thenar
