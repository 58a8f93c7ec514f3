#include "contact/contact_newton.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

namespace thenar::internal {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Ref;
using Eigen::Vector3d;
using Eigen::VectorXd;

// Proximal terms over the diagonal of A, which is 1 [1]
constexpr double kMinProximal = 1e-10;        // smallest term, which guards against a singular A
constexpr double kMaxRefinedProximal = 1e-8;  // largest term whose effect is refined away
constexpr int kNewtonRefinements = 2;         // refinements of the solution with such a term

/// Returns unit vectors perpendicular to the unit vector d: two in three dimensions, one in two.
Eigen::Matrix<double, 3, 2> perpendicular(const Vector3d& d, int tangents) {
  Eigen::Matrix<double, 3, 2> P = Eigen::Matrix<double, 3, 2>::Zero();
  // Quarter turn in a plane.
  if (tangents == 2) {
    P.col(0) = Vector3d(-d.y(), d.x(), 0);
    return P;
  }
  // Cross product in space, with the axis that is farthest from d.
  Index least = 0;
  d.cwiseAbs().minCoeff(&least);
  P.col(0) = d.cross(Vector3d::Unit(least)).normalized();
  P.col(1) = d.cross(P.col(0));
  return P;
}

}  // namespace

void ContactNewton::assign(const ScaledContacts& contacts) {
  const Index n = contacts.rows();
  if (n <= rhs_.size()) return;
  R_.resize(n, n);
  factor_.resize(n, n);
  for (VectorXd* v : {&column_, &rhs_, &y_, &remainder_, &f_before_}) v->resize(n);
  unknowns_.reserve(static_cast<std::size_t>(n));
  slips_.reserve(contacts.blocks().size());
}

void ContactNewton::add_zero_velocity_row(int row) {
  Unknown unknown;
  unknown.start = row;
  unknown.impulse(0) = unknown.velocity(0) = 1;
  unknowns_.push_back(unknown);
}

void ContactNewton::add_slip_unknowns(SlippingContact* contact, double fn,
                                      const Ref<const VectorXd>& u) {
  const int i = contact->start, tangents = contact->rows - 1;
  contact->P = perpendicular(contact->d, tangents);
  contact->first = static_cast<int>(unknowns_.size());

  // First unknown: fn along the generator (1, -mu d) of the cone; its equation is un = 0.
  Unknown unknown;
  unknown.start = i;
  unknown.rows = contact->rows;
  unknown.impulse(0) = unknown.velocity(0) = 1;
  unknown.impulse.tail<3>() = -contact->mu * contact->d;
  unknowns_.push_back(unknown);

  // Other unknowns: y = -(mu fn + slip) times the rotation of d. Friction changes by share y, and
  // the equation  P' ut = slip times the rotation  adds 1 - share to the diagonal.
  const double slip = std::max(contact->d.head(tangents).dot(u.segment(i + 1, tangents)), 0.0);
  const double friction = contact->mu * fn, sum = friction + slip;
  const double share = sum > 0 ? friction / sum : 1;
  contact->rotation = sum > 0 ? -1 / sum : 0;
  for (int k = 0; k + 1 < tangents; ++k) {
    Unknown turn;
    turn.start = i;
    turn.rows = contact->rows;
    turn.impulse.tail<3>() = share * contact->P.col(k);
    turn.velocity.tail<3>() = contact->P.col(k);
    turn.diagonal = 1 - share;
    unknowns_.push_back(turn);
  }
}

void ContactNewton::classify_cone(const ScaledBlock& block, Ref<VectorXd> f,
                                  const Ref<const VectorXd>& u) {
  const int i = block.start, tangents = block.rows - 1;
  // Open, by the trial point p = f - u: f = 0.
  const double p_n = f(i) - u(i);
  if (p_n <= 0) {
    f.segment(i, block.rows).setZero();
    return;
  }
  // Stick: an unknown for each row, with the equation u = 0.
  Vector3d p_t = Vector3d::Zero();
  p_t.head(tangents) = f.segment(i + 1, tangents) - u.segment(i + 1, tangents);
  const double norm = p_t.norm();
  if (norm <= block.mu * p_n) {
    for (int k = 0; k < block.rows; ++k) add_zero_velocity_row(i + k);
    return;
  }
  // Slip: project f onto the cone, opposite to d.
  SlippingContact contact;
  contact.start = i;
  contact.rows = block.rows;
  contact.mu = block.mu;
  contact.d = -p_t / norm;
  f(i) = std::max(f(i), 0.0);
  f.segment(i + 1, tangents) = -block.mu * f(i) * contact.d.head(tangents);
  slips_.push_back(contact);
}

void ContactNewton::classify_blocks(const ScaledContacts& contacts, Ref<VectorXd> f,
                                    const Ref<const VectorXd>& u) {
  unknowns_.clear();
  slips_.clear();
  for (const ScaledBlock& block : contacts.blocks()) {
    if (block.is_cone()) {
      classify_cone(block, f, u);
      continue;
    }
    // Interval: at a bound if f - u exceeds it, otherwise free with u = 0.
    const double p = f(block.start) - u(block.start);
    if (p <= block.lower)
      f(block.start) = block.lower;
    else if (p >= block.upper)
      f(block.start) = block.upper;
    else
      add_zero_velocity_row(block.start);
  }
}

void ContactNewton::assemble(const ScaledContacts& contacts, const Ref<const VectorXd>& u) {
  const auto A = contacts.A();
  const auto k = static_cast<Index>(unknowns_.size());
  auto column = column_.head(contacts.rows());
  for (Index j = 0; j < k; ++j) {
    // Velocities of all rows by a unit of unknown j.
    const Unknown& unknown = unknowns_[j];
    column = unknown.impulse(0) * A.col(unknown.start);
    for (int r = 1; r < unknown.rows; ++r)
      if (unknown.impulse(r) != 0) column += unknown.impulse(r) * A.col(unknown.start + r);

    // Column j of the system, by the equations of all unknowns.
    for (Index i = 0; i < k; ++i) {
      const Unknown& row = unknowns_[i];
      R_(i, j) = row.rows == 1
                     ? column(row.start)
                     : row.velocity.head(row.rows).dot(column.segment(row.start, row.rows));
    }
    R_(j, j) += unknown.diagonal;
    rhs_(j) = -unknown.velocity.head(unknown.rows).dot(u.segment(unknown.start, unknown.rows));
  }
}

bool ContactNewton::solve_linear(double proximal) {
  // Refine away a small proximal term; a large one is meant to damp the step.
  proximal = std::max(proximal, kMinProximal);
  const int refinements = proximal > kMaxRefinedProximal ? 0 : kNewtonRefinements;
  const auto k = static_cast<Index>(unknowns_.size());
  auto factor = factor_.topLeftCorner(k, k);
  const auto R = R_.topLeftCorner(k, k);
  auto y = y_.head(k), rest = remainder_.head(k);
  factor = R;
  factor.diagonal().array() += proximal;
  y.setZero();
  rest = rhs_.head(k);
  // Adds solutions of the factored system, each for what is left of the right-hand side.
  const auto refine = [&](const auto& solve_in_place) {
    for (int round = 0; round <= refinements; ++round) {
      solve_in_place();
      y += rest;
      if (round < refinements) rest = rhs_.head(k) - R.lazyProduct(y);
    }
    return y.allFinite();
  };

  // Cholesky factorization without slip, as R is then symmetric positive semidefinite.
  if (slips_.empty()) {
    Eigen::LLT<Ref<MatrixXd>> llt(factor);
    if (llt.info() == Eigen::Success) return refine([&] { llt.solveInPlace(rest); });
    factor = R;
    factor.diagonal().array() += proximal;
  }
  // LU factorization with slip, or if Cholesky fails.
  return lu_.factor(factor) && refine([&] { lu_.solve(factor, rest); });
}

void ContactNewton::update_impulses(Ref<VectorXd> f) const {
  // Unknowns of one row are changes of impulses.
  for (std::size_t j = 0; j < unknowns_.size(); ++j)
    if (unknowns_[j].rows == 1) f(unknowns_[j].start) += y_(static_cast<Index>(j));

  // Slipping contacts change fn and rotate d.
  for (const SlippingContact& contact : slips_) {
    const int tangents = contact.rows - 1;
    Vector3d d = contact.d;
    for (int k = 0; k + 1 < tangents; ++k)
      d += contact.rotation * y_(contact.first + 1 + k) * contact.P.col(k);
    d.normalize();
    // A step may make fn negative; friction is then 0 until the next classification.
    double& fn = f(contact.start);
    fn += y_(contact.first);
    f.segment(contact.start + 1, tangents) = -contact.mu * std::max(fn, 0.0) * d.head(tangents);
  }
}

bool ContactNewton::step(const ScaledContacts& contacts, double proximal, Ref<VectorXd> f,
                         Ref<VectorXd> u) {
  // Classify the blocks, which moves impulses to their bounds and cones, and update u.
  f_before_.head(f.size()) = f;
  classify_blocks(contacts, f, u);
  u.noalias() = contacts.A() * f;
  u += contacts.b();
  // Solve the linear system of the unknowns; on failure restore f.
  for (SlippingContact& contact : slips_) add_slip_unknowns(&contact, f(contact.start), u);
  assemble(contacts, u);
  if (!unknowns_.empty() && !solve_linear(proximal)) {
    f = f_before_.head(f.size());
    return false;
  }
  // Compute the new impulses and velocities.
  update_impulses(f);
  u.noalias() = contacts.A() * f;
  u += contacts.b();
  return true;
}

}  // namespace thenar::internal
