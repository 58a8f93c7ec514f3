#pragma once

/// Picture of a live view at an instant: bodies, joints, lines, contacts, arrows; no words, no
/// pixels.
///
/// Every kind of model (a world, a moving scene, a digit with tendons, a fit) fills in the same
/// picture, and whoever draws it need not know which one it is. What never changes while a model
/// stays the same (meshes, names, limits) stands in LiveShape; what moves stands in LiveInstant, in
/// the same order, so that an instant is small enough to be sent at every frame.

#include <array>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "base/enum_names.h"
#include "base/spatial.h"
#include "geometry/solid.h"

namespace thenar {

/// Role of a body, which determines its colour and the actions on it.
enum class LiveRole { kLink, kNail, kBone, kObject, kObstacle };
inline constexpr std::array kLiveRoleNames{
    EnumName{LiveRole::kLink, "link"}, EnumName{LiveRole::kNail, "nail"},
    EnumName{LiveRole::kBone, "bone"}, EnumName{LiveRole::kObject, "object"},
    EnumName{LiveRole::kObstacle, "obstacle"}};

/// A rigid body with its surface.
struct LiveBody {
  std::string name;   // "barrett/finger 1 distal", "mug"
  std::string owner;  // hand that it is part of, or the body itself
  std::string digit;  // "index"; empty: palm, arm, or no part of a hand
  std::string material;
  LiveRole role = LiveRole::kObject;
  bool movable = false;                      // whether its owner can be placed by hand
  std::shared_ptr<const TriangleMesh> mesh;  // body's frame [m]; null: nothing to see
  double crease = -1;  // edges sharper than this look sharp [deg]; negative: all are smooth
};

/// A joint that can be dragged: a disc about its axis, or an arrow along it.
struct LiveJoint {
  std::string name;                // as requests name it
  std::string hand;                // or moving body whose joint it is
  int body = -1;                   // entry of LiveShape::bodies whose frame holds the axis
  Eigen::Vector3d axis{0, 0, 1};   // unit, that body's frame (3)
  Eigen::Vector3d point{0, 0, 0};  // on the axis, that body's frame [m] (3)
  bool slides = false;             // false: it turns
  double lower = 0, upper = 0;     // [rad] or [m]
  std::string led_by;              // joint that drives it; empty: it can be dragged by itself
};

/// A path of a tendon, a band of a net, or any other line with a tension.
struct LiveLine {
  std::string name;   // "FDP", "central slip"
  std::string owner;  // digit
  bool band = false;  // of an extensor net
  int points = 0;     // of every instant
};

/// Quantity that an arrow shows.
enum class LiveArrowKind { kForce, kMoment, kAxis, kMeasured, kPredicted, kDisturbance };
inline constexpr std::array kLiveArrowKindNames{
    EnumName{LiveArrowKind::kForce, "force"},
    EnumName{LiveArrowKind::kMoment, "moment"},
    EnumName{LiveArrowKind::kAxis, "axis"},
    EnumName{LiveArrowKind::kMeasured, "measured"},
    EnumName{LiveArrowKind::kPredicted, "predicted"},
    EnumName{LiveArrowKind::kDisturbance, "disturbance"}};

/// An arrow that is there at every instant; without length it is not drawn.
struct LiveArrow {
  std::string name;
  LiveArrowKind kind = LiveArrowKind::kForce;
};

/// Many short lines that never move against a body, as the joint axes of many draws.
struct LiveCloud {
  std::string name;
  int body = -1;                          // -1: the world
  std::vector<Eigen::Vector3d> segments;  // from each even entry to the next one [m]
};

/// Parts of a picture that stay as long as the model does.
struct LiveShape {
  std::vector<LiveBody> bodies;
  std::vector<LiveJoint> joints;
  std::vector<LiveLine> lines;
  std::vector<LiveArrow> arrows;
  std::vector<LiveCloud> clouds;
  Eigen::Vector3d eye{0.4, -0.4, 0.3}, target{0, 0, 0};  // of the camera at first [m] (3)
};

/// A contact as it is drawn: a friction cone, and the force through it where that is known.
struct LiveContact {
  int a = -1, b = -1;               // entries of LiveShape::bodies; a is pushed along the normal
  Eigen::Vector3d point{0, 0, 0};   // world [m] (3)
  Eigen::Vector3d normal{0, 0, 1};  // unit, outward of b (3)
  Eigen::Vector3d force{0, 0, 0};   // on a [N] (3); zero: not known, or none
  double friction = 0;              // Coulomb's coefficient [1]
};

/// An arrow at an instant.
struct LiveVector {
  Eigen::Vector3d from{0, 0, 0};    // [m] (3)
  Eigen::Vector3d vector{0, 0, 0};  // [N], [N m], or without unit (3)
};

/// Parts of a picture that move.
struct LiveInstant {
  double time = 0;                           // of a scene that moves [s]; else 0
  std::vector<Pose<double>> bodies;          // X_WB, as LiveShape::bodies
  std::vector<double> joints;                // [rad] or [m], as LiveShape::joints
  std::vector<Eigen::Vector3d> line_points;  // of all lines, one after the other, world [m]
  std::vector<double> tensions;              // of lines [N]; NaN: unknown, 0: slack
  std::vector<LiveVector> arrows;            // as LiveShape::arrows
  std::vector<LiveContact> contacts;         // as many as there are
};

/// The mesh of a solid that others own, without a copy.
[[nodiscard]] std::shared_ptr<const TriangleMesh> picture_of_solid(
    const std::shared_ptr<const Solid>& solid);

/// LiveBody::crease of a material: skin and bones are smooth, other edges sharper than 35 deg are
/// not.
[[nodiscard]] double crease_of(const std::string& material);

/// Throws InputError, saying what is off, unless an instant has as many entries as its shape, its
/// contacts are of bodies that are there, and all but tensions is finite.
void check_instant(const LiveShape& shape, const LiveInstant& instant);

/// A model that a live view shows.
class LiveModel {
 public:
  virtual ~LiveModel() = default;
  /// Returns the constant parts of the picture; they stay until shape_changes() increases.
  [[nodiscard]] virtual const LiveShape& shape() const = 0;
  [[nodiscard]] virtual LiveInstant instant() const = 0;
  /// Counts changes of the shape; changes() counts changes of anything that an instant shows.
  [[nodiscard]] virtual unsigned long shape_changes() const = 0;
  [[nodiscard]] virtual unsigned long changes() const = 0;
};

}  // namespace thenar
