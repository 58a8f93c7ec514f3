#include "dynamics/stepping/energy_balance.h"

#include <algorithm>
#include <cmath>

#include "dynamics/stepping/energy_flow.h"

namespace thenar {
namespace {

constexpr double kRoundingShare =
    1e-6;  // error that counts as rounding over turned-over energy [1]

/// Computes the work of elements that are not passive on scene and springs: work on the scene plus
/// the increase of their stored energy, which the balance counts as energy [J].
double work_of_elements(const SceneSample& first, const SceneSample& last) {
  if (last.z.size() == 0) return 0;
  const Eigen::Index work = last.z.size() - 1;
  return last.z[work] - first.z[work] + last.energy.of_elements - first.energy.of_elements;
}

}  // namespace

double FlowBalance::relative_error() const {
  return std::abs(error) / (turned_over + kEnergyErrorFloor / kMaxEnergyErrorRatio);
}

FlowBalance flow_balance(const SceneSample& first, const SceneSample& last) {
  FlowBalance out;
  const EnergyFlows flows = last.w - first.w;
  out.t = last.t;
  out.work = flows[kAppliedWork] + work_of_elements(first, last);
  out.friction = flows[kFrictionLoss];
  out.impacts = flows[kImpactLoss];
  // Passive elements dissipate the energy that they receive and do not store.
  const double stored = last.energy.of_passive - first.energy.of_passive;
  out.yielding = flows[kDamperLoss] - flows[kPassiveWork] - stored;
  out.error = first.energy.total() + out.work - out.dissipated() - last.energy.total();
  const double kinetic = std::max({first.energy.kinetic, last.energy.kinetic, last.w[kMaxKinetic]});
  // Ignore negative losses, which are rounding in a scene at rest.
  const auto lost = [](double loss) { return std::max(0.0, loss); };
  out.turned_over =
      kinetic + flows[kWorkMagnitude] + lost(out.friction) + lost(out.impacts) + lost(out.yielding);
  return out;
}

FlowBalance worst_balance(const std::vector<SceneSample>& samples) {
  const FlowBalance end = flow_balance(samples.front(), samples.back());
  FlowBalance worst = end;
  // Find the largest error; errors below rounding do not replace the last instant.
  for (const SceneSample& sample : samples) {
    const FlowBalance here = flow_balance(samples.front(), sample);
    const double known = std::max(std::abs(worst.error), kRoundingShare * end.turned_over);
    if (!(std::abs(here.error) <= known)) worst = here;
  }
  worst.turned_over = end.turned_over;
  return worst;
}

}  // namespace thenar
