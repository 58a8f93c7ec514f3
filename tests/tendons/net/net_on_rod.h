#pragma once

/// Nets beside a rod on a hinge, which they do not pull: knots in closed form.

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "tendons/linear_tendons.h"
#include "tendons/net/net_tendons.h"
#include "tests/hand/sample_subjects.h"
#include "tests/tendons/net/sample_nets.h"

namespace thenar::sample {

/// Muscles with arms of 10 mm at the rod, each with all of its tension in the net.
inline NetTendons net_on_rod(Net net) {
  Subject subject;
  subject.name = "rod";
  subject.side = "right";
  subject.base = "Base";
  subject.segments = {bone("Base", {0, 0, 0}, {0, 0, 0}, 0),
                      bone("Rod", {0, 0, 0}, {0, -0.08, 0}, 0)};
  subject.joints = {hinge("J1", "Base", "Rod", {0, 0, 1}, {0, 0, 0})};
  subject.digits = {digit("index", "Rod", {0, -0.08, 0})};
  BuiltNet built;
  for (const std::string& name : net.muscles) {
    Strand strand;
    strand.name = name;
    strand.arms = {{"J1", 0.01}};
    subject.strands.push_back(strand);
    MuscleUnit muscle;
    muscle.name = muscle.strand = name;
    muscle.max_force = 2;
    subject.muscles.push_back(muscle);
    const auto number = static_cast<int>(built.pulls.size());
    built.pulls.push_back({number, 1});
    built.muscles.push_back({number, 1, {}});
  }
  built.net = std::move(net);
  built.frame.straight = Eigen::VectorXd::Zero(1);
  return {build_linear_tendons(subject, "index"), std::move(built)};
}

/// A tendon of 1e5 N/m.
class Spring : public TensionLaw {
 public:
  static constexpr double kStiffness = 1e5;  // [N/m]
  [[nodiscard]] BandResponse response_at(double length) const override {
    return length > 0
               ? BandResponse{kStiffness * length * length / 2, kStiffness * length, kStiffness}
               : BandResponse{0, 0, 0};
  }
};

}  // namespace thenar::sample
