#pragma once

/// The thumb of the human hand, which meets a mug on its ulnar side: figure 8 of [Miller2005].

#include <map>
#include <string>
#include <vector>

#include "dynamics/ligament/compliant_joint.h"
#include "dynamics/stepping/simulate_scene.h"

namespace thenar::sample {

/// What is assumed is chosen once, not fitted to the outcome; docs/theory/compliant_joints.md says
/// how the outcome changes with it.
struct ThumbOnMugOptions {
  bool compliant = true;
  double stiffer = 1;        // factor on all stiffness of joint_laws() [1]
  double from_pad = 70;      // where the mug meets the distal phalanx, from the middle of its pad
                             // around to the ulnar side [deg]
  double tilt = 45;          // of the mug's axis against the bone, seen from the mug [deg]
  double mug_radius = 0.04;  // [m]
  double friction = 0.8;     // of skin on the mug, assumed [1]
  double most_force = 30;    // with which the mug is pressed on the thumb at the end [N]
  double seconds = 3;        // in which that force grows from 0, evenly [s]
  double muscle = 20;        // stiffness of muscles about each hinge, assumed [N m/rad]
  int triangles = 3000;      // of the skin of the distal phalanx
  std::map<std::string, double> posture{
      // Of the thumb [deg]: neutral, but for 20 deg of flexion at the IP joint.
      {"CMC1_FE", 8.6},
      {"CMC1_AA", 35.6},
      {"MCP1_FE", 6},
      {"IP1", -3.8}};
};

/// A scene in which the mug slides against the thumb, its force growing evenly. Muscles hold the
/// thumb: their moments grow with the force so that on pins it stays where it is, and they have a
/// stiffness.
struct ThumbOnMug {
  MovingScene scene;
  int distal = 0, mug = 0;        // bodies
  Eigen::Vector3d pad{0, 0, 0};   // outward normal of the pad's middle, across the bone, distal
                                  // body's frame (3)
  Eigen::Vector3d bone{0, 0, 0};  // towards the tip, distal body's frame (3)
  SceneOptions options;           // steps of 0.5 ms
};
[[nodiscard]] ThumbOnMug thumb_on_mug(const ThumbOnMugOptions& options);

/// Capsules of the thumb's joints, by the hinge that gives; `stiffer` times as stiff as:
///   CMC   twist 0.4 N m/rad at rest, toe 0.15 rad, 8 N m/rad at the end of its range, where 5 to 9
///         were measured in vitro (range and toe are assumed)
///   MCP   abduction 1.5 N m/rad, toe 0.1 rad: 16.6 deg under 45 N, 30 mm from the joint (assumed),
///         where 14 to 18 deg were measured under 45 N [ShaftelThumbMcp]; twist 0.5 N m/rad, toe
///         0.15 rad: 15 deg under 0.2 N m (assumed)
///   IP    abduction 3 N m/rad, toe 0.1 rad; twist as that of the MCP joint (assumed)
/// and 100 N/mm in translation (assumed). Abduction of the CMC joint is a hinge of its own.
[[nodiscard]] std::map<std::string, BushingLaw> joint_laws(double stiffer);

/// The thumb at one force.
struct ThumbOnMugState {
  double t;          // [s]
  double force;      // with which the mug is pressed on it [N]
  double pad_angle;  // between the pad's normal and the direction to the mug at the contact; NaN
                     // without contact [rad]
  double roll;  // of the distal phalanx about its bone since the start; positive: the pad turns
                // to the ulnar side [rad]
  std::map<std::string, double> moved;  // coordinates since the start [rad], [m]
};
[[nodiscard]] std::vector<ThumbOnMugState> states_of(const ThumbOnMug& made, const SceneRun& run);

}  // namespace thenar::sample
