#pragma once

/// Contact of many nodes with exact friction cones, on a linearized body.

#include <functional>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "base/spatial.h"
#include "contact/contact_solver.h"
#include "pads/contact_surface.h"
#include "solvers/sparse/sparse_cholesky.h"
#include "solvers/status.h"

namespace thenar {

/// Tangent of a body, condensed to its surface: responses to unit forces on surface nodes, computed
/// on demand.
class CondensedBody {
 public:
  explicit CondensedBody(const TissueBody& body) : pattern_(body.pattern()) {}

  /// Factors a tangent and discards known responses.
  /// @param values  entries of the tangent [N/m], in the order of the body's pattern
  /// @return whether it is positive definite
  [[nodiscard]] bool factor(const std::vector<double>& values);
  [[nodiscard]] bool has_factor() const { return has_factor_; }
  [[nodiscard]] int size() const { return pattern_.size; }
  /// Returns the entries of the last tangent [N/m].
  [[nodiscard]] const std::vector<double>& tangent() const { return tangent_; }
  /// Returns the displacements under forces on free nodes [m] (3 free nodes).
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& force) const;
  /// Computes the responses to unit forces on surface nodes that are not known yet.
  /// @param surface  surface of the body; the same in all calls
  void condense(const ContactSurface& surface, const std::vector<int>& nodes);
  /// Returns the displacements of all surface nodes under unit forces on one condensed node [m/N]
  /// (3 nodes, 3).
  [[nodiscard]] auto unit_response(int node) const {
    return unit_responses_.middleCols<3>(3 * column_[node]);
  }

 private:
  SymmetricPattern pattern_;
  std::optional<SparseCholesky> factor_;
  bool has_factor_ = false;
  std::vector<double> tangent_;
  std::vector<int> column_;         // index of a node's response, -1: not known (nodes)
  Eigen::MatrixXd unit_responses_;  // responses of condensed nodes [m/N] (3 nodes, 3 condensed)
};

/// Solver for contact forces within exact friction cones on a CondensedBody.
class ContactCones {
 public:
  explicit ContactCones(const TissueBody& body) : body_(body) {}

  /// Factors the tangent of the tissue. A body that is unstable without contact may need springs
  /// between nodes and object in its tangent. The springs resist motion only, so they change the
  /// iterations but not the equilibrium.
  /// @param springs  direction times root of the stiffness of the springs that `values` contain
  /// [(N/m)^1/2] (3, nodes), or none (3, 0)
  /// @return whether the tangent is positive definite
  [[nodiscard]] bool factor(const std::vector<double>& values, const Eigen::Matrix3Xd& springs);
  [[nodiscard]] const CondensedBody& body() const { return body_; }

  /// Force that pushes the object into the body while a spring holds the object. If the spring is
  /// soft compared with the body, the motion is close to that under the force alone.
  struct Drive {
    Eigen::Vector3d direction;  // direction of the force and the motion, unit (3)
    double force;               // [N]
    double spring_stiffness;    // above 0 [N/m]
    double max_motion;          // bound of the motion [m]
  };
  /// Linearized contact between nodes and object at an iterate.
  struct Iterate {
    const Eigen::VectorXd& tissue_force;     // elastic force on the free nodes [N] (3 free nodes)
    const MeanGaps& gaps;                    // gaps of the surface nodes
    const Eigen::Matrix3Xd& slip;            // tangential slip since the last step [m] (3, nodes)
    const Eigen::VectorXd& normal_force;     // warm start [N] (nodes)
    const Eigen::Matrix3Xd& friction_force;  // warm start [N] (3, nodes)
    double friction;                         // Coulomb coefficient [1]
    std::optional<Drive> drive;              // none: the object is fixed
  };
  /// Equilibrium of the linear body, the result of solve().
  struct Equilibrium {
    Status status = Status::kStalled;
    Eigen::VectorXd dx;               // displacement from the iterate [m] (3 free nodes)
    Eigen::VectorXd normal_force;     // [N] (nodes)
    Eigen::Matrix3Xd friction_force;  // [N] (3, nodes)
    double object_motion = 0;         // motion of the object along its drive [m]
  };
  /// Solves  A dx + force = J' f  with the tangent A, gradients J of gaps and slips, and, at the
  /// end of the motion,  0 <= normal force _|_ gap >= 0,  |friction| <= mu normal force,  and
  /// friction opposed to the slip: a ContactProblem with  W = J A^-1 J'.  Open nodes join the
  /// problem once they would penetrate the object. Source: [AlartCurnier1991] for the problem.
  [[nodiscard]] Equilibrium solve(const ContactSurface& surface, const Iterate& iterate);

 private:
  /// Builds the contact problem of the touching nodes and its warm start.
  /// @param moved  displacements of the surface nodes without contact [m] (3, nodes)
  /// @param gaps   gaps after these displacements [m] (nodes)
  void build_problem(const ContactSurface& surface, const Iterate& iterate,
                     const Eigen::Matrix3Xd& moved, const Eigen::VectorXd& gaps,
                     const std::vector<int>& touching);
  /// Solves the contact problem for the forces f and, with a drive, the motion of the object.
  Status solve_problem(const ContactSurface& surface, const Iterate& iterate,
                       Equilibrium& equilibrium);

  CondensedBody body_;
  Eigen::Matrix3Xd springs_;
  ContactSolver solver_;
  ContactProblem problem_;
  Eigen::MatrixXd J_;  // gradients of the problem's rows (rows, 3 nodes)
  Eigen::VectorXd initial_forces_, f_;
};

/// Touching nodes at a solved state, for contact_stiffness().
struct TouchingNodes {
  std::vector<int> nodes;           // indices of the surface nodes
  std::vector<bool> sticks;         // (nodes)
  Eigen::Matrix3Xd friction_ratio;  // friction force over normal force [1] (3, nodes)
};

/// Returns the slope of the object's wrench by its motion. Sticking nodes move with the object;
/// slipping nodes keep their gap and their friction per normal force; contact forces turn with the
/// object:
///   A u = F' f + turn,   J (u - rigid) = 0,
/// with rows J of gaps and of slips of sticking nodes, and directions F of their forces, which
/// differ from J by the friction of slipping nodes.
/// @param places  positions of the nodes [m] (3, surface nodes)
/// @param forces  contact forces on them [N] (3, surface nodes)
/// @return moment and rotation first, about the body's origin (6, 6)
[[nodiscard]] Eigen::Matrix<double, 6, 6> contact_stiffness(
    CondensedBody& body, const ContactSurface& surface, const MeanGaps& gaps,
    const TouchingNodes& touching, const Eigen::Matrix3Xd& places, const Eigen::Matrix3Xd& forces);

/// Response of the surface nodes to a motion of the object.
struct MotionResponse {
  Eigen::Matrix3Xd force_change;  // change of the forces on them [N] (3, nodes)
  Eigen::Matrix3Xd displacement;  // [m] (3, nodes)
};

/// Returns the slope of the object's wrench by unit motions of the object, whose contact forces
/// turn with it.
/// @param places  positions of the nodes [m] (3, nodes)
/// @param forces  contact forces on them [N] (3, nodes)
/// @param response  response to a rigid motion at the nodes and to the turn of their forces (3,
///         nodes)
/// @return moment and rotation first, about the body's origin (6, 6)
[[nodiscard]] Eigen::Matrix<double, 6, 6> object_stiffness(
    const Eigen::Matrix3Xd& places, const Eigen::Matrix3Xd& forces,
    const std::function<MotionResponse(const Eigen::Matrix3Xd& rigid,
                                       const Eigen::Matrix3Xd& turned)>& response);

}  // namespace thenar
