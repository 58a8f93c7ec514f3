#include "dynamics/stepping/contact_rows.h"

#include <algorithm>
#include <cmath>

namespace thenar {
namespace {

using RowKind = ActiveContact::Kind;

constexpr double kStickSpeed = 1e-9;  // largest speed of a sticking contact [m/s], [rad/s]
constexpr double kMeanWeight = 0.75;  // weight of this step in the mean with the previous one [1]

/// Returns the weighted mean with the previous step, which damps alternation from step to step.
/// @param before  value of the previous step; NaN: none
double damped_mean(double now, double before) {
  return std::isnan(before) ? now : kMeanWeight * now + (1 - kMeanWeight) * before;
}

/// Stores a solution in a contact of two bodies, whose mode is already kOpen or kStick by its
/// approach. @param at  first row of the contact
void store_contact(const ContactSolution& answer, const ContactBlock& block, int at,
                   ActiveContact& contact) {
  contact.impulse = answer.f[at] * contact.normal;
  if (block.law == ConstraintLaw::kUnilateral) return;
  const Tangents sides = tangents(contact.normal);
  contact.impulse += answer.f[at + 1] * sides.e1 + answer.f[at + 2] * sides.e2;
  contact.slip = std::hypot(answer.u[at + 1], answer.u[at + 2]);
  double spin = 0;
  if (block.law == ConstraintLaw::kSoftFinger) {
    contact.torsion = answer.f[at + 3];
    spin = block.torsion_radius * std::abs(answer.u[at + 3]);
  }
  if (contact.mode == ContactMode::kStick && std::max(contact.slip, spin) > kStickSpeed)
    contact.mode = ContactMode::kSlide;
}

}  // namespace

void ContactRows::assemble(const std::vector<ActiveContact>& list, double h,
                           const TreeMotion<double>& links, const MassMatrix<double>& mass) {
  // Set up blocks, then the Jacobian of each.
  int rows = 0;
  problem.blocks.clear();
  for (const ActiveContact& contact : list) {
    problem.blocks.push_back(make_block(contact, h));
    rows += row_count(problem.blocks.back().law);
  }
  Jt.setZero(model_.layout.v, rows);
  for_each_row(list, [&](const ActiveContact& contact, const ContactBlock& block, int at) {
    fill_jacobian(contact, block.law, at, links);
  });
  // Compute W = Y' Y with Y = D^-1/2 L'^-1 J', from the factor A = L' D L.
  Y_ = Jt;
  for (int i = 0; i < rows; ++i) mass.half_solve(model_, Y_.col(i));
  problem.W.resize(rows, rows);
  problem.W.noalias() = Y_.transpose() * Y_;
}

ContactBlock ContactRows::make_block(const ActiveContact& contact, double h) const {
  // Dry friction of a joint: |impulse| at most h times the friction effort.
  if (contact.kind == RowKind::kJointFriction) {
    const double max_impulse = h * scene_.mechanism.joints[contact.a].friction;
    return box_block(-max_impulse, max_impulse);
  }
  // Limits and frictionless contacts, points with friction, patches with torsional friction.
  if (contact.kind != RowKind::kContact || contact.friction.coefficient == 0)
    return unilateral_block();
  if (contact.friction.torsion_radius == 0) return coulomb_block(contact.friction.coefficient);
  return soft_finger_block(contact.friction.coefficient, contact.friction.torsion_radius);
}

void ContactRows::fill_jacobian(const ActiveContact& contact, ConstraintLaw law, int at,
                                const TreeMotion<double>& links) {
  if (contact.kind != RowKind::kContact) {
    // Joint limit or friction: d value / d coordinate of the joint.
    const int joint = contact.a;
    const double sign = contact.kind == RowKind::kUpperLimit ? -1 : 1;
    const double slope = links.links()[model_.bodies[joint].link].slope;
    Jt(model_.layout.first_v[joint], at) = sign * slope;
    return;
  }
  // Contact: velocity of a relative to b along normal and tangents, and about the normal.
  const int a = links.link_of(contact.a), b = links.link_of(contact.b);
  const auto add = [&](int column, const Eigen::Vector3d& along, const Eigen::Vector3d& about) {
    links.add_relative_jacobian_row(a, b, contact.point, along, about, Jt.col(column));
  };
  const Eigen::Vector3d none(0, 0, 0);
  add(at, contact.normal, none);
  if (law == ConstraintLaw::kUnilateral) return;
  const Tangents sides = tangents(contact.normal);
  add(at + 1, sides.e1, none);
  add(at + 2, sides.e2, none);
  if (law == ConstraintLaw::kSoftFinger) add(at + 3, none, contact.normal);
}

void ContactRows::apply_restitution(std::vector<ActiveContact>& list) {
  for_each_row(list, [&](ActiveContact& contact, const ContactBlock& /*block*/, int at) {
    // Clear impulses; scale the normal velocity of closing contacts by restitution.
    contact.impulse.setZero();
    contact.torsion = 0;
    if (contact.kind == RowKind::kContact && problem.b[at] < 0)
      problem.b[at] *= 1 + contact.friction.restitution;
  });
}

void ContactRows::add_midpoint_terms(const Eigen::VectorXd& v, double h, double recovery,
                                     std::vector<ActiveContact>& list) {
  for_each_row(list, [&](ActiveContact& contact, const ContactBlock& block, int at) {
    // Normal: the gap may close by the next midpoint; a contact that touched obeys its law in the
    // mean of both ends.
    PreviousSpeeds now;
    if (contact.kind != RowKind::kJointFriction) {
      double gap_speed = contact.gap / h;
      if (contact.mode != ContactMode::kOpen) {
        now.closing = 2 * gap_speed;
        gap_speed = damped_mean(now.closing, contact.previous.closing);
      }
      problem.b[at] += std::max(gap_speed, -recovery);
    }
    // Tangents and spin: a contact that stuck obeys its law in the mean, too.
    const bool has_friction = contact.kind == RowKind::kContact && row_count(block.law) > 1;
    if (has_friction && contact.mode == ContactMode::kStick) {
      const Tangents sides = tangents(contact.normal);
      now.drift = Jt.col(at + 1).dot(v) * sides.e1 + Jt.col(at + 2).dot(v) * sides.e2;
      Eigen::Vector3d drift;
      for (int i = 0; i < 3; ++i) drift[i] = damped_mean(now.drift[i], contact.previous.drift[i]);
      problem.b[at + 1] += sides.e1.dot(drift);
      problem.b[at + 2] += sides.e2.dot(drift);
      if (block.law == ConstraintLaw::kSoftFinger) {
        now.spin = Jt.col(at + 3).dot(v);
        problem.b[at + 3] += damped_mean(now.spin, contact.previous.spin);
      }
    }
    contact.previous = now;
  });
}

const Eigen::VectorXd& ContactRows::warm_start(const std::vector<ActiveContact>& list) {
  warm_start_.setZero(problem.W.rows());
  for_each_row(list, [&](const ActiveContact& contact, const ContactBlock& block, int at) {
    // Impulses of joints are scalars, those of contacts are world vectors.
    if (contact.kind != RowKind::kContact) {
      warm_start_[at] = contact.impulse.x();
      return;
    }
    warm_start_[at] = contact.impulse.dot(contact.normal);
    if (block.law == ConstraintLaw::kUnilateral) return;
    const Tangents sides = tangents(contact.normal);
    warm_start_[at + 1] = contact.impulse.dot(sides.e1);
    warm_start_[at + 2] = contact.impulse.dot(sides.e2);
    if (block.law == ConstraintLaw::kSoftFinger) warm_start_[at + 3] = contact.torsion;
  });
  return warm_start_;
}

void ContactRows::store_solution(const ContactSolution& answer,
                                 std::vector<ActiveContact>& list) const {
  for_each_row(list, [&](ActiveContact& contact, const ContactBlock& block, int at) {
    // Store the approach; dry friction of a joint sticks or slides.
    contact.approach = answer.u[at];
    contact.slip = 0;
    if (contact.kind == RowKind::kJointFriction) {
      contact.impulse = {answer.f[at], 0, 0};
      contact.mode =
          std::abs(contact.approach) > kStickSpeed ? ContactMode::kSlide : ContactMode::kStick;
      return;
    }
    // Limits and contacts open or stick by their approach; contacts may also slide.
    contact.mode = contact.approach > kStickSpeed ? ContactMode::kOpen : ContactMode::kStick;
    if (contact.kind == RowKind::kContact)
      store_contact(answer, block, at, contact);
    else
      contact.impulse = {answer.f[at], 0, 0};
  });
}

}  // namespace thenar
