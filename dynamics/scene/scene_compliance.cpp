#include "dynamics/scene/scene_compliance.h"

#include "base/error.h"

namespace thenar {

JointCompliance joint_compliance(const SceneComplianceSpec& spec) {
  constexpr std::array<BushingCoordinate, 5> kCoordinates{
      BushingCoordinate::kAcross, BushingCoordinate::kAlong, BushingCoordinate::kAxial,
      BushingCoordinate::kAbduction, BushingCoordinate::kTwist};
  JointCompliance out;
  // Stiffness, toe region and damping of each coordinate but flexion.
  for (std::size_t i = 0; i < kCoordinates.size(); ++i) {
    const double toe = i == SceneComplianceSpec::kTwist       ? spec.twist_toe
                       : i == SceneComplianceSpec::kAbduction ? spec.rotation_toe
                                                              : spec.translation_toe;
    out.law.law_for(kCoordinates[i]) = {spec.stiffness[i], toe, spec.stiffening, spec.damping[i]};
  }
  out.law.flexion_ratios[static_cast<std::size_t>(BushingCoordinate::kTwist)] = spec.twist_follows;
  out.bone = spec.bone.value_or(Eigen::Vector3d(0, 0, 0));
  return out;
}

std::vector<CompliantJoint> make_part_compliant(const SceneSpec& spec, const std::string& name,
                                                const std::string& prefix, Mechanism& part) {
  std::vector<CompliantJoint> made;
  // Apply the compliances that name a joint of this part.
  for (const SceneComplianceSpec& compliance : spec.compliances) {
    const bool is_own = prefix.empty() ? compliance.joint == name
                                       : compliance.joint.compare(0, prefix.size(), prefix) == 0;
    if (!is_own) continue;
    at_line(spec.path, compliance.line, [&] {
      const int joint = joint_index(part, compliance.joint.substr(prefix.size()));
      made.push_back(make_compliant(part, joint, joint_compliance(compliance)));
    });
  }
  return made;
}

namespace {

/// Builds a bushing; both of its frames have the bushing's point as origin and its axis as z.
std::shared_ptr<const ForceElement> bushing_element(const SceneBushingSpec& spec,
                                                    const Mechanism& mechanism,
                                                    const std::vector<Pose<double>>& X_WB) {
  // Laws of the six coordinates.
  BushingLaw law;
  for (std::size_t i = 0; i < law.laws.size(); ++i)
    law.laws[i] = {spec.stiffness[i], i < 3 ? spec.translation_toe : spec.rotation_toe,
                   spec.stiffening, spec.damping[i]};
  // Express the frame in both bodies.
  const Pose<double> X_WA = frame_with_z(spec.axis, spec.point);
  const auto frame_in = [&](const std::string& name) -> BodyFrame {
    if (name.empty()) return {-1, X_WA};
    const int body = body_named(mechanism, name);
    return {body, X_WB[body].inverse() * X_WA};
  };
  return std::make_shared<BushingElement>(spec.name, frame_in(spec.from), frame_in(spec.to), law);
}

}  // namespace

std::vector<std::shared_ptr<const ForceElement>> build_scene_ligaments(
    const SceneSpec& spec, const Mechanism& mechanism, const std::vector<Pose<double>>& X_WB) {
  std::vector<std::shared_ptr<const ForceElement>> out;
  for (const SceneBushingSpec& bushing : spec.bushings)
    at_line(spec.path, bushing.line,
            [&] { out.push_back(bushing_element(bushing, mechanism, X_WB)); });
  for (const SceneLigamentSpec& ligament : spec.ligaments)
    at_line(spec.path, ligament.line, [&] {
      // Points of both ends, and by default the initial distance as slack length.
      BodyPoint from{-1, ligament.from_point}, to{-1, ligament.to_point};
      if (!ligament.from.empty()) from.body = body_named(mechanism, ligament.from);
      to.body = body_named(mechanism, ligament.to);
      const auto world_point = [&](const BodyPoint& end) -> Eigen::Vector3d {
        return end.body < 0 ? end.p : X_WB[end.body] * end.p;
      };
      const double slack =
          ligament.slack_length.value_or((world_point(to) - world_point(from)).norm());
      out.push_back(std::make_shared<LigamentElement>(
          ligament.name, from, to,
          LigamentLaw{slack, ligament.stiffness, ligament.toe_strain, ligament.damping}));
    });
  return out;
}

}  // namespace thenar
