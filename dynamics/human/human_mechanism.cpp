#include "dynamics/human/human_mechanism.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/error.h"
#include "base/lists.h"
#include "dynamics/mechanism/build_mechanism.h"
#include "hand/skin/skin_body.h"
#include "hand_versions/human_tendons.h"
#include "tendons/muscle/joint_resistance.h"

namespace thenar {
namespace {

/// Returns the subject with all masses, and with the joint axes of the version.
Subject subject_with_masses(const HumanModel& model, std::vector<std::string>& warnings) {
  Subject subject = with_skin_masses(with_passive(model.subject, model.options.passive));
  // Warn of segments whose mass is that of their skin.
  std::vector<std::string> assumed;
  for (std::size_t i = 0; i < subject.segments.size(); ++i)
    if (subject.segments[i].mass != model.subject.segments[i].mass)
      assumed.push_back(subject.segments[i].name);
  if (!assumed.empty())
    warnings.push_back(fmt::format("mass of {} is that of their skin, {:g} kg/m^3",
                                   fmt::join(assumed, ", "), kHandDensity));
  return model.version == HumanVersion::kOrthogonalThumb ? orthogonal_thumb(std::move(subject))
                                                         : subject;
}

/// Returns the mass of all segments on the base, without the forearm.
BodyMass base_mass(const Subject& subject, const Skeleton& skeleton) {
  LinkMass sum;
  for (const Segment& segment : subject.segments) {
    const auto link = skeleton.link_of_segment.find(segment.name);
    if (link == skeleton.link_of_segment.end() || link->second >= 0) continue;
    if (segment.name == subject.base) continue;
    const LinkMass mass = displace(skeleton.segment_at.at(segment.name), segment_mass(segment));
    require(mass.segment_without_inertia.empty(),
            "segment '{}' has mass but neither moments of inertia nor a radius",
            mass.segment_without_inertia);
    sum = combine(sum, mass);
  }
  return {sum.mass, sum.com, sum.inertia};
}

/// Returns the name of the heaviest segment on a link, without the forearm; of a link without
/// segments, between two joints, the name of its joint.
std::string link_name(const Subject& subject, const Skeleton& skeleton, int link) {
  const Segment* found = nullptr;
  for (const Segment& segment : subject.segments) {
    const auto at = skeleton.link_of_segment.find(segment.name);
    if (at == skeleton.link_of_segment.end() || at->second != link) continue;
    if (segment.name == subject.base) continue;
    if (found == nullptr || segment_mass(segment).mass > segment_mass(*found).mass)
      found = &segment;
  }
  if (found != nullptr) return found->name;
  return link < 0 ? subject.base : skeleton.hinge_names[link];
}

/// Returns the mechanism with a base before all links.
Mechanism prepend_base(const Mechanism& links, const BodyMass& mass) {
  Mechanism out;
  // Weld the base to the world.
  out.coordinates = links.coordinates;
  out.joints.push_back({"base", JointKind::kWeld});
  out.bodies.push_back({"base", mass, {}, {}});
  // Append the links; the indices of their parents increase by one.
  for (std::size_t i = 0; i < links.bodies.size(); ++i) {
    out.joints.push_back(links.joints[i]);
    ++out.joints.back().parent;
    out.bodies.push_back(links.bodies[i]);
  }
  return out;
}

/// Names all bodies and adds their skins.
void add_skins(const Subject& subject, const Skeleton& skeleton,
               const std::vector<LinkSurface>& surfaces, Mechanism& mechanism) {
  const int links = static_cast<int>(skeleton.tree.size());
  for (int link = -1; link < links; ++link) {
    const int body = link + 1;
    mechanism.bodies[body].name = link_name(subject, skeleton, link);
    // The first surface belongs to the body itself; further ones are bodies welded to it.
    bool has_skin = false;
    for (const LinkSurface& surface : surfaces) {
      if (surface.link != link) continue;
      MechanismBody skin{surface.name,
                         {0, {0, 0, 0}, Eigen::Matrix3d::Zero()},
                         surface.solid,
                         surface.material,
                         surface.digit};
      if (!has_skin) {
        skin.mass = mechanism.bodies[body].mass;
        mechanism.bodies[body] = std::move(skin);
      } else {
        mechanism.joints.push_back({surface.name + " skin", JointKind::kWeld, body});
        mechanism.bodies.push_back(std::move(skin));
      }
      has_skin = true;
    }
  }
}

/// Sets the damping of the joints and removes their limits, which JointStops replaces.
void set_resistance(const Skeleton& skeleton, Mechanism& mechanism) {
  const Eigen::VectorXd damping = joint_damping(skeleton, JointResistance());
  for (MechanismJoint& joint : mechanism.joints) {
    joint.lower = -std::numeric_limits<double>::infinity();
    joint.upper = std::numeric_limits<double>::infinity();
    // Only the joint that its coordinate is named after is damped.
    if (joint.coordinate >= 0 && joint.name == skeleton.coordinate_names[joint.coordinate])
      joint.damping = damping[joint.coordinate];
  }
}

/// Assembles the digits of a hand from their tendons.
std::vector<HumanDigit> assemble_digits(
    const std::vector<std::shared_ptr<const DigitTendons>>& tendons, const Subject& subject,
    const Skeleton& skeleton, const std::map<std::string, double>& max_force) {
  std::vector<HumanDigit> digits;
  for (std::size_t i = 0; i < tendons.size(); ++i) {
    // Indices of the tendons' coordinates among those of the hand.
    HumanDigit digit{subject.digits[i].name, tendons[i], {}, {}};
    const TendonNames& names = tendons[i]->digit().names;
    for (const std::string& name : names.coordinates) {
      digit.coordinates.push_back(place_in(skeleton.coordinate_names, name));
      require(digit.coordinates.back() >= 0, "tendons move joint '{}', which is not there", name);
    }
    for (const std::string& name : names.muscles) digit.max_force.push_back(max_force.at(name));
    digits.push_back(std::move(digit));
  }
  return digits;
}

/// Builds the tendons of all digits, and adds their warnings once each.
std::vector<HumanDigit> build_digits(const HumanModel& model, const Subject& subject,
                                     const Skeleton& skeleton, std::vector<std::string>& warnings) {
  if (subject.muscles.empty()) return {};
  const Hood extensors =
      model.version == HumanVersion::kTendonNet ? Hood::kFloatingNet : Hood::kFractions;
  // Build the tendons, and collect new warnings.
  HumanTendons built = human_tendons(subject, extensors, model.options);
  append_new(warnings, built.warnings);
  std::vector<std::shared_ptr<const DigitTendons>> tendons;
  for (std::unique_ptr<DigitTendons>& digit : built.hand.digits)
    tendons.emplace_back(std::move(digit));
  return assemble_digits(tendons, subject, skeleton, built.hand.max_force);
}

}  // namespace

HumanMechanism human_mechanism(const HumanModel& model) {
  // Build the hand with all masses.
  HumanMechanism out;
  out.subject = subject_with_masses(model, out.warnings);
  const HumanHand hand = build_human_hand(out.subject, model.version, model.options);
  append_all(out.warnings, hand.warnings);
  out.skeleton = hand.skeleton;
  out.contact = hand.contact;
  // Convert it to a mechanism with skin and joint damping.
  out.mechanism =
      prepend_base(skeleton_mechanism(hand.skeleton), base_mass(out.subject, hand.skeleton));
  const SkinError error = capsule_error(hand.hand->surfaces());
  if (model.options.skin.capsules && !error.worst.empty())
    out.warnings.push_back(
        fmt::format("skin of digits is tapered capsules: {:.2g} mm from the skin in the mean "
                    "square, {:.2g} mm at most ({})",
                    1e3 * error.rms, 1e3 * error.largest, error.worst));
  add_skins(out.subject, hand.skeleton, hand.hand->surfaces(), out.mechanism);
  set_resistance(hand.skeleton, out.mechanism);
  // Set the largest efforts of the motors, if the version has motors.
  const HandLayout& layout = hand.hand->layout();
  if (model.version != HumanVersion::kTendonNet) {
    const Actuation motors = hand.hand->actuation(Eigen::VectorXd::Zero(layout.lower.size()));
    for (std::size_t c = 0; c < out.mechanism.coordinates.size(); ++c)
      out.mechanism.coordinates[c].max_effort = std::max(-motors.lower[c], motors.upper[c]);
  }
  // Set the open posture, by default the one nearest to zero in range, and the tendons.
  out.open = layout.open.size() > 0
                 ? layout.open
                 : Eigen::VectorXd(layout.lower.cwiseMax(0).cwiseMin(layout.upper));
  out.digits = build_digits(model, out.subject, hand.skeleton, out.warnings);
  return out;
}

}  // namespace thenar
