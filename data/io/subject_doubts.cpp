#include "data/io/subject_doubts.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/units.h"

namespace thenar {
namespace {

constexpr double kShortestDigit = 0.015, kLongestDigit = 0.5;  // [m]
constexpr double kNarrowestRange = 4 * kPi / 180;              // [rad]
constexpr double kShortestArm = 1e-4, kLongestArm = 0.1;       // [m]
constexpr double kFurthestPoint = 1;                           // from its neighbour [m]
constexpr double kLargestForce = 5e3;                          // [N]

const char* const kMillimetres = "are its numbers millimetres, as they are read?";

/// The joints between the base and a segment.
std::vector<const JointAxis*> joints_to(const Subject& subject, std::string segment) {
  std::vector<const JointAxis*> found;
  for (auto joint = subject.joints.rbegin(); joint != subject.joints.rend(); ++joint)
    if (joint->child == segment) {
      found.push_back(&*joint);
      segment = joint->parent;
    }
  return found;
}

void doubt_digits(const Subject& subject, std::vector<std::string>& doubts) {
  for (const Digit& digit : subject.digits) {
    double reach = 0;
    for (const JointAxis* joint : joints_to(subject, digit.tip_segment))
      reach = std::max(reach, (digit.tip - joint->point).cross(joint->direction).norm());
    if (reach > 0 && (reach < kShortestDigit || reach > kLongestDigit))
      doubts.push_back(fmt::format("the tip of digit '{}' is {:.3g} mm from its furthest axis: {}",
                                   digit.name, 1e3 * reach, kMillimetres));
  }
}

void doubt_joints(const Subject& subject, std::vector<std::string>& doubts) {
  for (const JointAxis& joint : subject.joints) {
    const double range = joint.upper - joint.lower;
    if (!joint.coupling && range > 0 && range < kNarrowestRange)
      doubts.push_back(
          fmt::format("joint '{}' turns by {:.3g} degrees alone: are its limits degrees, as they "
                      "are read?",
                      joint.name, degrees(range)));
  }
}

void doubt_strands(const Subject& subject, std::vector<std::string>& doubts) {
  for (const Strand& strand : subject.strands) {
    // The longest arm, and the longest run between two points.
    double arm = 0, run = 0;
    for (const auto& [joint, length] : strand.arms) arm = std::max(arm, std::abs(length));
    for (std::size_t i = 1; i < strand.path.size(); ++i)
      run = std::max(run, (strand.path[i].p - strand.path[i - 1].p).norm());
    if (arm > 0 && (arm < kShortestArm || arm > kLongestArm))
      doubts.push_back(fmt::format("the longest moment arm of strand '{}' is {:.3g} mm: {}",
                                   strand.name, 1e3 * arm, kMillimetres));
    if (run > kFurthestPoint)
      doubts.push_back(fmt::format("two points of strand '{}' are {:.3g} mm apart: {}", strand.name,
                                   1e3 * run, kMillimetres));
  }
}

}  // namespace

std::vector<std::string> subject_doubts(const Subject& subject) {
  std::vector<std::string> doubts;
  doubt_digits(subject, doubts);
  doubt_joints(subject, doubts);
  doubt_strands(subject, doubts);
  for (const MuscleUnit& muscle : subject.muscles)
    if (muscle.max_force.value_or(0) > kLargestForce)
      doubts.push_back(fmt::format("muscle '{}' pulls with up to {:.3g} N: are these newtons?",
                                   muscle.name, *muscle.max_force));
  return doubts;
}

}  // namespace thenar
