#pragma once

/// Picture of a live view as data: bodies, joints, lines, contacts, arrows.
///
/// All kinds of models (a world, a moving scene, a digit with tendons, a fit) produce this picture,
/// so that a viewer does not depend on the kind of model. LiveShape holds the constant parts
/// (meshes, names, limits), LiveInstant the parts that move, in the same order, so that an instant
/// is small enough to be sent in every frame.

#include <array>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "base/enum_names.h"
#include "base/spatial.h"
#include "geometry/solid.h"

namespace thenar {

/// Role of a body, which sets its colour and the actions on it.
enum class LiveRole { kLink, kNail, kBone, kObject, kObstacle };
inline constexpr std::array kLiveRoleNames{
    EnumName{LiveRole::kLink, "link"}, EnumName{LiveRole::kNail, "nail"},
    EnumName{LiveRole::kBone, "bone"}, EnumName{LiveRole::kObject, "object"},
    EnumName{LiveRole::kObstacle, "obstacle"}};

/// A rigid body with its surface.
struct LiveBody {
  std::string name;   // "barrett/finger 1 distal", "mug"
  std::string owner;  // name of its hand; for other bodies, their own name
  std::string digit;  // "index"; empty: palm, arm, or no part of a hand
  std::string material;
  LiveRole role = LiveRole::kObject;
  bool movable = false;                      // true: the user can place its owner
  std::shared_ptr<const TriangleMesh> mesh;  // surface in the body's frame [m]; null: none
  double crease = -1;  // smallest angle of an edge that is shaded sharp [deg]; negative: none is
};

/// Joint that the user can drag: drawn as a disc about its axis, or an arrow along it.
struct LiveJoint {
  std::string name;                // name in requests
  std::string hand;                // hand or moving body that has the joint
  int body = -1;                   // entry of LiveShape::bodies in whose frame the axis is given
  Eigen::Vector3d axis{0, 0, 1};   // unit vector along the axis, that body's frame (3)
  Eigen::Vector3d point{0, 0, 0};  // point on the axis, that body's frame [m] (3)
  bool slides = false;             // true: prismatic, false: revolute
  double lower = 0, upper = 0;     // limits [rad] or [m]
  std::string led_by;              // joint that it follows; empty: it can be dragged
};

/// Line with a tension: path of a tendon, or band of a net.
struct LiveLine {
  std::string name;   // "FDP", "central slip"
  std::string owner;  // name of its digit
  bool band = false;  // true: band of an extensor net
  int points = 0;     // number of points in every instant
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

/// Arrow of a picture; it is not drawn at instants where its length is zero.
struct LiveArrow {
  std::string name;
  LiveArrowKind kind = LiveArrowKind::kForce;
};

/// Many short lines that are fixed to a body, such as the joint axes of posterior draws.
struct LiveCloud {
  std::string name;
  int body = -1;                          // body that carries the lines; -1: the world
  std::vector<Eigen::Vector3d> segments;  // start and end of each line, in turn, body frame [m]
};

/// Constant parts of a picture.
struct LiveShape {
  std::vector<LiveBody> bodies;
  std::vector<LiveJoint> joints;
  std::vector<LiveLine> lines;
  std::vector<LiveArrow> arrows;
  std::vector<LiveCloud> clouds;
  Eigen::Vector3d eye{0.4, -0.4, 0.3}, target{0, 0, 0};  // initial camera [m] (3)
};

/// Contact, drawn as a friction cone and the contact force.
struct LiveContact {
  int a = -1, b = -1;               // entries of LiveShape::bodies; the normal points from b to a
  Eigen::Vector3d point{0, 0, 0};   // contact point, world [m] (3)
  Eigen::Vector3d normal{0, 0, 1};  // unit outward normal of b, world (3)
  Eigen::Vector3d force{0, 0, 0};   // force on a, world; zero: unknown or none [N] (3)
  double friction = 0;              // coefficient of Coulomb friction [1]
};

/// Arrow at an instant.
struct LiveVector {
  Eigen::Vector3d from{0, 0, 0};    // start, world [m] (3)
  Eigen::Vector3d vector{0, 0, 0};  // force [N], moment [N m] or displacement, world (3)
};

/// Moving parts of a picture.
struct LiveInstant {
  double time = 0;                           // time of a moving scene, else 0 [s]
  std::vector<Pose<double>> bodies;          // poses X_WB, in the order of LiveShape::bodies
  std::vector<double> joints;                // values in the order of LiveShape::joints [rad], [m]
  std::vector<Eigen::Vector3d> line_points;  // points of all lines, line after line, world [m]
  std::vector<double> tensions;              // tensions of lines; NaN: unknown, 0: slack [N]
  std::vector<LiveVector> arrows;            // in the order of LiveShape::arrows
  std::vector<LiveContact> contacts;         // contacts at this instant, in any number
};

/// Returns the mesh of a solid, sharing ownership of the solid.
[[nodiscard]] std::shared_ptr<const TriangleMesh> picture_of_solid(
    const std::shared_ptr<const Solid>& solid);

/// Returns LiveBody::crease of a material: -1 (smooth) for skin, fingertips and bones, else 35 deg.
[[nodiscard]] double crease_of(const std::string& material);

/// Checks an instant against its shape.
/// @throws InputError if the numbers of entries differ, if a contact names no body of the shape, or
///         if a number other than a tension is not finite
void check_instant(const LiveShape& shape, const LiveInstant& instant);

/// Model that a live view shows.
class LiveModel {
 public:
  virtual ~LiveModel() = default;
  /// Returns the constant parts of the picture; they are valid until shape_changes() increases.
  [[nodiscard]] virtual const LiveShape& shape() const = 0;
  [[nodiscard]] virtual LiveInstant instant() const = 0;
  /// Returns the number of changes of shape().
  [[nodiscard]] virtual unsigned long shape_changes() const = 0;
  /// Returns the number of changes of instant().
  [[nodiscard]] virtual unsigned long changes() const = 0;
};

}  // namespace thenar
