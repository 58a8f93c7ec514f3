#include "base/shapes/nearest_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace thenar::internal {

using Eigen::Vector3d, Eigen::Vector3i;

namespace {

constexpr double kMostCells = 2e5;
constexpr int kMostCandidates = 48;
constexpr double kBand = 2;  // cells with lists reach so far from the surface, in cells

/// The edge of a cell: about that of a triangle.
double cell_of(const TriangleTree& tree) {
  double area = 0;
  for (const TriangleForm& form : tree.forms())
    area += (form.corner[1] - form.corner[0]).cross(form.corner[2] - form.corner[0]).norm() / 2;
  const double by_area = std::sqrt(area / static_cast<double>(tree.forms().size()));
  const double longest = tree.bounds().sizes().maxCoeff();
  double cell = std::min(by_area, longest / 8);
  while (((tree.bounds().sizes().array() / cell).ceil() + 2 * kBand).prod() > kMostCells)
    cell *= 1.1;
  return cell;
}

double distance_to(const TriangleForm& form, const Vector3d& p) {
  FootPoint foot{std::numeric_limits<double>::infinity(), {}, {}};
  form.improve(p, foot);
  return std::sqrt(foot.squared);
}

}  // namespace

NearestGrid::Ball NearestGrid::ball_of(const TriangleForm& form) {
  const Vector3d centre = (form.corner[0] + form.corner[1] + form.corner[2]) / 3;
  double radius = 0;
  for (const Vector3d& corner : form.corner) radius = std::max(radius, (corner - centre).norm());
  return {centre, radius};
}

NearestGrid::NearestGrid(const TriangleTree& tree) {
  cell_ = cell_of(tree);
  inverse_ = 1 / cell_;
  origin_ = tree.bounds().min().array() - kBand * cell_;
  size_ = ((tree.bounds().sizes().array() / cell_).ceil() + 2 * kBand).cast<int>();
  cells_.resize(size_.prod());
  Block all{Vector3i::Zero(), 1};
  while (all.edge < size_.maxCoeff()) all.edge *= 2;
  std::vector<Candidate> every;
  for (std::size_t i = 0; i < tree.forms().size(); ++i) every.push_back({0, static_cast<int>(i)});
  for (const TriangleForm& form : tree.forms()) balls_.push_back(ball_of(form));
  refine(all, every, tree);
  balls_ = {};
}

Vector3d NearestGrid::centre(const Block& block) const {
  return origin_ + cell_ * (block.low.cast<double>() + Vector3d::Constant(block.edge / 2.0));
}

void NearestGrid::fill(const Block& block, const Cell& cell) {
  const Vector3i high = (block.low.array() + block.edge).min(size_.array());
  for (int z = block.low.z(); z < high.z(); ++z)
    for (int y = block.low.y(); y < high.y(); ++y)
      for (int x = block.low.x(); x < high.x(); ++x)
        cells_[x + size_.x() * (y + size_.y() * z)] = cell;
}

void NearestGrid::refine(const Block& block, const std::vector<Candidate>& above,
                         const TriangleTree& tree) {
  if ((block.low.array() >= size_.array()).any()) return;
  const Vector3d middle = centre(block);
  const double reach = std::sqrt(3.0) / 2 * cell_ * block.edge * (1 + 1e-9);
  const auto nearer = [](const Candidate& a, const Candidate& b) {
    return a.distance < b.distance || (a.distance == b.distance && a.triangle < b.triangle);
  };
  std::vector<Candidate> here;
  here.reserve(above.size());
  double least = std::numeric_limits<double>::infinity();
  // What was near before is asked first, so that most of the rest can be left out unasked.
  for (const Candidate& candidate : above) {
    const Ball& ball = balls_[candidate.triangle];
    const double most = least + 2 * reach + ball.radius;
    if ((ball.centre - middle).squaredNorm() > most * most) continue;
    const double distance = distance_to(tree.forms()[candidate.triangle], middle);
    least = std::min(least, distance);
    if (distance <= least + 2 * reach) here.push_back({distance, candidate.triangle});
  }
  const auto end = std::remove_if(here.begin(), here.end(), [&](const Candidate& candidate) {
    return candidate.distance > least + 2 * reach;
  });
  here.erase(end, here.end());
  std::swap(here.front(), *std::min_element(here.begin(), here.end(), nearer));
  const bool far = least - reach > kBand * cell_;
  if (block.edge > 1 && !far) {
    const int half = block.edge / 2;
    for (int c = 0; c < 8; ++c)
      refine({block.low + half * Vector3i(c & 1, c >> 1 & 1, c >> 2 & 1), half}, here, tree);
    return;
  }
  const bool listed = !far && here.size() <= kMostCandidates;
  const int first = static_cast<int>(candidates_.size());
  if (listed) {
    std::sort(here.begin(), here.end(), nearer);
    candidates_.insert(candidates_.end(), here.begin(), here.end());
  } else {
    candidates_.push_back(here.front());
  }
  fill(block, {first, listed ? static_cast<int>(here.size()) : -1});
}

NearestTriangle NearestGrid::nearest(const Vector3d& p, const TriangleTree& tree) const {
  NearestTriangle best;
  best.foot.squared = std::numeric_limits<double>::infinity();
  const Vector3d scaled = inverse_ * (p - origin_);
  const Vector3d inner = scaled.cwiseMax(0.0).cwiseMin((size_.array() - 1).matrix().cast<double>());
  const Vector3i at = inner.cast<int>();
  const Cell& cell = cells_[at.x() + size_.x() * (at.y() + size_.y() * at.z())];
  const bool listed = cell.count >= 0 && (scaled.array() >= 0).all() &&
                      (scaled.array() < size_.array().cast<double>()).all();
  const Candidate* candidate = candidates_.data() + cell.first;
  if (!listed) {
    if (tree.forms()[candidate->triangle].improve(p, best.foot))
      best.triangle = candidate->triangle;
    return tree.nearest(p, best);
  }
  const double off = (p - origin_ - cell_ * (at.cast<double>() + Vector3d::Constant(0.5))).norm();
  for (int i = 0; i < cell.count; ++i) {
    const double bound = candidate[i].distance - off;
    if (bound > 0 && bound * bound >= best.foot.squared) break;
    if (tree.forms()[candidate[i].triangle].improve(p, best.foot))
      best.triangle = candidate[i].triangle;
  }
  return best;
}

}  // namespace thenar::internal
