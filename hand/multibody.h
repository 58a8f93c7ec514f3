#pragma once

/// Skeleton as a Simbody multibody, for dynamics and as an independent check of kinematics.

#include <memory>
#include <vector>

#include <Eigen/Core>

#include "hand/skeleton.h"
#include "hand/statics.h"

namespace thenar {

/// Switch of the passive springs and dampers of the joints.
enum class Passive {
  kOff,  // only the given torques and loads
  kOn    // adds  -stiffness (q - rest) - damping q_dot  at every coordinate
};

/// Posture and speeds of the joints.
struct JointMotion {
  Eigen::VectorXd q;      // joint angles [rad] (coordinates)
  Eigen::VectorXd q_dot;  // joint velocities [rad/s] (coordinates)
};

/// Multibody of pin joints at the skeleton's axes. A coupled hinge follows its leader through a
/// constraint, so that every vector has one entry per coordinate of the skeleton.
///
/// The links between the two hinges of a universal joint are massless; that is exact, and well
/// posed as long as a body beyond them has mass and their axes are not the same line.
///
/// Owns one Simbody System and State, which every call changes: use one object per thread.
/// @throws InputError (every call) if a vector has the wrong length or a link does not exist;
/// (masses, energies, dynamics) if a segment has mass but unknown moments of inertia.
class Multibody {
 public:
  explicit Multibody(const Skeleton& skeleton, Passive passive = Passive::kOff);
  ~Multibody();
  Multibody(Multibody&&) noexcept;
  Multibody& operator=(Multibody&&) noexcept;

  /// Computes the displacement of every link from the reference posture. @param q (coordinates)
  /// [rad]
  [[nodiscard]] std::vector<Pose<double>> pose(const Eigen::Ref<const Eigen::VectorXd>& q);

  /// Computes the spatial Jacobian, rotation above translation, of a point of a link. (6,
  /// coordinates)
  /// @param link  -1: the base, which does not move
  /// @param p     position of the point at the reference posture [m] (3)
  [[nodiscard]] Eigen::Matrix<double, 6, Eigen::Dynamic> jacobian(
      const Eigen::Ref<const Eigen::VectorXd>& q, int link, const Eigen::Vector3d& p);

  /// Computes the torque of weights and forces about every coordinate, as load_torque() of
  /// hand/statics.h.
  [[nodiscard]] Eigen::VectorXd load_torque(const Eigen::Ref<const Eigen::VectorXd>& q,
                                            const Loads& loads);

  /// Computes the mass matrix M(q), symmetric. (coordinates, coordinates) [kg m^2]
  [[nodiscard]] Eigen::MatrixXd mass_matrix(const Eigen::Ref<const Eigen::VectorXd>& q);

  /// Computes the kinetic energy  q_dot' M q_dot / 2  [J].
  [[nodiscard]] double kinetic_energy(const JointMotion& motion);

  /// Computes the joint torque for given accelerations:
  ///   tau = M q_ddot + c(q, q_dot) - load torque - passive torque.
  /// @param q_ddot  (coordinates) [rad/s^2]
  /// @return        (coordinates) [N m]
  [[nodiscard]] Eigen::VectorXd inverse_dynamics(const JointMotion& motion,
                                                 const Eigen::Ref<const Eigen::VectorXd>& q_ddot,
                                                 const Loads& loads = {});

  /// Computes the accelerations under given joint torques; the inverse of inverse_dynamics().
  /// @param tau  (coordinates) [N m]
  /// @return     (coordinates) [rad/s^2]
  /// @throws InputError if nothing beyond a hinge has mass.
  [[nodiscard]] Eigen::VectorXd forward_dynamics(const JointMotion& motion,
                                                 const Eigen::Ref<const Eigen::VectorXd>& tau,
                                                 const Loads& loads = {});

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace thenar
