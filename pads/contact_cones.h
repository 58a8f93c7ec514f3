#pragma once

/// Contact of many nodes with exact friction cones, on a body that answers forces linearly.

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

/// A body's tangent, and what unit forces on nodes of its surface do, found where it is asked for.
class CondensedBody {
 public:
  explicit CondensedBody(const TissueBody& body) : pattern_(body.pattern()) {}

  /// Factors a tangent. @return whether it is positive definite
  [[nodiscard]] bool factor(const std::vector<double>& values);
  [[nodiscard]] bool has_factor() const { return has_factor_; }
  [[nodiscard]] int size() const { return pattern_.size; }
  /// Entries of the tangent that was taken last.
  [[nodiscard]] const std::vector<double>& values() const { return values_; }
  /// Displacements by forces on free nodes (3 free nodes).
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& force) const;
  /// Finds what unit forces on nodes of the surface do, where it is not known.
  /// @param surface  of the body, the same in all calls
  void condense(const ContactSurface& surface, const std::vector<int>& nodes);
  /// Displacements of all nodes of the surface by unit forces on one that was condensed
  /// (3 nodes, 3).
  [[nodiscard]] auto answer_to(int node) const {
    return answers_.middleCols<3>(3 * place_[static_cast<std::size_t>(node)]);
  }

 private:
  SymmetricPattern pattern_;
  std::optional<SparseCholesky> factor_;
  bool has_factor_ = false;
  std::vector<double> values_;
  std::vector<int> place_;   // of a node's answers among them, -1: not known (nodes)
  Eigen::MatrixXd answers_;  // of known nodes (3 nodes, 3 known)
};

/// Solves for contact forces on a CondensedBody.
class ContactCones {
 public:
  explicit ContactCones(const TissueBody& body) : body_(body) {}

  /// Factors the tangent of the tissue, or a tangent with springs between nodes and the object,
  /// which a body may need to be stable: they resist motion alone, so that they change the way to
  /// rest.
  /// @param springs  direction times the root of the stiffness that `values` have [(N/m)^1/2] (3,
  /// nodes), or none (3, 0)
  /// @return whether it is positive definite
  [[nodiscard]] bool factor(const std::vector<double>& values, const Eigen::Matrix3Xd& springs);
  [[nodiscard]] const CondensedBody& body() const { return body_; }

  /// An object that a spring holds where it is while a force pushes it into the body: with a spring
  /// that is soft beside the body, the motion is that of the force alone.
  struct Drive {
    Eigen::Vector3d along;  // unit, of the force and the motion (3)
    double force;           // [N]
    double spring;          // above 0 [N/m]
    double longest;         // motion [m]
  };
  /// State of the contact between nodes and object at an iterate.
  struct Iterate {
    const Eigen::VectorXd& force;   // of the tissue on its free nodes [N] (3 free nodes)
    const MeanGaps& gaps;           // of the surface's nodes
    const Eigen::Matrix3Xd& slip;   // since the last step, tangential [m] (3, nodes)
    const Eigen::VectorXd& normal;  // forces from which to start [N] (nodes)
    const Eigen::Matrix3Xd& shear;  // friction from which to start [N] (3, nodes)
    double friction;                // [1]
    std::optional<Drive> drive;     // none: the object stays
  };
  /// Equilibrium of the linear body, the result of solve().
  struct Rest {
    Status status = Status::kStalled;
    Eigen::VectorXd dx;      // from the iterate [m] (3 free nodes)
    Eigen::VectorXd normal;  // [N] (nodes)
    Eigen::Matrix3Xd shear;  // [N] (3, nodes)
    double motion = 0;       // of the object along its drive [m]
  };
  /// Solves  A dx + force = J' f  with the tangent A, slopes J of gaps and slips, and
  /// 0 <= normal _|_ gap >= 0, |shear| <= friction normal, shear against the slip, at the end:
  /// a ContactProblem with W = J A^-1 J'. Nodes that are open join once they would be inside.
  /// Source: [AlartCurnier1991] for the problem.
  [[nodiscard]] Rest solve(const ContactSurface& surface, const Iterate& at);

 private:
  /// The contact problem of nodes that touch, and its start.
  void set_problem(const ContactSurface& surface, const Iterate& at, const Eigen::Matrix3Xd& moved,
                   const Eigen::VectorXd& gaps, const std::vector<int>& touching);
  /// Answers the problem, f; with a drive the object's motion as well.
  Status answer(const ContactSurface& surface, const Iterate& at, Rest& rest);

  CondensedBody body_;
  Eigen::Matrix3Xd springs_;
  ContactSolver solver_;
  ContactProblem problem_;
  Eigen::MatrixXd J_;  // slopes of the problem's rows (rows, 3 nodes)
  Eigen::VectorXd start_, f_;
};

/// Touching nodes at a solved state, for contact_stiffness().
struct TouchingNodes {
  std::vector<int> nodes;         // of the surface
  std::vector<bool> sticks;       // (nodes)
  Eigen::Matrix3Xd along_normal;  // force by normal force: what friction adds of those that slip
                                  // [1] (3, nodes)
};

/// Slope of the push by motions of the object: nodes that stick go with it, those that slip keep
/// their gap and their friction per normal force; forces turn with the object.
///   A u = F' f + turn,   J (u - rigid) = 0,
/// with rows J of gaps and of slips of nodes that stick, and directions F of their forces, which
/// are J but for the friction of nodes that slip.
/// @param places  of the nodes [m] (3, nodes of the surface);  @param forces  on them [N]
/// @return moment and turn first, about the body's origin (6, 6)
[[nodiscard]] Eigen::Matrix<double, 6, 6> contact_stiffness(
    CondensedBody& body, const ContactSurface& surface, const MeanGaps& gaps,
    const TouchingNodes& touching, const Eigen::Matrix3Xd& places, const Eigen::Matrix3Xd& forces);

/// Response of the surface's nodes to a motion of the object.
struct PushAnswer {
  Eigen::Matrix3Xd gained;  // forces on them [N] (3, nodes)
  Eigen::Matrix3Xd moved;   // (3, nodes)
};

/// Slope of the push by unit motions of the object, forces turning with it.
/// @param places  of the nodes [m] (3, nodes);  @param forces  on them [N] (3, nodes)
/// @param answer  to a motion at the nodes, and to how forces on them turn (3, nodes)
/// @return moment and turn first, about the body's origin (6, 6)
[[nodiscard]] Eigen::Matrix<double, 6, 6> push_slope(
    const Eigen::Matrix3Xd& places, const Eigen::Matrix3Xd& forces,
    const std::function<PushAnswer(const Eigen::Matrix3Xd& rigid, const Eigen::Matrix3Xd& turned)>&
        answer);

}  // namespace thenar
