#pragma once

/// Iterate of a step of a press: where body and object are, what tissue answers, what is out of
/// balance. The methods that solve a step (press_newton.h, press_cones.h, press_springs.h) go from
/// one to the next.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "pads/press_problem.h"
#include "pads/skin_springs.h"

namespace thenar {

/// Contact of one node at an iterate.
struct TouchingNode {
  double push = 0;                 // normal force [N]
  Eigen::Vector3d shear{0, 0, 0};  // [N]
  bool slips = false;              //
  Eigen::Vector3d way{0, 0, 0};    // of friction on a node that slips, unit
  Eigen::Vector3d last{0, 0, 0};   // the same of the last iterate, over the bound: at most as long
  double cut = 1;  // share that its cone leaves of the force of a node that sticks [1]
};

struct PressIterate : PressProblem {
  PressIterate(const PressProblem& problem, PressFactors& factors);

  /// Resets the state to the start of the step, with the object at its goal.
  void restart();

  /// Returns whether there is another iteration; if not, `out` says why.
  [[nodiscard]] bool goes_on(PressOutcome& out) const;

  /// Sets what tissue answers where it is, or, where an element would turn inside out, less far on.
  /// @param dx  the last motion, may be empty: becomes what is left of it
  /// @param u   displacements of all nodes [m] (3, nodes)
  bool respond(ElementAsk ask, Eigen::VectorXd& dx, Eigen::Matrix3Xd& u, PressOutcome& out);

  /// Measures forces on free nodes that are out of balance, and the push along the goal's
  /// direction.
  /// @param forces  along normals, on nodes of the surface [N] (3, nodes)
  void measure(const Eigen::Matrix3Xd& forces, PressOutcome& out);
  [[nodiscard]] bool is_solved(const PressOutcome& out) const;

  /// Ends a step that is solved, unless the object came through the surface.
  void end(const Eigen::Matrix3Xd& u, PressOutcome& out) const;

  /// Moves the object, not far off or off what it touched, to where it touches.
  /// @return false if it is farther off
  bool go_to_touch(PressOutcome& out);

  /// Sets the stiffness of contacts above that of tissue at rest, and above that of the body as it
  /// is: a squeezed body is stiffer by its law and by its bulk modulus, and may be stable by the
  /// contact alone.
  /// @param values  of a tangent
  void find_stiffness(const std::vector<double>& values);

  /// Factors the tangent, or, where it is not positive definite, the tangent with the least springs
  /// of some powers of ten that hold all nodes where they are: steps become shorter.
  bool factored(const std::function<bool()>& factor);
  /// Adds a symmetric block of a node of the surface to the tangent.
  void add_block(std::size_t k, const Eigen::Matrix3d& block);

  /// Solves for the object's motion along the goal's direction, one more unknown of a step that is
  /// to reach a force.
  /// @param dx      in: with the object at rest
  /// @param loss    of contact forces as nodes move against the object [N] (3, nodes)
  /// @param solve   with the matrix of this iteration
  /// @param motion  of the object [m]
  bool reach_force(const std::function<Eigen::Matrix3Xd(const Eigen::Matrix3Xd&)>& loss,
                   const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& solve,
                   Eigen::VectorXd& dx, double& motion) const;

  /// Solves with the factor and with what it leaves out of contacts, by iterations.
  /// @param left_out  of the loss of forces as nodes move [N] (3, nodes)
  [[nodiscard]] Eigen::VectorXd solve_with(
      const Eigen::VectorXd& b,
      const std::function<Eigen::Matrix3Xd(const Eigen::Matrix3Xd&)>& left_out) const;

  /// Place of a node of the surface [m] (3).
  [[nodiscard]] Eigen::Vector3d place_of(std::size_t k) const;
  /// Part of a vector across the object's normal at a node.
  [[nodiscard]] Eigen::Vector3d across(std::size_t k, const Eigen::Vector3d& v) const;
  /// Slip of a node since the last step, tangential [m] (3).
  [[nodiscard]] Eigen::Vector3d slip_of(std::size_t k) const;
  /// Displacements of the nodes of the surface by those of the body [m] (3, nodes).
  [[nodiscard]] Eigen::Matrix3Xd on_surface(const Eigen::VectorXd& x) const;
  /// Forces on the body by those on nodes of its surface [N] (3 free nodes).
  [[nodiscard]] Eigen::VectorXd on_body(const Eigen::Matrix3Xd& forces) const;

  PressFactors& factors;
  PressState now;
  MeanGaps gaps;
  std::optional<SkinSprings> springs;  // where there are edges
  std::vector<TouchingNode> contacts;  // (surface nodes)
  std::vector<double> stiffness;       // of contacts [N/m] (surface nodes)
  TissueResponse tissue;
  Eigen::VectorXd residual;  // forces out of balance [N] (3 free nodes)
  Wrench push;               // of the object on the body
  double scale = 0;          // sum of contact forces [N]
  double missing = 0;        // of the force that is wanted [N]
  double change = 0;         // largest of a contact force since the last iterate [N]
  double rounding = 0;       // of contact forces [N]
  double longest = 0;        // motion of the object in an iteration [m]
};

}  // namespace thenar
