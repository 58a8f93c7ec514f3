#include "grasp/limits/force_set.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <Eigen/Eigenvalues>

#include "base/error.h"
#include "grasp/limits/contact_support.h"
#include "grasp/limits/joint_limits.h"

namespace thenar {
namespace {

// Squared wrenches below this fraction of the largest count as zero [1]
constexpr double kZeroWrench = 1e-14;
constexpr double kPositionError = 1e-4;  // uncertainty of contact positions over the scale [1]

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using internal::append_limit;
using internal::append_variables;

void check(const WrenchSet& set, const MatrixXd& T, const Actuation& a) {
  const Index joints = a.B.rows(), actuators = a.B.cols();
  Index forces = 0;
  for (const WrenchCap& cap : set.caps) forces += 1 + cap.A.cols();
  require(T.cols() == forces, "T has {} columns, the contacts {} forces", T.cols(), forces);
  require(T.rows() == joints && a.tau_0.size() == joints, "T, B, tau_0 have {}, {}, {} coordinates",
          T.rows(), joints, a.tau_0.size());
  require(a.lower.size() == actuators && a.upper.size() == actuators,
          "B has {} actuators, its limits {} and {}", actuators, a.lower.size(), a.upper.size());
  require(T.allFinite() && a.B.allFinite() && a.tau_0.allFinite(), "T, B and tau_0 must be finite");
  for (Index i = 0; i < actuators; ++i)
    require(a.lower(i) <= a.upper(i), "actuator {} has limits {} and {}", i, a.lower(i),
            a.upper(i));
  const Reactions& reactions = a.reactions;
  const Index count = reactions.lower.size();
  require(reactions.upper.size() == count && (count == 0 || reactions.R.rows() == joints) &&
              reactions.R.cols() == count && reactions.R.allFinite(),
          "wanted R of {} x {} finite numbers and as many limits, got {} x {} and {}", joints,
          count, reactions.R.rows(), reactions.R.cols(), reactions.upper.size());
  for (Index i = 0; i < count; ++i)
    require(reactions.lower(i) <= reactions.upper(i), "reaction {} has limits {} and {}", i,
            reactions.lower(i), reactions.upper(i));
  for (const int coordinate : reactions.non_backdrivable)
    require(coordinate >= 0 && coordinate < joints, "held coordinate {} of {}", coordinate, joints);
}

/// Returns the largest finite limit, which scales efforts to order one; 1 if there is none.
double effort_unit_of(double lower, double upper) {
  double unit = 0;
  for (const double limit : {lower, upper})
    if (std::isfinite(limit)) unit = std::max(unit, std::abs(limit));
  return unit > 0 ? unit : 1;
}

/// Adds the variables p: passive normal forces of contacts that exist already, one column each with
/// the frictionless unit wrench of its contact, never negative.
void add_passive_forces(ForceSet& forces, const WrenchSet& set,
                        const std::vector<int>& passive_contacts) {
  const Index first = forces.wrench.cols(), count = static_cast<Index>(passive_contacts.size());
  append_variables(forces, count);
  for (Index i = 0; i < count; ++i) {
    const Index column = first + i;
    forces.wrench.col(column) = set.caps[passive_contacts[i]].c.vector();
    forces.normals(column) = 1;
    append_limit(forces, -Eigen::RowVectorXd::Unit(forces.wrench.cols(), column), 0);
  }
  forces.passive_contacts = passive_contacts;
}

/// Sets  T x - B u - R r = tau_0,  each row divided by its largest coefficient.
void balance_torques(ForceSet& forces, const internal::JointLoads& joint_loads,
                     const Actuation& a) {
  const auto rows = static_cast<Index>(joint_loads.rows.size());
  // Columns in the order of y = (x, p, v, r).
  forces.A.resize(rows, forces.wrench.cols());
  forces.A << joint_loads.x(joint_loads.rows, Eigen::all),
      joint_loads.p(joint_loads.rows, Eigen::all),
      -a.B(joint_loads.rows, Eigen::all) * forces.effort_unit.asDiagonal(),
      -reactions_on(a.reactions, joint_loads.rows);
  forces.b = a.tau_0(joint_loads.rows);
  // Scale each row to a largest coefficient of 1.
  for (Index i = 0; i < forces.A.rows(); ++i) {
    const double largest = forces.A.row(i).cwiseAbs().maxCoeff();
    forces.A.row(i) /= largest;
    forces.b(i) /= largest;
  }
}

/// Adds  lower <= unit y_i <= upper,  for finite limits.
void add_bounds(ForceSet& forces, Index i, double lower, double upper, double unit) {
  const Eigen::RowVectorXd one = Eigen::RowVectorXd::Unit(forces.wrench.cols(), i);
  if (std::isfinite(upper)) append_limit(forces, one, upper / unit);
  if (std::isfinite(lower)) append_limit(forces, -one, -lower / unit);
}

/// Returns the loads of a contact's variables about the contact: columns (torque, force) as the
/// rows of a spatial Jacobian (6, size).
MatrixXd local_loads(const Contact& contact) {
  const Tangents t = tangents(contact.n);
  const int slides = contact.friction > 0 ? 2 : 0, twists = contact.torsion > 0 ? 1 : 0;
  MatrixXd loads = MatrixXd::Zero(6, 1 + slides + twists);
  loads.col(0).tail<3>() = contact.n;
  if (slides > 0) loads.block<3, 2>(3, 1) << contact.friction * t.e1, contact.friction * t.e2;
  if (twists > 0) loads.col(loads.cols() - 1).head<3>() = contact.torsion * contact.n;
  return loads;
}

}  // namespace

ForceSet free_forces(const WrenchSet& set) {
  ForceSet forces;
  forces.contacts = static_cast<int>(set.caps.size());
  // Without a hand there is no balance; each contact's variables are in its cone.
  forces.wrench = wrench_columns(set);
  const Index n = forces.wrench.cols();
  forces.normals.setZero(n);
  forces.A.resize(0, n);
  forces.b.resize(0);
  forces.G = -MatrixXd::Identity(n, n);
  forces.h.setZero(n);
  // Columns of each cap: frictionless unit wrench, then its semi-axes.
  Index column = 0;
  for (const WrenchCap& cap : set.caps) {
    forces.normals(column) = 1;
    forces.cones.push_back(1 + static_cast<int>(cap.A.cols()));
    forces.patch.push_back(cap.contact);
    column += 1 + cap.A.cols();
  }
  return forces;
}

ForceSet unit_forces(const WrenchSet& set, ForceNorm limit) {
  ForceSet forces = free_forces(set);
  const Index n = forces.normals.size();
  // L1: one limit of the sum of all normal forces.
  if (limit == ForceNorm::kL1) {
    append_limit(forces, forces.normals, 1);
    return forces;
  }
  // Linf: one limit for each patch, of the sum over its points.
  std::map<int, Eigen::RowVectorXd> shared;  // sums of caps that share a limit
  Index column = 0;
  for (const WrenchCap& cap : set.caps) {
    const Eigen::RowVectorXd normal = Eigen::RowVectorXd::Unit(n, column);
    column += 1 + cap.A.cols();
    if (cap.contact < 0)
      append_limit(forces, normal, 1);
    else
      shared.try_emplace(cap.contact, Eigen::RowVectorXd::Zero(n)).first->second += normal;
  }
  for (const auto& [contact, sum] : shared) append_limit(forces, sum, 1);
  return forces;
}

ForceSet hand_forces(const WrenchSet& set, const MatrixXd& T, const Actuation& actuation,
                     double preload_slack) {
  check(set, T, actuation);
  const Reactions& reactions = actuation.reactions;
  const internal::JointLoads joint_loads = internal::find_contact_support(set, T, reactions);
  // Variables x of the cones, then p of passive forces.
  ForceSet forces = free_forces(set);
  add_passive_forces(forces, set, joint_loads.passive_contacts);
  // Variables v of efforts and r of reactions, tied to the contacts by the balance of torques.
  const Index efforts = forces.wrench.cols(), actuators = actuation.B.cols();
  append_variables(forces, actuators + reactions.R.cols());
  forces.effort_unit.resize(actuators);
  for (Index i = 0; i < actuators; ++i)
    forces.effort_unit(i) = effort_unit_of(actuation.lower(i), actuation.upper(i));
  balance_torques(forces, joint_loads, actuation);
  // Limits of actuators and reactions.
  for (Index i = 0; i < actuators; ++i)
    add_bounds(forces, efforts + i, actuation.lower(i), actuation.upper(i), forces.effort_unit(i));
  for (Index i = 0; i < reactions.R.cols(); ++i)
    add_bounds(forces, efforts + actuators + i, reactions.lower(i), reactions.upper(i), 1);
  return internal::limit_preload(std::move(forces), joint_loads, actuation, preload_slack);
}

ScaledWrench resistible_part(const ForceSet& forces, const ScaledWrench& load) {
  // Directions without a wrench, by the squared wrenches along them.
  const Eigen::SelfAdjointEigenSolver<MatrixXd> axes(
      MatrixXd(forces.wrench * forces.wrench.transpose()));
  WrenchCoordinates resisted = load.vector();
  for (Index k = 0; k < 6; ++k) {
    if (axes.eigenvalues()[k] > kZeroWrench * axes.eigenvalues()[5]) break;
    const WrenchCoordinates way = axes.eigenvectors().col(k);
    const double along = way.dot(load.vector());
    if (std::abs(along) <= kPositionError * load.norm()) resisted -= along * way;
  }
  return ScaledWrench::from_coordinates(resisted);
}

ForceSet active_only(ForceSet forces) {
  const Index pressed = forces.wrench.cols();
  Index first = 0;  // first entry of p, after x
  // Passive forces p follow the contacts' own variables; set each to zero.
  for (int contact = 0; contact < forces.contacts; ++contact) first += forces.cones[contact];
  for (std::size_t i = 0; i < forces.passive_contacts.size(); ++i)
    append_limit(forces, Eigen::RowVectorXd::Unit(pressed, first + static_cast<Index>(i)), 0);
  return forces;
}

MatrixXd torque_map(const Hand& hand, const VectorXd& q, const std::vector<HandContact>& contacts,
                    const Pose<double>& X_HO) {
  const std::vector<Pose<double>> poses = hand.pose(q);
  MatrixXd T(q.size(), 0);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const auto surface = static_cast<std::size_t>(contacts[i].surface);
    require(surface < hand.surfaces().size(), "contact {} is at surface {} of {}", i,
            contacts[i].surface, hand.surfaces().size());
    // Point and loads in the frame of the hand. The tangents of the loads are the object's, as in
    // the wrench set: rotating the normal first would give others.
    const Eigen::Vector3d p_H = X_HO * contacts[i].contact.p;
    MatrixXd loads = local_loads(contacts[i].contact);
    loads.topRows<3>() = X_HO.R * loads.topRows<3>();
    loads.bottomRows<3>() = X_HO.R * loads.bottomRows<3>();
    const int link = hand.surfaces()[surface].link;
    MatrixXd torques = MatrixXd::Zero(q.size(), loads.cols());
    // Transposed Jacobian of the contact point; a palm that cannot move has none.
    if (link >= 0) {
      const Eigen::Vector3d reference = poses[link].inverse() * p_H;
      torques = hand.jacobian(q, link, reference).transpose() * loads;
    }
    T.conservativeResize(q.size(), T.cols() + loads.cols());
    T.rightCols(loads.cols()) = torques;
  }
  return T;
}

ContactForces contact_forces(const ForceSet& set, const VectorXd& y) {
  ContactForces result{{}, VectorXd(set.contacts), VectorXd(set.effort_unit.size())};
  Index column = 0;
  // Active force of each contact.
  for (int i = 0; i < set.contacts; ++i) {
    const int size = set.cones[i];
    result.wrenches.push_back(ScaledWrench::from_coordinates(set.wrench.middleCols(column, size) *
                                                             y.segment(column, size)));
    result.normal(i) = y(column);
    column += size;
  }
  // Passive forces are added to the contacts that carry them.
  for (const int contact : set.passive_contacts) {
    result.wrenches[contact] += ScaledWrench::from_coordinates(set.wrench.col(column) * y(column));
    result.normal(contact) += y(column++);
  }
  // Efforts in SI units.
  result.efforts = set.effort_unit.cwiseProduct(y.segment(column, set.effort_unit.size()));
  return result;
}

}  // namespace thenar

namespace thenar::internal {

using Eigen::Index;

void append_variable(ConeProgram& program) {
  append_entry(program.c, 0);
  append_column(program.A, Eigen::VectorXd::Zero(program.A.rows()));
  append_column(program.G, Eigen::VectorXd::Zero(program.G.rows()));
}

void append_variables(ForceSet& forces, Index count) {
  // New columns are zero: no limit and no balance uses them yet.
  const Index n = forces.wrench.cols();
  forces.wrench.conservativeResize(6, n + count);
  forces.wrench.rightCols(count).setZero();
  forces.A.conservativeResize(forces.A.rows(), n + count);
  forces.A.rightCols(count).setZero();
  forces.G.conservativeResize(forces.G.rows(), n + count);
  forces.G.rightCols(count).setZero();
  forces.normals.conservativeResize(n + count);
  forces.normals.tail(count).setZero();
}

}  // namespace thenar::internal
