#include "kinematics_fit/hood_rows.h"

#include <algorithm>

#include "base/lists.h"
#include "tendons/net/build_net.h"

namespace thenar {
namespace {

bool all_zero(const std::vector<PredictedTrial>& trials) {
  return all_of(trials, [](const PredictedTrial& trial) { return trial.measured.isZero(0); });
}

}  // namespace

std::vector<std::string> hood_muscles(const TendonDigit& digit) {
  std::vector<int> found;
  if (digit.model.hood)
    for (const HoodShare<double>& share : digit.model.hood_shares) found.push_back(share.muscle);
  if (digit.net)
    for (const NetMuscle& muscle : digit.net->muscles) found.push_back(muscle.muscle);
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return transformed(found, [&](const int m) { return digit.names.muscles[m]; });
}

std::optional<HoodRowErrors> hood_row_errors(const Prediction& prediction,
                                             const std::vector<std::string>& muscles) {
  // Select the trials of hood muscles, in the order in which muscles first appear.
  std::vector<std::string> order;
  std::vector<PredictedTrial> all;
  for (const PredictedTrial& trial : prediction.trials) {
    if (!contains(muscles, trial.loads)) continue;
    if (!contains(order, trial.loads)) order.push_back(trial.loads);
    all.push_back(trial);
  }
  if (all_zero(all)) return {};
  HoodRowErrors out{{}, force_error(all)};
  // Add the errors of each muscle.
  for (const std::string& muscle : order) {
    std::vector<PredictedTrial> alone;
    for (const PredictedTrial& trial : all)
      if (trial.loads == muscle) alone.push_back(trial);
    if (!all_zero(alone)) out.muscles.push_back({muscle, force_error(alone)});
  }
  return out;
}

HoodCount count_hood(const Covariance& covariance) {
  HoodCount count;
  for (const CoordinateEstimate& learnt : covariance.learnt) {
    const std::string name = without_specimen(learnt.name);
    if (name.rfind("hood/", 0) != 0 && name.rfind("net/", 0) != 0) continue;
    ++count.entries;
    count.effective += 1 - learnt.sd * learnt.sd;
  }
  return count;
}

}  // namespace thenar
