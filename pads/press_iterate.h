#pragma once

/// Iterate of one step of a press: poses, tissue response and residual, shared by the methods that
/// solve a step (press_newton.h, press_cones.h, press_springs.h).

#include <functional>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "pads/press_problem.h"
#include "pads/skin_springs.h"

namespace thenar {

/// Contact of one surface node at an iterate.
struct SkinNodeContact {
  double normal_force = 0;                       // [N]
  Eigen::Vector3d friction_force{0, 0, 0};       // [N] (3)
  bool slips = false;                            // friction lies on its cone
  Eigen::Vector3d slip_direction{0, 0, 0};       // direction of sliding friction, unit (3)
  Eigen::Vector3d last_friction_ratio{0, 0, 0};  // friction of the last iterate over the bound of
                                                 // the cone, at most unit length [1] (3)
  double friction_scale = 1;  // friction force over the trial force of a sticking node [1]
};

/// Largest residual over that of the last iteration for which the tangent is reused [1].
inline constexpr double kTangentReuseRatio = 0.3;

/// Iterate of a press: the state of the pad and its contacts, with the linear systems of a step.
/// The solvers of a press change it in turn.
struct PressIterate : PressProblem {
  PressIterate(const PressProblem& problem, PressFactors& factors);

  /// Resets the state to the start of the step, with the object at its goal.
  void reset_to_start();

  /// Returns whether another iteration may begin. If not, sets the status and message of `out`.
  [[nodiscard]] bool may_continue(PressOutcome& out) const;

  /// Evaluates the tissue at the state. While an element is inverted, takes back half of the last
  /// motion.
  /// @param dx  last motion [m] (3 free nodes), or empty; on return the part that remains
  /// @param u   displacements of all nodes, output [m] (3, nodes)
  /// @return false, with a message in `out`, if an element stays inverted
  bool evaluate_tissue(ElementRequest request, Eigen::VectorXd& dx, Eigen::Matrix3Xd& u,
                       PressOutcome& out);

  /// Measures the residual forces on free nodes and the force of the object along the goal's
  /// direction.
  /// @param forces  normal contact forces on the surface nodes [N] (3, nodes)
  void measure_residual(const Eigen::Matrix3Xd& forces, PressOutcome& out);
  [[nodiscard]] bool is_converged(const PressOutcome& out) const;

  /// Marks the step as solved, unless object and tissue have passed through each other.
  void accept(const Eigen::Matrix3Xd& u, PressOutcome& out) const;

  /// Moves the object along the goal's direction until it touches the surface.
  /// @return false, with a message in `out`, if the object is too far away
  bool move_to_contact(PressOutcome& out);

  /// Sets the stiffness of each contact well above that of the tissue at rest and above that of
  /// the deformed body, which strain-stiffening and the bulk modulus raise.
  /// @param values  entries of the body's tangent [N/m]
  void set_node_stiffness(const std::vector<double>& values);

  /// Factors the tangent. If it is not positive definite, adds springs to its diagonal, ten times
  /// stiffer at each attempt; they shorten the step.
  /// @return whether a factor was found
  bool factor_stabilized(const std::function<bool()>& factor);
  /// Adds a symmetric block of surface node k to the tangent.
  void add_node_block(std::size_t k, const Eigen::Matrix3d& block);

  /// Solves for the motion of the object along the goal's direction, which is one more unknown of
  /// a step to a given force, and adds the body's response to the Newton step.
  /// @param loss   loss of contact forces as nodes move against the object [N] (3, nodes)
  /// @param solve  solution with the matrix of this iteration
  /// @param dx     in: Newton step with the object at rest; out: with the object moving [m]
  /// @return motion of the object, 0 in a step without a given force [m]; none: the object has no
  ///         positive stiffness
  [[nodiscard]] std::optional<double> solve_object_motion(
      const std::function<Eigen::Matrix3Xd(const Eigen::Matrix3Xd&)>& loss,
      const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& solve,
      Eigen::VectorXd& dx) const;

  /// Moves body and object, and predicts the pressure after the motion.
  /// @param u  displacements of all nodes before [m] (3, nodes)
  void advance(const Eigen::Matrix3Xd& u, const Eigen::VectorXd& dx, double object_motion);
  /// Solves a linear system by GMRES, preconditioned by the factored tangent.
  /// @param left_out  loss of contact forces that the factor leaves out [N] (3, nodes)
  [[nodiscard]] Eigen::VectorXd solve_iteratively(
      const Eigen::VectorXd& b,
      const std::function<Eigen::Matrix3Xd(const Eigen::Matrix3Xd&)>& left_out) const;

  /// Returns the deformed position of surface node k [m] (3).
  [[nodiscard]] Eigen::Vector3d node_position(std::size_t k) const;
  /// Returns the part of a vector tangential to the object at node k (3).
  [[nodiscard]] Eigen::Vector3d tangential(std::size_t k, const Eigen::Vector3d& v) const;
  /// Returns the tangential slip of node k since the last step [m] (3).
  [[nodiscard]] Eigen::Vector3d node_slip(std::size_t k) const;
  /// Returns the displacements of the surface nodes [m] (3, nodes).
  /// @param x  displacements of the free nodes [m] (3 free nodes)
  [[nodiscard]] Eigen::Matrix3Xd surface_displacements(const Eigen::VectorXd& x) const;
  /// Returns the forces on free nodes of the body [N] (3 free nodes).
  /// @param forces  forces on the surface nodes [N] (3, nodes)
  [[nodiscard]] Eigen::VectorXd body_forces(const Eigen::Matrix3Xd& forces) const;

  PressFactors& factors;
  PressState state;
  MeanGaps gaps;
  std::optional<SkinSprings> springs;     // set where an edge of the object lies over the skin
  std::vector<SkinNodeContact> contacts;  // (surface nodes)
  std::vector<double> node_stiffness;     // stiffness of the contacts [N/m] (surface nodes)
  TissueResponse tissue;
  Eigen::VectorXd residual;     // unbalanced forces [N] (3 free nodes)
  Wrench push;                  // wrench of the object on the body, about the body's origin
  double total_force = 0;       // sum of the magnitudes of contact forces [N]
  double force_deficit = 0;     // goal's force less the present force along its direction [N]
  double max_force_change = 0;  // largest change of a contact force since the last iterate [N]
  double force_rounding = 0;    // rounding error of a contact force [N]
  double max_motion = 0;        // longest motion of the object in one iteration [m]
};

}  // namespace thenar
