#include "grasp/guess_hand.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "grasp/robot_hand.h"
#include "grasp/tip_ways.h"

namespace thenar {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kStep = 0.01;     // of a drive's range, to see where its tips go [1]
constexpr double kHardly = 1e-3;   // change of the sum of squared distances that says nothing [1]
constexpr double kAlike = 1e-9;    // the same, of joints that move all tips together [1]
constexpr double kAlong = 0.7;     // cosine to the last joint's axis from which a joint curls [1]
constexpr double kNowhere = 1e-6;  // way that gives no direction [m]

/// Zero, or the limit next to it.
VectorXd rest_of(const HandLayout& layout) {
  return layout.lower.cwiseMax(0).cwiseMin(layout.upper);
}

/// Sum of squared distances between tips [m^2].
double apart(const Eigen::Matrix3Xd& tips) {
  double sum = 0;
  for (Eigen::Index a = 0; a < tips.cols(); ++a)
    for (Eigen::Index b = 0; b < a; ++b) sum += (tips.col(a) - tips.col(b)).squaredNorm();
  return sum;
}

/// The posture with a drive a step of its range away from rest. @param way  1 or -1
VectorXd stepped(const HandLayout& layout, const Drive& drive, double way) {
  VectorXd q = rest_of(layout);
  for (const Driven& moved : drive.moves) {
    const Eigen::Index c = moved.coordinate;
    const double range = layout.upper[c] - layout.lower[c];
    q[c] += way * (moved.ratio < 0 ? -1 : 1) * kStep * range;
  }
  return q.cwiseMax(layout.lower).cwiseMin(layout.upper);
}

/// Whether a drive turns every tip that it moves across the axis of the last joint before it.
bool spreads(const RobotHand& hand, const Drive& drive) {
  const HandLayout& layout = hand.layout();
  const VectorXd q = rest_of(layout);
  bool any = false;
  for (const HandTip& tip : layout.tip_points) {
    const Eigen::Matrix3Xd axes = hand.jacobian(q, tip.link, tip.p).topRows<3>();
    const Eigen::MatrixXd moves = hand.jacobian(q, tip.link, tip.p);
    Eigen::Index last = -1;
    for (Eigen::Index c = 0; c < q.size(); ++c)
      if (!moves.col(c).isZero(0)) last = c;
    for (const Driven& moved : drive.moves) {
      if (moves.col(moved.coordinate).isZero(0)) continue;
      const Vector3d a = axes.col(moved.coordinate), b = axes.col(last);
      if (a.isZero(0) || std::abs(a.dot(b)) >= kAlong * a.norm() * b.norm()) return false;
      any = true;
    }
  }
  return any;
}

/// Whether a drive moves every tip.
bool moves_all(const RobotHand& hand, const Drive& drive) {
  const VectorXd q = rest_of(hand.layout());
  const std::vector<HandTip>& tips = hand.layout().tip_points;
  return std::all_of(tips.begin(), tips.end(), [&](const HandTip& tip) {
    const Eigen::MatrixXd moves = hand.jacobian(q, tip.link, tip.p);
    return std::any_of(drive.moves.begin(), drive.moves.end(),
                       [&](const Driven& moved) { return !moves.col(moved.coordinate).isZero(0); });
  });
}

/// Farther of the limits of what a drive moves, as the sign of its own motion.
double farther(const HandLayout& layout, const Drive& drive) {
  const Driven& first = drive.moves.front();
  const double middle = layout.lower[first.coordinate] + layout.upper[first.coordinate];
  return (middle < 0) != (first.ratio < 0) ? -1 : 1;
}

/// 1, -1, or 0 for a drive that does not close the hand.
double closing_sign(const RobotHand& hand, const Drive& drive) {
  const HandLayout& layout = hand.layout();
  if (layout.tip_points.size() < 2) return farther(layout, drive);
  const Eigen::Matrix3Xd up = tips_at(hand, stepped(layout, drive, 1)),
                         down = tips_at(hand, stepped(layout, drive, -1));
  const double nearer = apart(down) - apart(up), scale = std::max(apart(down), apart(up));
  if (moves_all(hand, drive) && std::abs(nearer) <= kAlike * scale) return 0;
  if (spreads(hand, drive)) return 0;
  if (std::abs(nearer) <= kHardly * scale) return farther(layout, drive);
  return nearer > 0 ? 1 : -1;
}

bool any_speed(const RobotSpec& robot) {
  return std::any_of(robot.dofs.begin(), robot.dofs.end(),
                     [](const RobotDof& dof) { return dof.speed != 0; });
}

void guess_closing(RobotSpec& robot) {
  const RobotHand hand(robot);
  const bool paced = any_speed(robot);
  std::vector<std::string> closing;
  for (const Drive& drive : hand.layout().drives)
    for (RobotDof& dof : robot.dofs) {
      if (dof.name != drive.name) continue;
      dof.speed = closing_sign(hand, drive) * (paced ? std::abs(dof.speed) : 1);
      if (dof.speed != 0)
        closing.push_back(fmt::format("{} {}", dof.name, dof.speed > 0 ? "upwards" : "downwards"));
    }
  robot.warnings.push_back(
      fmt::format("no closing is stated: it is guessed as {}",
                  closing.empty() ? "none" : fmt::format("{}", fmt::join(closing, ", "))));
}

/// The last link that all tips hang on; -1: the base.
int palm_of(const HandLayout& layout) {
  if (layout.tip_points.size() < 2) return -1;
  std::set<int> common;
  for (const HandTip& tip : layout.tip_points) {
    std::set<int> way{-1};
    for (int link = tip.link; link >= 0; link = layout.parents[static_cast<std::size_t>(link)])
      if (&tip == &layout.tip_points.front() || common.count(link) == 1) way.insert(link);
    common = way;
  }
  return *common.rbegin();  // parents come before children
}

/// The box around surfaces of a link, of a digit or of none, where they are at a posture.
Eigen::AlignedBox3d box_of(const RobotHand& hand, const VectorXd& q, int link,
                           const std::string& digit) {
  const std::vector<Pose<double>> links = hand.pose(q);
  Eigen::AlignedBox3d box;
  for (const LinkSurface& surface : hand.surfaces()) {
    if (surface.link != link || surface.digit != digit) continue;
    const Eigen::AlignedBox3d own = surface.solid->shape->bounds();
    for (int corner = 0; corner < 8; ++corner) {
      const Vector3d p = own.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner));
      box.extend(link < 0 ? p : Vector3d(links[static_cast<std::size_t>(link)] * p));
    }
  }
  return box;
}

/// Drives that close in the middle of their ranges, the others at rest.
VectorXd half_closed(const HandLayout& layout) {
  VectorXd q = rest_of(layout);
  for (const Drive& drive : layout.drives)
    for (const Driven& moved : drive.moves)
      if (drive.speed != 0)
        q[moved.coordinate] = (layout.lower[moved.coordinate] + layout.upper[moved.coordinate]) / 2;
  return q;
}

void guess_approach(RobotSpec& robot) {
  const RobotHand hand(robot);
  const HandLayout& layout = hand.layout();
  const VectorXd q = half_closed(layout);
  const Eigen::Matrix3Xd tips = tips_at(hand, q);
  Vector3d ends = Vector3d::Zero();
  for (Eigen::Index t = 0; t < tips.cols(); ++t) {
    const HandTip& tip = layout.tip_points[static_cast<std::size_t>(t)];
    const Eigen::AlignedBox3d box = box_of(hand, q, tip.link, tip.digit);
    ends += (box.isEmpty() ? Vector3d(tips.col(t)) : Vector3d(box.center())) /
            static_cast<double>(tips.cols());
  }
  Eigen::AlignedBox3d palm;
  for (int link = palm_of(layout); palm.isEmpty() && link >= -1;
       link = link < 0 ? -2 : layout.parents[static_cast<std::size_t>(link)])
    palm = box_of(hand, q, link, "");
  const Vector3d from = palm.isEmpty() ? Vector3d(0, 0, 0) : Vector3d(palm.center());
  if ((ends - from).norm() > kNowhere) robot.approach.direction = (ends - from).normalized();
  robot.approach.point = from;
  if (!palm.isEmpty())
    robot.approach.point +=
        (palm.sizes().array() / 2 / robot.approach.direction.array().abs()).minCoeff() *
        robot.approach.direction;
  const Vector3d &p = robot.approach.point, &d = robot.approach.direction;
  robot.warnings.push_back(
      fmt::format("no approach is stated: it is guessed as along [{:.3f}, {:.3f}, {:.3f}] from "
                  "[{:.4f}, {:.4f}, {:.4f}] m",
                  d.x(), d.y(), d.z(), p.x(), p.y(), p.z()));
}

bool states_approach(const RobotSpec& robot) {
  const RobotApproach unsaid;
  return robot.approach.point != unsaid.point || robot.approach.direction != unsaid.direction;
}

bool states_digits(const RobotSpec& robot) {
  return std::any_of(robot.links.begin(), robot.links.end(),
                     [](const RobotLink& link) { return !link.digit.empty(); });
}

/// guess_digits() with a warning. @return whether there are any
bool name_digits(RobotSpec& robot) {
  const int digits = guess_digits(robot);
  if (digits == 0) return false;
  std::vector<std::string> names;
  for (const RobotLink& link : robot.links)
    if (!link.digit.empty()) names.push_back(fmt::format("{} of {}", link.name, link.digit));
  robot.warnings.push_back(
      fmt::format("no digits are stated: {} guessed: {}", digits, fmt::join(names, ", ")));
  return true;
}

void name_nominal(RobotSpec& robot) {
  std::vector<std::string> nominal;
  for (const RobotDof& dof : robot.dofs)
    if (dof.nominal_effort && dof.max_effort > 0) nominal.push_back(dof.name);
  if (!nominal.empty())
    robot.warnings.push_back(
        fmt::format("efforts of {} are nominal, as a model's placeholders: measures of force take "
                    "them for unknown",
                    fmt::join(nominal, ", ")));
}

}  // namespace

RobotSpec with_materials(RobotSpec robot) {
  std::vector<std::string> bare;
  for (RobotLink& link : robot.links) {
    if (link.shapes.empty() || !link.material.empty()) continue;
    link.material = kGuessedMaterial;
    bare.push_back(link.name);
  }
  if (!bare.empty())
    robot.warnings.push_back(fmt::format("no material is stated: {} is taken for {}",
                                         kGuessedMaterial, fmt::join(bare, ", ")));
  return robot;
}

RobotSpec graspable(RobotSpec robot) {
  robot = with_materials(std::move(robot));
  name_nominal(robot);
  if (!states_digits(robot) && !states_approach(robot)) {
    if (!name_digits(robot)) return robot;
    robot.closing_stated = false;
  }
  if (!any_speed(robot) && states_digits(robot)) robot.closing_stated = robot.dofs.empty();
  if (robot.closing_stated) return robot;
  guess_closing(robot);
  robot.closing_stated = true;
  if (!states_approach(robot)) guess_approach(robot);
  return robot;
}

}  // namespace thenar
