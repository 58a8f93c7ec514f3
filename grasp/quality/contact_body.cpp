#include "grasp/quality/contact_body.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include <Eigen/Dense>

#include "base/lists.h"

namespace thenar::internal {
namespace {

constexpr int kMaxBodyPoints =
    200;  // maximum number of points: all triples are tried, for some seconds

using Basis = Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, 3>;

/// Indices of the corners of points in a plane (2, n), counter-clockwise.
std::vector<int> corners_of(const Eigen::Matrix2Xd& x, double tolerance) {
  // Andrew's monotone chain: lower hull, then upper hull.
  std::vector<int> order(static_cast<std::size_t>(x.cols()));
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    return x(0, a) != x(0, b) ? x(0, a) < x(0, b) : x(1, a) < x(1, b);
  });
  const auto left = [&](int a, int b, int c) {
    const Eigen::Vector2d u = x.col(b) - x.col(a), v = x.col(c) - x.col(b);
    return u.x() * v.y() - u.y() * v.x() > tolerance * std::max(u.norm(), v.norm());
  };
  std::vector<int> corners;
  for (int turn = 0; turn < 2; ++turn) {
    const std::size_t start = corners.size();
    for (const int i : order) {
      while (corners.size() >= start + 2 && !left(corners[corners.size() - 2], corners.back(), i))
        corners.pop_back();
      corners.push_back(i);
    }
    corners.pop_back();
    std::reverse(order.begin(), order.end());
  }
  return corners;
}

double area(const Eigen::Matrix2Xd& x, const std::vector<int>& corners) {
  double twice = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto a = x.col(corners[i]), b = x.col(corners[(i + 1) % corners.size()]);
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return twice / 2;
}

/// Returns the corner farthest from the line through corners i and i + 1.
int opposite(const Eigen::Matrix2Xd& x, const std::vector<int>& corners, std::size_t i) {
  const Eigen::Vector2d a = x.col(corners[i]), e = x.col(corners[(i + 1) % corners.size()]) - a;
  return *std::max_element(corners.begin(), corners.end(), [&](int p, int q) {
    const Eigen::Vector2d v = x.col(p) - a, w = x.col(q) - a;
    return e.x() * v.y() - e.y() * v.x() < e.x() * w.y() - e.y() * w.x();
  });
}

ContactFace face_of(int dimension, double size) { return {dimension, {}, size, {}, 0}; }

ContactFace edge(const WrenchCoordinates& from, const WrenchCoordinates& to) {
  ContactFace face = face_of(1, 1);
  face.span[0] = to - from;
  return face;
}

void add_inward(ContactFace& face, const WrenchCoordinates& along) {
  face.inward[face.inward_count++] = along;
}

ContactFace whole(const Basis& Q, double size) {
  ContactFace face = face_of(static_cast<int>(Q.cols()), size);
  for (int i = 0; i < Q.cols(); ++i) face.span[i] = Q.col(i);
  return face;
}

/// Returns the edges of a planar polygon, each with its inward direction, and the polygon itself.
void add_flat(ContactBody& body, const Basis& Q, const Eigen::Matrix2Xd& x, double tolerance) {
  const std::vector<int> corners = corners_of(x, tolerance);
  const auto point = [&](int i) { return body.points[i]; };
  for (std::size_t i = 0; i < corners.size(); ++i) {
    ContactFace face = edge(point(corners[i]), point(corners[(i + 1) % corners.size()]));
    add_inward(face, point(opposite(x, corners, i)) - point(corners[i]));
    body.faces.push_back(face);
  }
  body.faces.push_back(whole(Q, area(x, corners)));
}

/// Faces of a solid: planes through three points with all others on one side.
class FaceSolid {
 public:
  FaceSolid(ContactBody& body, const Basis& Q, const Eigen::Matrix3Xd& x, double tolerance)
      : body_(body), Q_(Q), x_(x), tolerance_(tolerance) {}

  void add_faces() {
    // Faces: planes through three points.
    const int n = static_cast<int>(x_.cols());
    for (int i = 0; i < n; ++i)
      for (int j = i + 1; j < n; ++j)
        for (int k = j + 1; k < n; ++k) add_plane(i, j, k);
    // Edges, with a third corner of both neighbouring faces.
    for (const auto& [ends, thirds] : edges_) {
      ContactFace face = edge(point(ends.first), point(ends.second));
      for (std::size_t i = 0; i < std::min<std::size_t>(thirds.size(), 2); ++i)
        add_inward(face, point(thirds[i]) - point(ends.first));
      body_.faces.push_back(face);
    }
    // The solid itself.
    body_.faces.push_back(whole(Q_, volume_));
  }

 private:
  [[nodiscard]] const WrenchCoordinates& point(int i) const { return body_.points[i]; }

  /// Adds the plane through three points as a face if all points lie on one side.
  void add_plane(int i, int j, int k) {
    // Nearly collinear points span no plane.
    Eigen::Vector3d n = (x_.col(j) - x_.col(i)).cross(x_.col(k) - x_.col(i));
    const double longest = std::max((x_.col(j) - x_.col(i)).norm(), (x_.col(k) - x_.col(i)).norm());
    if (n.norm() <= tolerance_ * longest) return;
    n.normalize();
    // Turn the normal outwards.
    Eigen::RowVectorXd s = n.transpose() * (x_.colwise() - x_.col(i));
    if (s.maxCoeff() > tolerance_) {
      n = -n;
      s = -s;
    }
    if (s.maxCoeff() > tolerance_) return;
    // All points on the plane belong to one face, which is added once.
    std::vector<int> on;
    for (int l = 0; l < s.size(); ++l)
      if (s(l) >= -tolerance_) on.push_back(l);
    if (seen_.insert(on).second) add_face(n, on, s);
  }

  void add_face(const Eigen::Vector3d& n, const std::vector<int>& on, const Eigen::RowVectorXd& s) {
    // Corners of the face in its plane.
    const Eigen::Vector3d a = n.unitOrthogonal(), b = n.cross(a);
    const Eigen::Matrix2Xd flat =
        as_columns(on, [&](int i) { return Eigen::Vector2d(a.dot(x_.col(i)), b.dot(x_.col(i))); });
    const std::vector<int> corners = corners_of(flat, tolerance_);
    // Its inward direction leads to the deepest point.
    ContactFace face = face_of(2, area(flat, corners));
    face.span = {WrenchCoordinates(Q_ * a), WrenchCoordinates(Q_ * b), WrenchCoordinates::Zero()};
    int lowest = 0;
    (void)s.minCoeff(&lowest);
    add_inward(face, point(lowest) - point(on.front()));
    body_.faces.push_back(face);
    // Pyramid over the face with its apex at the mean of all points.
    volume_ += face.size * depth_of_middle(n, on.front()) / 3;
    // Each edge stores the opposite corner in this face.
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const auto number = [&](int corner) { return on[corner]; };
      const std::pair<int, int> ends =
          std::minmax({number(corners[i]), number(corners[(i + 1) % corners.size()])});
      edges_[ends].push_back(number(opposite(flat, corners, i)));
    }
  }

  /// Returns the depth of the mean of all points below a face [1].
  [[nodiscard]] double depth_of_middle(const Eigen::Vector3d& n, int on) const {
    return n.dot(x_.col(on) - x_.rowwise().mean());
  }

  ContactBody& body_;
  const Basis& Q_;
  const Eigen::Matrix3Xd& x_;
  double tolerance_, volume_ = 0;
  std::set<std::vector<int>> seen_;
  std::map<std::pair<int, int>, std::vector<int>> edges_;  // by their ends: third corners
};

std::vector<WrenchCoordinates> distinct(const std::vector<WrenchCoordinates>& points,
                                        double tolerance) {
  std::vector<WrenchCoordinates> kept{WrenchCoordinates::Zero()};
  for (const WrenchCoordinates& point : points)
    if (all_of(kept, [&](const auto& other) { return (other - point).norm() > tolerance; }))
      kept.push_back(point);
  return kept;
}

}  // namespace

std::optional<ContactBody> contact_body(const std::vector<WrenchCoordinates>& points) {
  double size = 0;
  for (const WrenchCoordinates& point : points) size = std::max(size, point.norm());
  const double tolerance = kWrenchRankTolerance * size;
  // The origin is a corner, too.
  ContactBody body{distinct(points, tolerance), {}};
  if (body.points.size() > kMaxBodyPoints) return {};
  const Eigen::Matrix<double, 6, Eigen::Dynamic> P = as_columns(body.points);
  // Dimension of the body, and its coordinates in an orthonormal basis.
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(P, Eigen::ComputeThinU);
  const auto rank = (svd.singularValues().array() > tolerance).count();
  if (rank > 3) return {};
  if (rank == 0) return body;
  const Basis Q = svd.matrixU().leftCols(rank);
  const Eigen::MatrixXd x = Q.transpose() * P;
  // Segment, polygon or polyhedron.
  if (rank == 1) body.faces.push_back(whole(Q, x.maxCoeff() - x.minCoeff()));
  if (rank == 2) add_flat(body, Q, x, tolerance);
  if (rank == 3) FaceSolid(body, Q, x, tolerance).add_faces();
  return body;
}

}  // namespace thenar::internal
