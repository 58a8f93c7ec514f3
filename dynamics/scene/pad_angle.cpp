#include "dynamics/scene/pad_angle.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace thenar {
namespace {

/// Returns the sum of the normal forces of one body on another at an instant [N] (3).
Eigen::Vector3d pressing_force(const SceneSample& sample, int body, int other) {
  Eigen::Vector3d sum(0, 0, 0);
  for (const ContactSample& contact : sample.contacts) {
    if (contact.a != std::min(body, other) || contact.b != std::max(body, other)) continue;
    // A sample holds the force on body a.
    const Eigen::Vector3d on_a = contact.force.dot(contact.normal) * contact.normal;
    sum += contact.a == other ? on_a : Eigen::Vector3d(-on_a);
  }
  return sum;
}

}  // namespace

std::vector<PadState> pad_angles(const SceneRun& run, const RunMeasures& measures, int body,
                                 int other, const Eigen::Vector3d& outward) {
  require(run.samples.size() == measures.X_WB.size(), "{} instants have {} measures",
          run.samples.size(), measures.X_WB.size());
  std::vector<PadState> out;
  // Compare the pad's normal with the force at every instant that has one.
  for (std::size_t i = 0; i < run.samples.size(); ++i) {
    const auto bodies = static_cast<int>(measures.X_WB[i].size());
    require(std::min(body, other) >= 0 && std::max(body, other) < bodies,
            "there are no bodies {} and {}, there are {}", body, other, bodies);
    const Eigen::Vector3d force = pressing_force(run.samples[i], body, other);
    if (force.isZero(0)) continue;
    const Eigen::Vector3d pad = measures.X_WB[i][body].R * outward;
    out.push_back({run.samples[i].t, force.norm(),
                   std::acos(std::clamp(pad.dot(force.normalized()), -1.0, 1.0))});
  }
  return out;
}

}  // namespace thenar
