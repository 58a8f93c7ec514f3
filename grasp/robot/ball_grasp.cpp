#include "grasp/robot/ball_grasp.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "base/lists.h"
#include "base/numbers.h"
#include "data/io/robot/link_poses.h"
#include "grasp/closing/closing_drives.h"
#include "grasp/closing/fingertip_paths.h"

namespace thenar {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

constexpr int kLinkPoints = 150;         // number of sample points of a link
constexpr int kMinShapePoints = 30;      // minimum number of sample points of a shape
constexpr double kTouchDistance = 5e-4;  // distance from the ball within which links touch it [m]
constexpr double kMinApproach = 1e-7;    // motion towards the ball that counts as an approach [m]
// Distance within which links of the hand touch each other: the spacing of their points [m]
constexpr double kSelfTouchDistance = 3e-3;

RobotSpec without_shapes(RobotSpec robot) {
  for (RobotLink& link : robot.links) link.shapes.clear();
  return robot;
}

/// Returns a low-discrepancy number in [0, 1): fractional part of a multiple of an irrational
/// number.
double spread(int i, double irrational) {
  const double x = (i + 0.5) * irrational;
  return x - std::floor(x);
}

/// Returns corners of a mesh: all if there are few, otherwise the outermost along each axis.
Matrix3Xd outermost(const Matrix3Xd& corners) {
  constexpr Eigen::Index kFewCorners = 12;  // number of corners up to which all are kept
  if (corners.cols() <= kFewCorners) return corners;
  Matrix3Xd points(3, 6);
  for (int k = 0; k < 3; ++k) {
    Eigen::Index lowest = 0, highest = 0;
    corners.row(k).minCoeff(&lowest);
    corners.row(k).maxCoeff(&highest);
    points.col(2 * k) = corners.col(lowest);
    points.col(2 * k + 1) = corners.col(highest);
  }
  return points;
}

/// Samples points on triangles by area, and adds the outermost() corners. (3, points)
Matrix3Xd points_on(const TriangleMesh& mesh, int count) {
  std::vector<double> area(static_cast<std::size_t>(mesh.triangles.cols()) + 1, 0);
  const auto corner = [&](Eigen::Index t, int k) -> Vector3d {
    return mesh.vertices.col(mesh.triangles(k, t));
  };
  // Cumulative area of the triangles.
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
    const Vector3d a = corner(t, 0);
    area[static_cast<std::size_t>(t) + 1] =
        area[t] + (corner(t, 1) - a).cross(corner(t, 2) - a).norm() / 2;
  }
  if (!(area.back() > 0)) return mesh.vertices;
  // Equal steps of area select the triangle, low-discrepancy numbers the point in it.
  Matrix3Xd points(3, count);
  for (int i = 0; i < count; ++i) {
    const auto above = std::upper_bound(area.begin(), area.end(), (i + 0.5) / count * area.back());
    const Eigen::Index t = std::min<Eigen::Index>(above - area.begin(), mesh.triangles.cols()) - 1;
    const double root = std::sqrt(spread(i, 0.7548776662466927));
    const double side = root * spread(i, 0.5698402909980532);
    points.col(i) = (1 - root) * corner(t, 0) + (root - side) * corner(t, 1) + side * corner(t, 2);
  }
  // Corners preserve the extent of the mesh.
  const Matrix3Xd corners = outermost(mesh.vertices);
  Matrix3Xd all(3, count + corners.cols());
  all << points, corners;
  return all;
}

/// Sums the normals of triangles times areas by direction. (3, directions) [m^2]
Matrix3Xd faces_of(const TriangleMesh& mesh) {
  constexpr double kNormalCell = 1e-3;  // edge of a cell in which normals are merged [1]
  std::map<std::array<long, 3>, Vector3d> sums;
  // Each triangle adds to the cell of its normal.
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
    const Vector3d a = mesh.vertices.col(mesh.triangles(0, t));
    const Vector3d area = (mesh.vertices.col(mesh.triangles(1, t)) - a)
                              .cross(mesh.vertices.col(mesh.triangles(2, t)) - a) /
                          2;
    const double size = area.norm();
    if (!(size > 0)) continue;
    const auto cell = [&](int k) { return std::lround(area[k] / size / kNormalCell); };
    const auto at = sums.try_emplace({cell(0), cell(1), cell(2)}, Vector3d::Zero()).first;
    at->second += area;
  }
  return as_columns(sums, [](const auto& each) { return each.second; });
}

/// Points and faces of all shapes of a link, in its frame.
struct LinkSamples {
  Matrix3Xd points, faces;
};

LinkSamples samples_of(const RobotLink& link) {
  // Meshes are sampled directly, primitives by a mesh of their surface.
  std::vector<Matrix3Xd> points, faces;
  const int each = std::max(kMinShapePoints, kLinkPoints / static_cast<int>(link.shapes.size()));
  for (const ShapeSpec& shape : link.shapes) {
    if (shape.kind == ShapeKind::kMesh) {
      if (shape.mesh.triangles.cols() == 0) continue;
      points.emplace_back((shape.X_BS.R * points_on(shape.mesh, each)).colwise() + shape.X_BS.p);
      faces.emplace_back(shape.X_BS.R * faces_of(shape.mesh));
    } else {
      const TriangleMesh surface = build_solid({shape}).visual;
      points.push_back(points_on(surface, each));
      faces.push_back(faces_of(surface));
    }
  }
  return {join_columns(points), join_columns(faces)};
}

/// Transforms a point to the frame in which the points of a link's surfaces are stored.
Vector3d to_link_frame(const std::vector<Pose<double>>& links, int link, const Vector3d& p) {
  return link < 0 ? p : Vector3d(links[link].inverse() * p);
}

/// Finds the point of a surface nearest to p, and its distance, if it is within `reach`.
std::pair<Eigen::Index, double> nearest_sample(const SampledSurface& surface, const Vector3d& p,
                                               double reach) {
  Eigen::Index index = -1;
  // The bounding ball excludes far surfaces.
  if ((p - surface.centre).norm() > reach + surface.radius) return {index, kInfinity};
  const double distance =
      std::sqrt((surface.p.colwise() - p).colwise().squaredNorm().minCoeff(&index));
  return {index, distance};
}

/// Returns the layout with other drives.
HandLayout with_drives(HandLayout layout, const std::vector<Drive>& drives) {
  layout.drives = drives;
  return layout;
}

}  // namespace

Matrix3Xd join_columns(const std::vector<Matrix3Xd>& parts) {
  Eigen::Index count = 0;
  for (const Matrix3Xd& part : parts) count += part.cols();
  Matrix3Xd all(3, count);
  Eigen::Index at = 0;
  for (const Matrix3Xd& part : parts) {
    all.middleCols(at, part.cols()) = part;
    at += part.cols();
  }
  return all;
}

BallGrasp::BallGrasp(const RobotSpec& robot) : hand_(without_shapes(robot)) {
  const std::vector<Pose<double>> frames = hand_.link_frames(
      Eigen::VectorXd::Zero(static_cast<Eigen::Index>(hand_.layout().coordinates.size())));
  const Eigen::VectorXd middle = (hand_.layout().lower + hand_.layout().upper) / 2;
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    const RobotLink& link = robot.links[i];
    if (link.shapes.empty()) continue;
    SampledSurface surface;
    surface.link = hand_.mover_of(i);
    surface.name = link.name;
    surface.digit = link.digit;
    // Sample points at the reference posture, with their bounding ball.
    const LinkSamples samples = samples_of(link);
    surface.p = (frames[i].R * samples.points).colwise() + frames[i].p;
    if (surface.p.cols() == 0) continue;
    surface.faces = frames[i].R * samples.faces;
    surface.centre = (surface.p.rowwise().minCoeff() + surface.p.rowwise().maxCoeff()) / 2;
    surface.radius = (surface.p.colwise() - surface.centre).colwise().norm().maxCoeff();
    // The Jacobian shows which coordinates move the surface.
    if (surface.link >= 0) {
      const Eigen::MatrixXd J = hand_.jacobian(middle, surface.link, surface.centre);
      for (Eigen::Index c = 0; c < J.cols(); ++c)
        if (!J.col(c).isZero(0)) surface.moved_by.push_back(static_cast<int>(c));
    }
    surfaces_.push_back(std::move(surface));
  }
}

double BallGrasp::sphere_cast(const std::vector<Pose<double>>& links, const Vector3d& origin,
                              const Vector3d& direction, double radius) const {
  double distance = -kInfinity;
  for (const SampledSurface& surface : surfaces_) {
    // The ray in the frame of the surface's points.
    const Vector3d o = to_link_frame(links, surface.link, origin),
                   d = surface.link < 0 ? direction
                                        : Vector3d(links[surface.link].R.transpose() * direction);
    // Surfaces whose bounding ball is off the ray cannot touch the ball.
    const Vector3d to_centre = surface.centre - o;
    if ((to_centre - to_centre.dot(d) * d).norm() > radius + surface.radius) continue;
    // The ball touches a point at the larger root of a quadratic equation.
    for (Eigen::Index i = 0; i < surface.p.cols(); ++i) {
      const Vector3d v = surface.p.col(i) - o;
      const double along = v.dot(d),
                   discriminant = radius * radius - (v.squaredNorm() - along * along);
      if (discriminant >= 0) distance = std::max(distance, along + std::sqrt(discriminant));
    }
  }
  return distance;
}

bool BallGrasp::are_adjacent(const SampledSurface& a, const SampledSurface& b) const {
  // Links of one digit, or a link and its parent, are always near each other.
  if (a.digit == b.digit) return true;
  const auto& parents = hand_.layout().parents;
  const auto next_to = [&](int inner, int outer) {
    return outer >= 0 && (parents[outer] == inner || inner == outer);
  };
  return next_to(a.link, b.link) || next_to(b.link, a.link);
}

/// Returns whether points of two links come within the spacing of their points.
bool BallGrasp::collide(const SampledSurface& a, const SampledSurface& b,
                        const std::vector<Pose<double>>& links) {
  const Vector3d ca = moved_with(links, a.link, a.centre), cb = moved_with(links, b.link, b.centre);
  if ((ca - cb).norm() > a.radius + b.radius + kSelfTouchDistance) return false;
  for (Eigen::Index i = 0; i < a.p.cols(); ++i) {
    const Vector3d p = to_link_frame(links, b.link, moved_with(links, a.link, a.p.col(i)));
    if (nearest_sample(b, p, kSelfTouchDistance).second < kSelfTouchDistance) return true;
  }
  return false;
}

/// A closing motion in steps. Drives run at their speeds; a contact stops the coordinates of its
/// links.
class BallGrasp::Closing {
 public:
  Closing(const BallGrasp& grasp, const std::vector<Drive>& drives, Eigen::VectorXd q, int steps)
      : grasp_(grasp),
        layout_(with_drives(grasp.hand_.layout(), drives)),
        drives_(layout_),
        q_(std::move(q)),
        step_time_(time_to_limits(layout_, q_, drives_.rates()) / steps),
        links_(grasp.hand_.pose(q_)),
        gaps_(grasp.surfaces_.size(), -kInfinity),
        collided_(grasp.surfaces_.size() * grasp.surfaces_.size(), false) {}

  [[nodiscard]] bool is_moving() const { return drives_.is_moving(); }

  /// Moves by one step; limits stop coordinates.
  void advance() {
    const Eigen::VectorXd rates = drives_.rates();
    q_ = (q_ + step_time_ * rates).cwiseMax(layout_.lower).cwiseMin(layout_.upper);
    for (Eigen::Index j = 0; j < q_.size(); ++j)
      if (rates[j] != 0 && q_[j] == (rates[j] > 0 ? layout_.upper : layout_.lower)[j])
        drives_.stop(static_cast<int>(j), StoppedBy::kLimit);
    links_ = grasp_.hand_.pose(q_);
  }

  /// Stops links that touch the ball and still approach it.
  void stop_at_ball(const ProbeBall& ball) {
    for (std::size_t s = 0; s < grasp_.surfaces_.size(); ++s) {
      const SampledSurface& surface = grasp_.surfaces_[s];
      const Vector3d c = to_link_frame(links_, surface.link, ball.centre);
      const double gap =
          nearest_sample(surface, c, ball.radius + kTouchDistance).second - ball.radius;
      if (gap <= kTouchDistance && gap < gaps_[s] - kMinApproach)
        for (const int moved : surface.moved_by) drives_.stop(moved, StoppedBy::kContact);
      gaps_[s] = gap;
    }
  }

  /// Finds pairs of surfaces that collide for the first time, the first of each on one of `digits`.
  [[nodiscard]] std::vector<std::pair<std::size_t, std::size_t>> find_new_collisions(
      const std::vector<std::string>& digits) {
    const std::vector<SampledSurface>& surfaces = grasp_.surfaces_;
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    for (std::size_t a = 0; a < surfaces.size(); ++a) {
      if (!contains(digits, surfaces[a].digit)) continue;
      for (std::size_t b = 0; b < surfaces.size(); ++b) {
        const std::size_t pair = a * surfaces.size() + b;
        if (grasp_.are_adjacent(surfaces[a], surfaces[b]) || collided_[pair] ||
            !grasp_.collide(surfaces[a], surfaces[b], links_))
          continue;
        collided_[pair] = true;
        pairs.emplace_back(a, b);
      }
    }
    return pairs;
  }

  /// Stops coordinates that move one surface but not the other.
  void stop_between(std::size_t one, std::size_t other) {
    const std::vector<int>& both = grasp_.surfaces_[other].moved_by;
    for (const int moved : grasp_.surfaces_[one].moved_by)
      if (!contains(both, moved)) drives_.stop(moved, StoppedBy::kContact);
  }

  [[nodiscard]] const std::vector<Pose<double>>& links() const { return links_; }

 private:
  const BallGrasp& grasp_;
  HandLayout layout_;
  ClosingDrives drives_;
  Eigen::VectorXd q_;
  double step_time_;  // duration of a step [s]
  std::vector<Pose<double>> links_;
  std::vector<double> gaps_;    // gap between each surface and the ball after the last step [m]
  std::vector<bool> collided_;  // pairs of surfaces that have collided
};

std::vector<BallContact> BallGrasp::contacts(const std::vector<Pose<double>>& links,
                                             const ProbeBall& ball) const {
  // The tolerance is wider than that of stopping.
  std::vector<BallContact> contacts;
  for (std::size_t s = 0; s < surfaces_.size(); ++s) {
    const SampledSurface& surface = surfaces_[s];
    const Vector3d c = to_link_frame(links, surface.link, ball.centre);
    const auto [index, distance] = nearest_sample(surface, c, ball.radius + 2 * kTouchDistance);
    if (index < 0 || distance > ball.radius + 2 * kTouchDistance) continue;
    const Vector3d normal = ball.centre - moved_with(links, surface.link, surface.p.col(index));
    contacts.push_back({static_cast<int>(s), normal.normalized()});
  }
  return contacts;
}

std::vector<BallContact> BallGrasp::close(const std::vector<Drive>& drives, Eigen::VectorXd q,
                                          const ProbeBall& ball, int steps,
                                          const std::vector<std::string>& self) const {
  Closing closing(*this, drives, std::move(q), steps);
  // Links that touch each other at the start do not stop each other.
  closing.stop_at_ball(ball);
  if (!self.empty()) (void)closing.find_new_collisions(self);
  for (int step = 1; step <= steps && closing.is_moving(); ++step) {
    closing.advance();
    closing.stop_at_ball(ball);
    if (self.empty()) continue;
    for (const auto& [a, b] : closing.find_new_collisions(self)) {
      closing.stop_between(a, b);
      closing.stop_between(b, a);
    }
  }
  return contacts(closing.links(), ball);
}

}  // namespace thenar
