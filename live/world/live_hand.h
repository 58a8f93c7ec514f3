#pragma once

/// Hand of a live world with its drawn bodies, joints and tendons; built once, independent of pose
/// and posture.

#include <memory>
#include <string>
#include <vector>

#include "api/named/worlds.h"
#include "geometry/collision/collision_tree.h"
#include "live/live_picture.h"
#include "live/world/hand_joints.h"
#include "live/world/hand_tendons.h"

namespace thenar {

/// Drawn body of a hand. Its frame is the hand's frame at the reference posture, as for
/// LinkSurface.
struct HandBody {
  LiveBody look;         // body as drawn; the world sets the prefix of its name, owner and movable
  int link = -1;         // link that carries it; -1: the base
  bool carried = false;  // true: part of the carrier of the hand (arm, mobile base)
};

/// Hand with everything that is drawn of it; constant once built.
struct LiveHand {
  WorldHand hand;                // result of hand_of_world(); its pose and posture are not used
  std::vector<HandBody> bodies;  // surfaces, in their order, then nails, bones, joint frames
  std::vector<HandJoint> joints;
  std::vector<int> joint_bodies;  // entry of `bodies` in whose frame each axis is given (joints)
  std::vector<JointCoupling> couplings;  // (coordinates)
  std::vector<HandTendon> tendons;
  std::vector<Ball> balls;  // around each surface, hand frame, reference posture [m] (surfaces)

  [[nodiscard]] const Hand& model() const { return *hand.named.hand; }
};

/// Builds a hand of a world for drawing: smooth human skin, nails, bones, tendons, joint axes.
/// Collision models are built on demand, see HandContactCache.
/// @param name, path, data  as for hand_of_world()
/// @throws InputError, DataError as hand_of_world(), or if the world lacks a material of the hand;
///         Stopped
[[nodiscard]] std::shared_ptr<const LiveHand> build_live_hand(const WorldSpec& world,
                                                              const std::string& name,
                                                              const std::string& path,
                                                              const std::vector<std::string>& data,
                                                              const Progress& progress = {});

/// Returns a key that is equal for equal hands of two worlds: it includes name, files, mounts and
/// carriers, but not the pose.
/// @param hand  entry of WorldSpec::hands;  @param data  as for hand_of_world()
[[nodiscard]] std::string live_hand_key(const WorldSpec& world, std::size_t hand,
                                        const std::vector<std::string>& data);

/// Returns true if all files from which a hand was built, including meshes, are unchanged.
[[nodiscard]] bool is_up_to_date(const LiveHand& hand);

/// Returns a ball that encloses a mesh, centred in the mesh's bounding box [m].
[[nodiscard]] Ball ball_around(const TriangleMesh& mesh);

/// Pose and posture of a hand.
struct HandPlacement {
  Pose<double> X_WH;
  Eigen::VectorXd q;  // posture [rad] or [m] (coordinates)
};

/// Adds the bodies, joints and lines of a hand to a shape.
/// @param name  name of the hand
/// @param root  name of the base that carries it; its own name if it is not mounted
void add_hand_shape(const LiveHand& hand, const std::string& name, const std::string& root,
                    LiveShape& shape);

/// Adds the poses, joint values and line points of a hand to an instant, in the order of
/// add_hand_shape().
void add_hand_instant(const LiveHand& hand, const HandPlacement& placement, LiveInstant& instant);

}  // namespace thenar
