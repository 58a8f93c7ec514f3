#pragma once

/// A pad that a rigid object moves against in steps of time: the interface of all rungs in motion.

#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "base/spatial.h"
#include "pad_laws/exponential_memory.h"
#include "solvers/status.h"

namespace thenar {

/// Contact between a pad and an object at an instant, in the pad's frame. All fields are zero if
/// nothing touches.
struct PadContact {
  Status status = Status::kSolved;
  std::string message;              // of any other status
  Wrench push;                      // of the object on the pad, about the pad's origin
  double force = 0;                 // sum of normal forces [N]
  double area = 0;                  // of the patch [m^2]
  double stick = 0;                 // share of the normal force on what sticks [1]
  double force_error = 0;           // of the rung, where it has an estimate, relative [1]
  double gap = 0;                   // at least so far from the skin; 0: touches, or as good as [m]
  Eigen::Vector3d centre{0, 0, 0};  // of pressure [m] (3)
  Eigen::Vector3d normal{0, 0, 0};  // mean direction of the push without friction, unit (3)
};

using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// A pad, an object, and what the pad remembers of it.
class MovingPad {
 public:
  virtual ~MovingPad() = default;
  /// Returns another such pad that nothing has touched yet.
  [[nodiscard]] virtual std::unique_ptr<MovingPad> clone() const = 0;
  /// "elements", "foundation", "soft-finger".
  [[nodiscard]] virtual std::string rung() const = 0;

  /// A step from what was kept to a pose of the object in the pad's frame. Nothing is kept.
  /// @param seconds  of the step; 0: at once
  [[nodiscard]] virtual PadContact move(const Pose<double>& X_PO, double seconds) = 0;
  /// Keeps what the last move() has made; before any, does nothing. A move that failed keeps the
  /// pad as it was.
  virtual void keep() = 0;

  /// d push / d motion of the object from where it was kept, at once: moment and turn first, about
  /// the pad's origin. What sticks resists, what slips does not. By default from differences of
  /// move() over a micrometre, and over an angle that moves a lever of 10 mm as far.
  /// @param onward  signs of these differences: the way that the object goes, as what slips there
  ///                sticks on the way back (6)
  [[nodiscard]] virtual Matrix6 stiffness(const Eigen::Matrix<double, 6, 1>& onward);

  /// Elastic energy of the pad under the object as it was kept, if nothing relaxed [J].
  [[nodiscard]] virtual double energy() const = 0;

  /// Returns a distance from the pad's origin that none of its points exceeds [m].
  [[nodiscard]] virtual double reach() const = 0;

  /// Returns the relaxation of a push, for predictions.
  [[nodiscard]] virtual const std::vector<ExponentialTerm>& relaxation() const = 0;

  /// Returns the pose of the object at the last keep().
  [[nodiscard]] virtual const Pose<double>& object_pose() const = 0;
};

/// Returns the pose after a small motion about the origin.
/// @param motion  turn, then way [rad], [m] (6)
[[nodiscard]] Pose<double> moved_by(const Pose<double>& X,
                                    const Eigen::Matrix<double, 6, 1>& motion);
/// Returns the motion from one pose to another, turn first [rad], [m] (6).
[[nodiscard]] Eigen::Matrix<double, 6, 1> motion_from(const Pose<double>& from,
                                                      const Pose<double>& to);

/// Returns the answer of laws for the undeformed skin, kStalled, if the skin lies beyond the middle
/// of a thin object, so that the object's far side is nearer.
[[nodiscard]] PadContact behind_object();

/// Returns a wrench as six numbers, the moment first [N m], [N] (6).
[[nodiscard]] inline Eigen::Matrix<double, 6, 1> six_of(const Wrench& w) {
  Eigen::Matrix<double, 6, 1> out;
  out << w.moment, w.force;
  return out;
}

}  // namespace thenar
