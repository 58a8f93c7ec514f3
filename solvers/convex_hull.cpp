#include "solvers/convex_hull.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <set>
#include <utility>

#include <libqhull_r/libqhull_r.h>
#include <Eigen/Geometry>

#include "base/error.h"
#include "base/numbers.h"
#include "base/spatial.h"

namespace thenar {
namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// Largest distance of a point outside a plane, over the extent [1]
constexpr double kContainmentTolerance = 1e-10;

/// File to which Qhull writes its messages.
class MessageFile {
 public:
  MessageFile() : file_(open_memstream(&text_, &size_)) {}
  ~MessageFile() {
    std::fclose(file_);
    std::free(text_);
  }
  MessageFile(const MessageFile&) = delete;
  MessageFile& operator=(const MessageFile&) = delete;

  [[nodiscard]] FILE* file() const { return file_; }
  [[nodiscard]] std::string first_line() const {
    std::fflush(file_);
    const std::string text(text_, size_);
    return text.substr(0, text.find('\n'));
  }

 private:
  char* text_ = nullptr;
  std::size_t size_ = 0;
  FILE* file_;
};

/// Run of Qhull; its memory is freed at the end.
class Qhull {
 public:
  explicit Qhull(RowMajor points) : points_(std::move(points)) {
    qh_zero(&qh_, messages_.file());
    char command[] = "qhull Pp";  // no joggling, no warnings about precision
    exit_code_ =
        qh_new_qhull(&qh_, static_cast<int>(points_.cols()), static_cast<int>(points_.rows()),
                     points_.data(), False, command, nullptr, messages_.file());
  }
  ~Qhull() {
    qh_freeqhull(&qh_, False);  // frees long blocks only; short ones follow
    int blocks = 0, bytes = 0;
    qh_memfreeshort(&qh_, &blocks, &bytes);
  }
  Qhull(const Qhull&) = delete;
  Qhull& operator=(const Qhull&) = delete;

  [[nodiscard]] std::string failure() const {
    return exit_code_ == 0 ? "" : "qhull: " + messages_.first_line();
  }

  [[nodiscard]] std::vector<HullFacet> facets() {
    std::vector<HullFacet> result;
    qhT* qh = &qh_;  // name that Qhull's macros expect
    facetT* facet = nullptr;
    FORALLfacets {
      HullFacet side{
          Eigen::Map<const Eigen::VectorXd>(facet->normal, points_.cols()), -facet->offset, {}};
      vertexT* vertex = nullptr;
      vertexT** vertexp = nullptr;
      FOREACHvertex_(facet->vertices) side.ring.push_back(qh_pointid(qh, vertex->point));
      result.push_back(std::move(side));
    }
    return result;
  }

 private:
  RowMajor points_;
  MessageFile messages_;
  qhT qh_{};
  int exit_code_ = 0;
};

/// Orders the corners of a convex polygon in space counterclockwise about its normal.
void sort_ring(const Eigen::Ref<const Eigen::MatrixXd>& points, HullFacet& facet) {
  const auto corner = [&](int row) -> Eigen::Vector3d { return points.row(row); };
  // Find the centre and axes of the polygon.
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  for (const int row : facet.ring) centre += corner(row) / static_cast<double>(facet.ring.size());
  const Tangents axes = tangents(facet.normal);
  const auto angle = [&](int row) {
    const Eigen::Vector3d offset = corner(row) - centre;
    return std::atan2(offset.dot(axes.e2), offset.dot(axes.e1));
  };
  std::sort(facet.ring.begin(), facet.ring.end(),
            [&](int a, int b) { return angle(a) < angle(b); });
}

/// Returns whether every edge of every ring is traversed once in each direction, and Euler's
/// formula holds.
bool is_closed(const std::vector<HullFacet>& facets, Eigen::Index d) {
  // Match each edge with the opposite one.
  std::set<std::pair<int, int>> open;
  std::set<int> corners;
  std::size_t edges = 0;
  for (const HullFacet& facet : facets) {
    corners.insert(facet.ring.begin(), facet.ring.end());
    if (d == 2) continue;
    for (std::size_t k = 0; k < facet.ring.size(); ++k, ++edges) {
      const std::pair<int, int> edge(facet.ring[k], facet.ring[(k + 1) % facet.ring.size()]);
      if (open.erase({edge.second, edge.first}) == 0 && !open.insert(edge).second) return false;
    }
  }
  // Check Euler's formula.
  if (d == 2) return corners.size() == facets.size();  // a ring of as many edges as corners
  return open.empty() && corners.size() + facets.size() == edges / 2 + 2;
}

/// Integrates x_k n_k over the surface for each k separately; each integral is the volume.
Eigen::VectorXd volumes(const Eigen::Ref<const Eigen::MatrixXd>& points, const ConvexHull& hull) {
  const Eigen::Index d = points.cols();
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(d);
  const auto offset = [&](int row) -> Eigen::VectorXd {
    return (points.row(row) - points.row(0)).transpose();
  };
  // Add each facet's contribution to the surface integral.
  for (const HullFacet& facet : hull.facets) {
    const Eigen::VectorXd first = offset(facet.ring[0]);
    if (d == 2) {
      const Eigen::VectorXd last = offset(facet.ring[1]);
      sums += (last - first).norm() * facet.normal.cwiseProduct((first + last) / 2);
      continue;
    }
    for (std::size_t k = 2; k < facet.ring.size(); ++k) {
      const Eigen::Vector3d a = first, b = offset(facet.ring[k - 1]), c = offset(facet.ring[k]);
      sums += ((b - a).cross(c - a) / 2).cwiseProduct((a + b + c) / 3);
    }
  }
  return sums;
}

/// Computes the check of a hull.
HullCheck check_hull(const Eigen::Ref<const Eigen::MatrixXd>& points, const ConvexHull& hull) {
  HullCheck check;
  // Distances of points beyond planes, and of corners from their own planes.
  for (const HullFacet& facet : hull.facets) {
    const Eigen::VectorXd beyond =
        (points * facet.normal).array() - facet.offset * facet.normal.norm();
    check.outside = max_or_nan(check.outside, max_or_nan(beyond));
    for (const int row : facet.ring) check.outside = max_or_nan(check.outside, -beyond(row));
  }
  // Closedness, and the volume from each axis.
  check.closed = is_closed(hull.facets, points.cols());
  const Eigen::VectorXd each = volumes(points, hull);
  check.volume = each.mean();
  check.volume_error = max_or_nan(each) + max_or_nan(-each);
  return check;
}

}  // namespace

ConvexHull convex_hull(const Eigen::Ref<const Eigen::MatrixXd>& points) {
  const Eigen::Index d = points.cols();
  // Check the input.
  require(d == 2 || d == 3, "hulls are made of points in 2 or 3 dimensions, got {}", d);
  require(points.rows() > d, "a hull in {} dimensions needs {} points, got {}", d, d + 1,
          points.rows());
  require(points.allFinite(), "points of a hull must be finite");

  // Run Qhull.
  Qhull qhull(points);
  ConvexHull hull{{}, qhull.failure(), {}};
  if (!hull.message.empty()) return hull;
  hull.facets = qhull.facets();
  if (d == 3)
    for (HullFacet& facet : hull.facets) sort_ring(points, facet);

  // Verify the result.
  hull.check = check_hull(points, hull);
  const double extent = (points.colwise().maxCoeff() - points.colwise().minCoeff()).maxCoeff();
  if (!(hull.check.outside <= kContainmentTolerance * extent))
    return {{},
            fmt::format("qhull: a point lies {:.2g} outside the hull", hull.check.outside),
            hull.check};
  return hull;
}

}  // namespace thenar
