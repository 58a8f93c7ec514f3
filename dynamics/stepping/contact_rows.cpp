#include "dynamics/stepping/contact_rows.h"

#include <algorithm>
#include <cmath>

namespace thenar {
namespace {

using RowKind = ActiveContact::Kind;

constexpr double kStickSpeed = 1e-9;  // slower is sticking [m/s], [rad/s]
constexpr double kMeanWeight = 0.75;  // of this step in a mean with the step before [1]

/// Mean without what alternates from step to step. @param before  NaN: there was none
double settled(double now, double before) {
  return std::isnan(before) ? now : kMeanWeight * now + (1 - kMeanWeight) * before;
}

/// Writes an answer's rows into a contact of two bodies, whose mode by its approach is known.
void read_contact(const ContactSolution& answer, const ContactBlock& block, int at,
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

void ContactRows::set(const std::vector<ActiveContact>& list, double h,
                      const TreeMotion<double>& links, const MassMatrix<double>& mass) {
  // Blocks and their rows, and the Jacobian of each.
  int rows = 0;
  problem.blocks.clear();
  for (const ActiveContact& contact : list) {
    problem.blocks.push_back(block_of(contact, h));
    rows += rows_of(problem.blocks.back().law);
  }
  J.setZero(model_.layout.v, rows);
  for_each_row(list, [&](const ActiveContact& contact, const ContactBlock& block, int at) {
    fill(contact, block.law, at, links);
  });
  // W = J' A^-1 J from half of the factor.
  Y_ = J;
  for (int i = 0; i < rows; ++i) mass.half_solve(model_, Y_.col(i));
  problem.W.resize(rows, rows);
  problem.W.noalias() = Y_.transpose() * Y_;
}

ContactBlock ContactRows::block_of(const ActiveContact& contact, double h) const {
  // Dry friction of a joint: an impulse of at most h times its largest effort.
  if (contact.kind == RowKind::kJointFriction) {
    const double most = h * scene_.mechanism.joints[static_cast<std::size_t>(contact.a)].friction;
    return box_block(-most, most);
  }
  // Limits and contacts without friction, points with friction, patches with torsion.
  if (contact.kind != RowKind::kContact || contact.friction.coefficient == 0)
    return unilateral_block();
  if (contact.friction.torsion_radius == 0) return coulomb_block(contact.friction.coefficient);
  return soft_finger_block(contact.friction.coefficient, contact.friction.torsion_radius);
}

void ContactRows::fill(const ActiveContact& contact, ConstraintLaw law, int at,
                       const TreeMotion<double>& links) {
  if (contact.kind != RowKind::kContact) {
    // d value / d coordinate of the joint.
    const auto joint = static_cast<std::size_t>(contact.a);
    const double sign = contact.kind == RowKind::kUpperLimit ? -1 : 1;
    const double slope = links.links()[static_cast<std::size_t>(model_.bodies[joint].link)].slope;
    J(model_.layout.first_v[joint], at) = sign * slope;
    return;
  }
  // Velocity of a against b at the point, along the normal and the tangents, and about the normal.
  const int a = links.link_of(contact.a), b = links.link_of(contact.b);
  const auto add = [&](int column, const Eigen::Vector3d& along, const Eigen::Vector3d& about) {
    links.add_row_against(a, b, contact.point, along, about, J.col(column));
  };
  const Eigen::Vector3d none(0, 0, 0);
  add(at, contact.normal, none);
  if (law == ConstraintLaw::kUnilateral) return;
  const Tangents sides = tangents(contact.normal);
  add(at + 1, sides.e1, none);
  add(at + 2, sides.e2, none);
  if (law == ConstraintLaw::kSoftFinger) add(at + 3, none, contact.normal);
}

void ContactRows::bounce(std::vector<ActiveContact>& list) {
  for_each_row(list, [&](ActiveContact& contact, const ContactBlock& /*block*/, int at) {
    // Forget impulses, and let closing contacts return with restitution.
    contact.impulse.setZero();
    contact.torsion = 0;
    if (contact.kind == RowKind::kContact && problem.b[at] < 0)
      problem.b[at] *= 1 + contact.friction.restitution;
  });
}

void ContactRows::add_speeds_before(const Eigen::VectorXd& v, double h, double recovery,
                                    std::vector<ActiveContact>& list) {
  for_each_row(list, [&](ActiveContact& contact, const ContactBlock& block, int at) {
    add_speeds(v, h, recovery, at, rows_of(block.law), contact);
  });
}

void ContactRows::add_speeds(const Eigen::VectorXd& v, double h, double recovery, int at, int rows,
                             ActiveContact& contact) {
  // Normal: a gap may close by the next middle; a contact that touched goes on in the mean of both
  // ends.
  BeforeSpeeds now;
  if (contact.kind != RowKind::kJointFriction) {
    double gap_speed = contact.gap / h;
    if (contact.mode != ContactMode::kOpen) {
      now.closing = 2 * gap_speed;
      gap_speed = settled(now.closing, contact.before.closing);
    }
    problem.b[at] += std::max(gap_speed, -recovery);
  }
  // Tangents and spin: a contact that stuck goes on in the mean, too.
  if (contact.kind == RowKind::kContact && contact.mode == ContactMode::kStick && rows > 1) {
    const Tangents sides = tangents(contact.normal);
    now.drift = J.col(at + 1).dot(v) * sides.e1 + J.col(at + 2).dot(v) * sides.e2;
    Eigen::Vector3d drift;
    for (int i = 0; i < 3; ++i) drift[i] = settled(now.drift[i], contact.before.drift[i]);
    problem.b[at + 1] += sides.e1.dot(drift);
    problem.b[at + 2] += sides.e2.dot(drift);
    if (rows > 3) {
      now.spin = J.col(at + 3).dot(v);
      problem.b[at + 3] += settled(now.spin, contact.before.spin);
    }
  }
  contact.before = now;
}

const Eigen::VectorXd& ContactRows::warm_start(const std::vector<ActiveContact>& list) {
  start_.setZero(problem.W.rows());
  for_each_row(list, [&](const ActiveContact& contact, const ContactBlock& block, int at) {
    // Impulses of joints are scalars, of contacts vectors in the world.
    if (contact.kind != RowKind::kContact) {
      start_[at] = contact.impulse.x();
      return;
    }
    start_[at] = contact.impulse.dot(contact.normal);
    if (block.law == ConstraintLaw::kUnilateral) return;
    const Tangents sides = tangents(contact.normal);
    start_[at + 1] = contact.impulse.dot(sides.e1);
    start_[at + 2] = contact.impulse.dot(sides.e2);
    if (block.law == ConstraintLaw::kSoftFinger) start_[at + 3] = contact.torsion;
  });
  return start_;
}

void ContactRows::read(const ContactSolution& answer, std::vector<ActiveContact>& list) const {
  for_each_row(list, [&](ActiveContact& contact, const ContactBlock& block, int at) {
    // Approach, and the impulse of a joint's friction, which sticks or slides.
    contact.approach = answer.u[at];
    contact.slip = 0;
    if (contact.kind == RowKind::kJointFriction) {
      contact.impulse = {answer.f[at], 0, 0};
      contact.mode =
          std::abs(contact.approach) > kStickSpeed ? ContactMode::kSlide : ContactMode::kStick;
      return;
    }
    // Limits and contacts are open or closed by their approach; contacts read their tangents, too.
    contact.mode = contact.approach > kStickSpeed ? ContactMode::kOpen : ContactMode::kStick;
    if (contact.kind == RowKind::kContact)
      read_contact(answer, block, at, contact);
    else
      contact.impulse = {answer.f[at], 0, 0};
  });
}

}  // namespace thenar
