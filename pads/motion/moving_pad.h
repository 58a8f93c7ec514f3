#pragma once

/// Pad under a moving rigid object, in time steps: the interface of all levels of detail.

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
  std::string message;              // reason of any other status
  Wrench push;                      // wrench of the object on the pad, about the pad's origin
  double force = 0;                 // sum of normal forces [N]
  double area = 0;                  // area of the patch [m^2]
  double stick = 0;                 // share of the normal force that sticks [1]
  double force_error = 0;           // estimated relative error of the force, where known [1]
  double gap = 0;                   // lower bound of the distance to the skin; 0: touches [m]
  Eigen::Vector3d centre{0, 0, 0};  // centre of pressure [m] (3)
  Eigen::Vector3d normal{0, 0, 0};  // mean direction of the normal forces, unit (3)
};

using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// A pad and a moving object, with the pad's history.
class MovingPad {
 public:
  virtual ~MovingPad() = default;
  /// Returns a copy of the pad without its history.
  [[nodiscard]] virtual std::unique_ptr<MovingPad> clone() const = 0;
  /// Returns the name of the level of detail: "elements", "foundation", "soft-finger".
  [[nodiscard]] virtual std::string rung() const = 0;

  /// Computes a trial step from the kept state to a pose of the object in the pad's frame. The kept
  /// state does not change.
  /// @param seconds  duration of the step; 0: instant [s]
  [[nodiscard]] virtual PadContact try_step(const Pose<double>& X_PO, double seconds) = 0;
  /// Accepts the last try_step() as the kept state. Before any step, or after one that failed, the
  /// kept state does not change.
  virtual void accept_step() = 0;

  /// Returns the derivative of the object's wrench with respect to an instantaneous motion from the
  /// kept pose: moment and rotation first, about the pad's origin (6, 6). Sticking parts resist,
  /// slipping parts do not. The default takes differences of try_step() over a micrometre, and over
  /// the angle that moves a point at 10 mm by the same distance.
  /// @param onward  signs of the differences, chosen along the object's motion, because slipping
  ///                parts would stick on reversal (6)
  [[nodiscard]] virtual Matrix6 stiffness(const Eigen::Matrix<double, 6, 1>& onward);

  /// Returns the elastic energy of the pad at the kept state, as if nothing relaxed [J].
  [[nodiscard]] virtual double energy() const = 0;

  /// Returns a distance from the pad's origin that none of its points exceeds [m].
  [[nodiscard]] virtual double reach() const = 0;

  /// Returns the relaxation terms of the contact force, for predictions.
  [[nodiscard]] virtual const std::vector<ExponentialTerm>& relaxation() const = 0;

  /// Returns the pose of the object at the last accept_step().
  [[nodiscard]] virtual const Pose<double>& object_pose() const = 0;
};

/// Returns the pose after a small motion about the origin.
/// @param motion  rotation, then displacement [rad], [m] (6)
[[nodiscard]] Pose<double> moved_by(const Pose<double>& X,
                                    const Eigen::Matrix<double, 6, 1>& motion);
/// Returns the motion from one pose to another, rotation first [rad], [m] (6).
[[nodiscard]] Eigen::Matrix<double, 6, 1> motion_from(const Pose<double>& from,
                                                      const Pose<double>& to);

/// Returns the contact, with status kStalled, of laws on the undeformed skin if the skin lies
/// beyond the middle of a thin object, so that the object's far side is nearer.
[[nodiscard]] PadContact behind_object();

/// Returns a wrench as six numbers, the moment first [N m], [N] (6).
[[nodiscard]] inline Eigen::Matrix<double, 6, 1> wrench_vector(const Wrench& w) {
  Eigen::Matrix<double, 6, 1> out;
  out << w.moment, w.force;
  return out;
}

}  // namespace thenar
