#include "tendons/convex_hull.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include <libqhull_r/libqhull_r.h>
#include <Eigen/Geometry>

#include "base/error.h"
#include "base/spatial.h"

namespace thenar {
namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Where Qhull writes its complaints.
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

/// One run of Qhull, freed at the end.
class Qhull {
 public:
  explicit Qhull(RowMajor points) : points_(std::move(points)) {
    qh_zero(&qh_, messages_.file());
    char command[] = "qhull Pp";  // no joggle, no warnings about precision
    exit_code_ =
        qh_new_qhull(&qh_, static_cast<int>(points_.cols()), static_cast<int>(points_.rows()),
                     points_.data(), False, command, nullptr, messages_.file());
  }
  ~Qhull() {
    qh_freeqhull(&qh_, !qh_ALL);
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
    qhT* qh = &qh_;  // the name Qhull's macros look for
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
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  for (const int row : facet.ring) centre += corner(row) / static_cast<double>(facet.ring.size());
  const Tangents axes = tangents(facet.normal);
  const auto angle = [&](int row) {
    const Eigen::Vector3d arm = corner(row) - centre;
    return std::atan2(arm.dot(axes.e2), arm.dot(axes.e1));
  };
  std::sort(facet.ring.begin(), facet.ring.end(),
            [&](int a, int b) { return angle(a) < angle(b); });
}

}  // namespace

ConvexHull convex_hull(const Eigen::Ref<const Eigen::MatrixXd>& points) {
  const Eigen::Index d = points.cols();
  require(d == 2 || d == 3, "hulls are made of points in 2 or 3 dimensions, got {}", d);
  require(points.rows() > d, "a hull in {} dimensions needs {} points, got {}", d, d + 1,
          points.rows());
  require(points.allFinite(), "points of a hull must be finite");

  Qhull qhull(points);
  ConvexHull hull{{}, qhull.failure()};
  if (!hull.failure.empty()) return hull;
  hull.facets = qhull.facets();
  if (d == 3)
    for (HullFacet& facet : hull.facets) sort_ring(points, facet);
  return hull;
}

}  // namespace thenar
