#pragma once

/// A bone on a hinge, rigid or compliant.

#include <cmath>
#include <memory>

#include "base/units.h"
#include "dynamics/ligament/bushing.h"
#include "dynamics/ligament/compliant_joint.h"
#include "dynamics/stepping/simulate_scene.h"

namespace thenar::sample {

/// A rod of 40 mm along x from the hinge, 20 g, 8 mm thick.
inline MechanismBody bone(const std::string& name) {
  MechanismBody body;
  body.name = name;
  body.mass.mass = 0.02;
  body.mass.com = Eigen::Vector3d(0.02, 0, 0);
  body.mass.inertia = Eigen::Vector3d(0.5 * 0.02 * 16e-6, 0.02 * (16e-6 / 4 + 16e-4 / 12),
                                      0.02 * (16e-6 / 4 + 16e-4 / 12))
                          .asDiagonal();
  return body;
}

/// A bone on a hinge about the world's y, at a place of its parent.
inline MechanismJoint hinge(const std::string& name, int parent, const Eigen::Vector3d& place,
                            int coordinate) {
  MechanismJoint joint;
  joint.name = name;
  joint.parent = parent;
  joint.coordinate = coordinate;
  // Columns x, -z, y: z of the joint is the world's y.
  joint.X_PF.R << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  joint.X_PF.p = place;
  joint.X_BM.R = joint.X_PF.R;
  return joint;
}

/// One bone, or two in a row.
inline Mechanism bones(int count) {
  Mechanism out;
  for (int i = 0; i < count; ++i) {
    const std::string name = i == 0 ? "near" : "far";
    out.bodies.push_back(bone(name + " bone"));
    out.joints.push_back(hinge(name, i - 1, {i == 0 ? 0 : 0.04, 0, 0}, i));
    out.coordinates.push_back({name});
  }
  return out;
}

/// The same law in all translations and in both other rotations; flexion has none.
inline BushingLaw even_law(double translation, double rotation, double damping_ratio = 0) {
  BushingLaw law;
  // Critical damping of 20 g and of 1e-6 kg m^2 at ratio 1.
  for (const BushingCoordinate way :
       {BushingCoordinate::kAcross, BushingCoordinate::kAlong, BushingCoordinate::kAxial})
    law.law_for(way) = {translation, std::numeric_limits<double>::infinity(), 20,
                        damping_ratio * 2 * std::sqrt(translation * 0.02)};
  for (const BushingCoordinate way : {BushingCoordinate::kAbduction, BushingCoordinate::kTwist})
    law.law_for(way) = {rotation, std::numeric_limits<double>::infinity(), 20,
                        damping_ratio * 2 * std::sqrt(rotation * 1e-6)};
  return law;
}

/// A law without any symmetry: toes, a flexion spring, a twist that follows flexion.
inline BushingLaw uneven_law(double damping = 0) {
  BushingLaw law;
  law.laws = {CapsuleLaw{4e4, 3e-4, 10, 5 * damping}, CapsuleLaw{8e4, 2e-4, 5, 8 * damping},
              CapsuleLaw{5e4, 4e-4, 8, 6 * damping},  CapsuleLaw{0.05, 0.5, 20, 1e-4 * damping},
              CapsuleLaw{2, 0.1, 15, 2e-3 * damping}, CapsuleLaw{1, 0.2, 12, 1e-3 * damping}};
  law.flexion_ratios = {1e-3, -2e-3, 5e-4, 0, 0.1, 0.3};
  return law;
}

/// A scene of a mechanism at its reference position, without weights.
inline MovingScene scene_of(Mechanism mechanism) {
  MovingScene scene;
  scene.gravity.setZero();
  scene.q = reference_position(mechanism);
  scene.v = Eigen::VectorXd::Zero(layout_of(mechanism).v);
  scene.mechanism = std::move(mechanism);
  return scene;
}

/// Bones whose last hinge gives.
inline MovingScene compliant_scene(int count, const BushingLaw& law,
                                   CompliantJoint* made = nullptr) {
  Mechanism mechanism = bones(count);
  const CompliantJoint joint =
      make_compliant(mechanism, count - 1, {law, Eigen::Vector3d(0.04, 0, 0)});
  if (made) *made = joint;
  MovingScene scene = scene_of(std::move(mechanism));
  scene.elements.push_back(std::make_shared<CapsuleElement>(scene.mechanism, joint));
  return scene;
}

/// The same by a bone on a free joint and a bushing.
inline MovingScene bushing_scene(int count, const BushingLaw& law) {
  Mechanism mechanism = bones(count);
  MechanismJoint& joint = mechanism.joints.back();
  // Its frame: y is the bone, x = y cross z.
  Pose<double> C;
  C.R << 0, 1, 0, -1, 0, 0, 0, 0, 1;
  joint.kind = JointKind::kFree;
  joint.X_PF = joint.X_PF * C;
  joint.X_BM = joint.X_BM * C;
  joint.coordinate = -1;
  mechanism.coordinates.pop_back();
  const BodyFrame near{joint.parent, joint.X_PF}, far{count - 1, joint.X_BM};
  MovingScene scene = scene_of(std::move(mechanism));
  scene.elements.push_back(std::make_shared<BushingElement>("far", near, far, law));
  return scene;
}

}  // namespace thenar::sample
