#pragma once

/// A mechanism as a Simbody multibody: the second machine, against which the first is held.

#include <memory>
#include <vector>

#include <Eigen/Core>

#include "dynamics/mechanism/mechanism.h"

namespace thenar {

/// A force and a moment on a body. Both in world axes.
struct BodyLoad {
  int body = -1;                    // -1: the world, which it does not move
  Eigen::Vector3d p{0, 0, 0};       // where the force acts, world [m] (3)
  Eigen::Vector3d force{0, 0, 0};   // [N] (3)
  Eigen::Vector3d moment{0, 0, 0};  // [N m] (3)
};

/// Dynamics of a mechanism by Simbody. Joints that share a coordinate are held together by
/// constraints on the first of them that follows it linearly. Owns one Simbody System and State,
/// which every call changes: one object per thread.
class SimbodyMachine {
 public:
  /// @throws InputError as check_mechanism(), or if no joint follows a shared coordinate linearly.
  explicit SimbodyMachine(const Mechanism& mechanism);
  ~SimbodyMachine();
  SimbodyMachine(SimbodyMachine&&) noexcept;
  SimbodyMachine& operator=(SimbodyMachine&&) noexcept;

  /// @param q  positions (q);  @param v  speeds (v)
  void set(const Eigen::VectorXd& q, const Eigen::VectorXd& v);

  /// Pose of a body in the world.
  [[nodiscard]] Pose<double> pose(int body) const;
  /// Kinetic energy [J].
  [[nodiscard]] double kinetic_energy() const;
  /// Mass matrix over the speeds (v, v).
  [[nodiscard]] Eigen::MatrixXd mass_matrix() const;

  /// Accelerations under efforts at the speeds, weights and loads. (v)
  /// @param tau      [N m] or [N] (v)
  /// @param gravity  of free fall [m/s^2] (3)
  [[nodiscard]] Eigen::VectorXd accelerations(const Eigen::VectorXd& tau,
                                              const Eigen::Vector3d& gravity,
                                              const std::vector<BodyLoad>& loads = {});

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace thenar
