#include "data/io/subject_doubts.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/lists.h"
#include "base/units.h"

namespace thenar {
namespace {

// Distance from a digit's tip to its furthest axis [m]
constexpr double kShortestDigit = 0.015, kLongestDigit = 0.5;
constexpr double kShortestLink = 0.005;            // Least length of a digit per joint [m]
constexpr double kShortestTip = 0.004;             // Least distance of a tip from its last axis [m]
constexpr double kNarrowestRange = 4 * kPi / 180;  // Least range of a joint [rad]
constexpr double kFurthestLimit = 1.5 * kPi;  // Largest limit, from the reference posture [rad]
constexpr double kMaxStiffness = 50;          // largest stiffness of a joint [N m/rad]
// Least and largest constant moment arm [m]
constexpr double kShortestArm = 1e-4, kLongestArm = 0.1;
// Distance of a path's chord from an axis [m]
constexpr double kNearestChord = 8e-4, kFurthestChord = 0.05;
constexpr double kShortestOfAll = 0.003;  // Least longest arm of a hand [m]
constexpr double kFurthestPoint = 1;  // Largest distance of a path's point from its neighbour [m]
// Largest force of a muscle: its range [N]
constexpr double kSmallestForce = 0.5, kLargestForce = 5e3;
// Mass of moved segments: the heaviest's least, and the largest [kg]
constexpr double kSmallestMass = 5e-4, kLargestMass = 1.5;
constexpr double kSmallestRadius = 1e-3, kLargestRadius = 0.15;  // Radii of skin and surfaces [m]
// Largest distance of a bone from its axis and its centre of mass [m]
constexpr double kFurthestBone = 0.08;
constexpr double kShortestFibre = 2e-3, kLongestFibre = 0.5;  // Length of a muscle's fibres [m]
constexpr double kLongestSlack = 1;  // Largest slack length of a tendon [m]
// Pennation of fibres [rad]
constexpr double kMinPennation = 0.6 * kDegree, kMaxPennation = 70 * kDegree;

const char* const kMillimetres = "are its numbers millimetres, as they are read?";

/// Appends doubts of one kind; of many only the first and their number.
void tell(const std::vector<std::string>& found, const std::string& kind,
          std::vector<std::string>& doubts) {
  constexpr std::size_t kMinCounted = 4;  // Fewest doubts of one kind that are only counted
  if (found.size() < kMinCounted) {
    append_all(doubts, found);
    return;
  }
  doubts.push_back(fmt::format("{} ({} more {} are alike)", found.front(), found.size() - 1, kind));
}

double distance_to_axis(const Eigen::Vector3d& point, const JointAxis& joint) {
  return (point - joint.point).cross(joint.direction).norm();
}

/// Returns the distances of a digit's tip from its axes, the last first, without axes that point
/// along its last bone [m].
std::vector<double> levers_of(const Subject& subject, const Digit& digit) {
  // Largest cosine of the angle between an axis and the bone [1]
  constexpr double kMaxBoneCosine = 0.7;
  std::vector<double> levers;
  for (const JointAxis* joint : joints_to(subject, digit.tip_segment))
    if (std::abs(joint->direction.dot(digit.proximal)) < kMaxBoneCosine)
      levers.push_back(distance_to_axis(digit.tip, *joint));
  return levers;
}

void doubt_digits(const Subject& subject, std::vector<std::string>& doubts) {
  for (const Digit& digit : subject.digits) {
    const std::vector<const JointAxis*> joints = joints_to(subject, digit.tip_segment);
    double reach = 0;
    for (const JointAxis* joint : joints)
      reach = std::max(reach, distance_to_axis(digit.tip, *joint));
    // A whole hand of another unit.
    const double least =
        std::max(kShortestDigit, kShortestLink * static_cast<double>(joints.size()));
    if (reach > 0 && (reach < least || reach > kLongestDigit)) {
      doubts.push_back(fmt::format("the tip of digit '{}' is {:.3g} mm from its furthest axis: {}",
                                   digit.name, 1e3 * reach, kMillimetres));
      continue;
    }
    // A tip of another unit than the axes: it stands behind them, or in the last one.
    const std::vector<double> levers = levers_of(subject, digit);
    if (levers.size() < 3) continue;
    const double last = levers.front(), most = *std::max_element(levers.begin() + 1, levers.end());
    if (last > most)
      doubts.push_back(
          fmt::format("the tip of digit '{}' is nearer to all its other axes than to its last one, "
                      "{:.3g} mm away: is 'tip' of the unit of the axes?",
                      digit.name, 1e3 * last));
    else if (last < kShortestTip)
      doubts.push_back(
          fmt::format("the tip of digit '{}' is {:.3g} mm from its last axis: is 'tip' of the unit "
                      "of the axes?",
                      digit.name, 1e3 * last));
  }
}

bool is_narrow(const JointAxis& joint) {
  const double range = joint.upper - joint.lower;
  return !joint.coupling && range > 0 && range < kNarrowestRange;
}

/// Returns whether most joints with a stated range have a narrow one, as where radians stand for
/// degrees.
bool most_are_narrow(const Subject& subject) {
  int stated = 0, narrow = 0;
  for (const JointAxis& joint : subject.joints) {
    if (joint.coupling || joint.upper - joint.lower > 2 * kPi - 1e-9) continue;
    ++stated;
    narrow += is_narrow(joint) ? 1 : 0;
  }
  return 2 * narrow > stated;
}

void doubt_joints(const Subject& subject, std::vector<std::string>& doubts) {
  const bool most_narrow = most_are_narrow(subject);
  std::vector<std::string> narrow, far, stiff;
  for (const JointAxis& joint : subject.joints) {
    // One joint among others that hardly turns either way is held on purpose.
    const bool held = !most_narrow && std::abs(joint.lower + joint.upper) < 1e-9;
    if (is_narrow(joint) && !held)
      narrow.push_back(
          fmt::format("joint '{}' turns by {:.3g} degrees alone: are its limits degrees, as they "
                      "are read?",
                      joint.name, degrees(joint.upper - joint.lower)));
    if (std::max(-joint.lower, joint.upper) > kFurthestLimit)
      far.push_back(
          fmt::format("joint '{}' turns from {:.0f} to {:.0f} degrees: are its limits of the unit "
                      "that its key names?",
                      joint.name, degrees(joint.lower), degrees(joint.upper)));
    if (joint.stiffness > kMaxStiffness)
      stiff.push_back(
          fmt::format("joint '{}' has a stiffness of {:.3g} N m/rad: is it of the unit "
                      "that its key names?",
                      joint.name, joint.stiffness));
  }
  for (const auto& found : {narrow, far, stiff}) tell(found, "joints", doubts);
}

/// Returns the distance from an axis at which the straight line between two points passes it [m].
double distance_to_axis(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                        const JointAxis& joint) {
  const auto across = [&](const Eigen::Vector3d& v) -> Eigen::Vector3d {
    return v - v.dot(joint.direction) * joint.direction;
  };
  const Eigen::Vector3d start = across(from - joint.point), way = across(to - from);
  const double squared = way.squaredNorm();
  const double along = squared > 0 ? std::clamp(-start.dot(way) / squared, 0.0, 1.0) : 0;
  return (start + along * way).norm();
}

/// The largest distance of a strand's path from an axis that it crosses, and which that is.
struct ChordDistance {
  double distance = 0;               // [m]
  const JointAxis* joint = nullptr;  // null: it crosses none
};

ChordDistance largest_chord_distance(const Subject& subject, const Strand& strand) {
  ChordDistance found;
  for (std::size_t i = 1; i < strand.path.size(); ++i) {
    const PathPoint &from = strand.path[i - 1], &to = strand.path[i];
    const std::vector<const JointAxis*> below = joints_to(subject, from.segment),
                                        above = joints_to(subject, to.segment);

    for (const JointAxis& joint : subject.joints) {
      if (contains(below, &joint) == contains(above, &joint)) continue;
      const double distance = distance_to_axis(from.p, to.p, joint);
      if (found.joint != nullptr && distance <= found.distance) continue;
      found = {distance, &joint};
    }
  }
  return found;
}

void doubt_strands(const Subject& subject, std::vector<std::string>& doubts) {
  std::vector<std::string> arms, paths;
  double longest = 0, furthest = 0;  // arm, and distance from an axis, of all strands [m]
  for (const Strand& strand : subject.strands) {
    double arm = 0, run = 0;  // the longest, and the longest between two points [m]
    for (const auto& [joint, length] : strand.arms) arm = std::max(arm, std::abs(length));
    for (std::size_t i = 1; i < strand.path.size(); ++i)
      run = std::max(run, (strand.path[i].p - strand.path[i - 1].p).norm());
    const ChordDistance chord = largest_chord_distance(subject, strand);
    longest = std::max(longest, arm);
    furthest = std::max(furthest, chord.distance);
    if (arm > 0 && (arm < kShortestArm || arm > kLongestArm))
      arms.push_back(fmt::format("the longest moment arm of strand '{}' is {:.3g} mm: {}",
                                 strand.name, 1e3 * arm, kMillimetres));
    if (run > kFurthestPoint)
      paths.push_back(fmt::format("two points of strand '{}' are {:.3g} mm apart: {}", strand.name,
                                  1e3 * run, kMillimetres));
    else if (chord.joint != nullptr &&
             (chord.distance < kNearestChord || chord.distance > kFurthestChord))
      paths.push_back(fmt::format("strand '{}' passes the axis of joint '{}' {:.3g} mm away{}: {}",
                                  strand.name, chord.joint->name, 1e3 * chord.distance,
                                  chord.distance < kNearestChord ? ", and no axis further" : "",
                                  kMillimetres));
  }
  // Each may be of a small hand, all together not.
  if (arms.empty() && longest > 0 && longest < kShortestOfAll)
    arms.push_back(fmt::format("the longest moment arm of all strands is {:.3g} mm: {}",
                               1e3 * longest, kMillimetres));
  if (paths.empty() && furthest > 0 && furthest < kShortestOfAll)
    paths.push_back(fmt::format("all strands pass the axes within {:.3g} mm: {}", 1e3 * furthest,
                                kMillimetres));
  for (const auto& found : {arms, paths}) tell(found, "strands", doubts);
}

void doubt_muscles(const Subject& subject, std::vector<std::string>& doubts) {
  std::vector<std::string> forces, lengths, angles;
  double least = INFINITY, most = 0;  // of the pennations that are not 0 [rad]
  for (const MuscleUnit& muscle : subject.muscles) {
    const double force = muscle.max_force.value_or(0), fibre = muscle.fibre_length;
    if (force > 0 && (force < kSmallestForce || force > kLargestForce))
      forces.push_back(fmt::format("muscle '{}' pulls with up to {:.3g} N: are these newtons?",
                                   muscle.name, force));
    if (fibre > 0 && (fibre < kShortestFibre || fibre > kLongestFibre))
      lengths.push_back(
          fmt::format("muscle '{}' has fibres of {:.3g} mm: are they of the unit that "
                      "their key names?",
                      muscle.name, 1e3 * fibre));
    if (muscle.tendon_slack > kLongestSlack)
      lengths.push_back(
          fmt::format("the tendon of muscle '{}' is {:.3g} mm long: is it of the unit "
                      "that its key names?",
                      muscle.name, 1e3 * muscle.tendon_slack));
    if (muscle.pennation <= 0) continue;
    least = std::min(least, muscle.pennation);
    most = std::max(most, muscle.pennation);
  }
  if (most > kMaxPennation || (most > 0 && most < kMinPennation))
    angles.push_back(
        fmt::format("pennations are from {:.3g} to {:.3g} degrees: are they of the unit "
                    "that their keys name?",
                    degrees(least), degrees(most)));
  for (const auto& found : {forces, lengths, angles}) tell(found, "muscles", doubts);
}

/// Masses of segments that joints move: one may be too heavy for itself, light ones only if all
/// are, as models have links of nearly no mass between axes.
void doubt_masses(const Subject& subject, std::vector<std::string>& doubts) {
  std::vector<std::string> heavy;
  const Segment* heaviest = nullptr;
  for (const Segment& segment : subject.segments) {
    if (segment.mass <= 0 || segment.name == subject.base) continue;
    if (heaviest == nullptr || segment.mass > heaviest->mass) heaviest = &segment;
    if (segment.mass > kLargestMass)
      heavy.push_back(
          fmt::format("segment '{}' weighs {:.3g} g: is its mass of the unit that its "
                      "key names?",
                      segment.name, 1e3 * segment.mass));
  }
  tell(heavy, "segments", doubts);
  if (heaviest != nullptr && heaviest->mass < kSmallestMass)
    doubts.push_back(
        fmt::format("the heaviest segment that moves, '{}', weighs {:.3g} g: are masses "
                    "of the unit that their keys name?",
                    heaviest->name, 1e3 * heaviest->mass));
}

/// Bones that stand elsewhere than their axes or their mass, and radii that no finger has.
void doubt_bones(const Subject& subject, std::vector<std::string>& doubts) {
  std::vector<std::string> places, radii;
  for (const Segment& segment : subject.segments) {
    if (segment.radius > 0 && (segment.radius < kSmallestRadius || segment.radius > kLargestRadius))
      radii.push_back(fmt::format("the skin of segment '{}' has a radius of {:.3g} mm: {}",
                                  segment.name, 1e3 * segment.radius, kMillimetres));
    if (segment.proximal == segment.distal || segment.name == subject.base) continue;
    const Eigen::Vector3d &proximal = segment.proximal, &distal = segment.distal;
    for (const JointAxis& joint : subject.joints)
      if (joint.child == segment.name && distance_to_axis(proximal, distal, joint) > kFurthestBone)
        places.push_back(
            fmt::format("segment '{}' is {:.3g} mm away from the axis of its joint "
                        "'{}': {}",
                        segment.name, 1e3 * distance_to_axis(proximal, distal, joint), joint.name,
                        kMillimetres));
    const double off =
        std::min((segment.com - segment.proximal).norm(), (segment.com - segment.distal).norm());
    if (segment.mass > 0 &&
        off > std::max(kFurthestBone, (segment.distal - segment.proximal).norm()))
      places.push_back(
          fmt::format("the centre of mass of segment '{}' is {:.3g} mm away from its "
                      "ends: {}",
                      segment.name, 1e3 * off, kMillimetres));
  }
  for (const Surface& surface : subject.surfaces) {
    const double size = surface.size.maxCoeff();
    if (size < kSmallestRadius || surface.size[0] > kLargestRadius)
      radii.push_back(fmt::format("surface '{}' has a radius of {:.3g} mm: {}", surface.name,
                                  1e3 * surface.size[0], kMillimetres));
  }
  tell(places, "segments", doubts);
  tell(radii, "radii", doubts);
}

}  // namespace

std::vector<std::string> subject_doubts(const Subject& subject) {
  std::vector<std::string> doubts;
  doubt_digits(subject, doubts);
  // Of no use where axes and tips are wrong already.
  if (doubts.empty()) doubt_bones(subject, doubts);
  doubt_joints(subject, doubts);
  doubt_strands(subject, doubts);
  doubt_muscles(subject, doubts);
  doubt_masses(subject, doubts);
  return doubts;
}

}  // namespace thenar
