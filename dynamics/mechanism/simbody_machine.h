#pragma once

/// Multibody dynamics by Simbody, the reference for this project's own recursions.

#include <memory>
#include <vector>

#include <Eigen/Core>

#include "dynamics/mechanism/mechanism.h"

namespace thenar {

/// Force and moment on a body, in world axes.
struct BodyLoad {
  int body = -1;                    // loaded body; -1: the world, no effect
  Eigen::Vector3d p{0, 0, 0};       // point of application, world [m] (3)
  Eigen::Vector3d force{0, 0, 0};   // force [N] (3)
  Eigen::Vector3d moment{0, 0, 0};  // moment [N m] (3)
};

/// Dynamics of a mechanism by Simbody. Joints that share a coordinate are coupled by constraints to
/// the first of them that follows it linearly. Owns one Simbody System and State, which calls
/// modify: one object per thread.
class SimbodyMachine {
 public:
  /// Builds the Simbody system. @throws InputError as check_mechanism(), or if no joint follows a
  /// shared coordinate linearly.
  explicit SimbodyMachine(const Mechanism& mechanism);
  ~SimbodyMachine();
  SimbodyMachine(SimbodyMachine&&) noexcept;
  SimbodyMachine& operator=(SimbodyMachine&&) noexcept;

  /// Sets the state. @param q  positions (q);  @param v  velocities (v)
  void set_state(const Eigen::VectorXd& q, const Eigen::VectorXd& v);

  /// Returns the pose of a body in the world.
  [[nodiscard]] Pose<double> pose(int body) const;
  /// Computes the kinetic energy [J].
  [[nodiscard]] double kinetic_energy() const;
  /// Computes the mass matrix (v, v).
  [[nodiscard]] Eigen::MatrixXd mass_matrix() const;

  /// Computes the accelerations under generalized forces, weights and loads [rad/s^2], [m/s^2] (v).
  /// @param tau      generalized forces [N m] or [N] (v)
  /// @param gravity  acceleration of free fall [m/s^2] (3)
  [[nodiscard]] Eigen::VectorXd accelerations(const Eigen::VectorXd& tau,
                                              const Eigen::Vector3d& gravity,
                                              const std::vector<BodyLoad>& loads = {});

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace thenar
