#pragma once

/// A hand of a live world with all that is drawn of it, built once however often it moves.

#include <memory>
#include <string>
#include <vector>

#include "api/named/worlds.h"
#include "geometry/collision/collision_tree.h"
#include "live/live_picture.h"
#include "live/world/hand_joints.h"
#include "live/world/hand_tendons.h"

namespace thenar {

/// A body of a hand. Its frame is the hand's at the reference posture, as of LinkSurface.
struct HandBody {
  LiveBody look;         // `name` without the hand's; owner and movable are left to the world
  int link = -1;         // that carries it; -1: the base
  bool carried = false;  // of what carries the hand: arm, mobile base
};

/// Constant once built.
struct LiveHand {
  WorldHand hand;  // as hand_of_world() built it; where it stands and its posture are not used
  std::vector<HandBody> bodies;  // surfaces, in their order, then nails, bones, frames of joints
  std::vector<HandJoint> joints;
  std::vector<int> joint_bodies;  // entry of `bodies` whose frame holds each joint's axis (joints)
  std::vector<JointLead> leads;   // (coordinates)
  std::vector<HandTendon> tendons;
  std::vector<Ball> balls;  // around each surface, hand frame, reference posture [m] (surfaces)

  [[nodiscard]] const Hand& model() const { return *hand.named.hand; }
};

/// Builds a hand of a world for the eye: human skin fine enough to look smooth, nails, bones,
/// tendons, axes of joints; distances and collision trees are left to those who ask for them.
/// @param name, path, data  as hand_of_world()
/// @throws InputError, DataError as hand_of_world(), or if the world's materials lack one of the
/// hand's; Stopped where progress says stop
[[nodiscard]] std::shared_ptr<const LiveHand> build_live_hand(const WorldSpec& world,
                                                              const std::string& name,
                                                              const std::string& path,
                                                              const std::vector<std::string>& data,
                                                              const Progress& progress = {});

/// Returns a key that is equal if two worlds have the same hand of a name: files, mounts and
/// carriers count, the pose does not.
/// @param data  as hand_of_world()
[[nodiscard]] std::string live_hand_key(const WorldSpec& world, std::size_t hand,
                                        const std::vector<std::string>& data);

/// Returns true if all files from which a hand was built, including meshes, are unchanged.
[[nodiscard]] bool is_up_to_date(const LiveHand& hand);

/// A ball that holds a mesh, about the middle of its box [m].
[[nodiscard]] Ball ball_around(const TriangleMesh& mesh);

/// A hand in its place.
struct HandStand {
  Pose<double> X_WH;
  Eigen::VectorXd q;  // (coordinates)
};

/// Adds bodies, joints and lines of a hand to a shape.
/// @param name  of the hand
/// @param root  of what it stands on: its own, unless it is mounted
void add_hand_shape(const LiveHand& hand, const std::string& name, const std::string& root,
                    LiveShape& shape);

/// Adds poses, values and points of a hand to an instant, in the order of add_hand_shape().
void add_hand_instant(const LiveHand& hand, const HandStand& stand, LiveInstant& instant);

}  // namespace thenar
