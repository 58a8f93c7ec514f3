#include "base/shapes/nearest_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace thenar::internal {

using Eigen::Vector3d, Eigen::Vector3i;
using PerCorner = Eigen::Array<double, 8, 1>;

namespace {

constexpr double kMostCells = 1e5;
constexpr double kAround = 1;      // cubes reach so far beyond the mesh, in its longest sides
constexpr double kInVain = 0.7;    // of its candidates, what dividing must leave out
constexpr std::size_t kFew = 32;   // candidates that need not be divided
constexpr std::size_t kMost = 64;  // candidates that are not searched for by the tree

/// The edge of a smallest cube: about that of a triangle.
double cell_of(const TriangleTree& tree) {
  double area = 0;
  for (const TriangleForm& form : tree.forms())
    area += (form.corner[1] - form.corner[0]).cross(form.corner[2] - form.corner[0]).norm() / 2;
  const double count = std::min(static_cast<double>(tree.forms().size()), kMostCells / 4);
  return std::min(std::sqrt(area / count), tree.bounds().sizes().maxCoeff() / 8);
}

FootPoint foot_on(const TriangleForm& form, const Vector3d& p) {
  FootPoint foot{std::numeric_limits<double>::infinity(), {}, {}};
  form.improve(p, foot);
  return foot;
}

}  // namespace

NearestGrid::Ball NearestGrid::ball_of(const TriangleForm& form) {
  const Vector3d centre = (form.corner[0] + form.corner[1] + form.corner[2]) / 3;
  double radius = 0;
  for (const Vector3d& corner : form.corner) radius = std::max(radius, (corner - centre).norm());
  return {centre, radius};
}

NearestGrid::NearestGrid(const TriangleTree& tree, double share) : share_(share) {
  const double longest = tree.bounds().sizes().maxCoeff();
  const double whole = (1 + 2 * kAround) * longest;
  levels_ = std::max(0, static_cast<int>(std::floor(std::log2(whole / cell_of(tree)))));
  cell_ = std::ldexp(whole, -levels_);
  inverse_ = 1 / cell_;
  origin_ = tree.bounds().center().array() - whole / 2;
  std::vector<Candidate> every;
  for (std::size_t i = 0; i < tree.forms().size(); ++i) every.push_back({0, static_cast<int>(i)});
  for (const TriangleForm& form : tree.forms()) balls_.push_back(ball_of(form));
  cells_.resize(1);
  refine(0, {Vector3i::Zero(), levels_}, every, tree);
  balls_ = {};
}

Vector3d NearestGrid::centre(const Block& block) const {
  return origin_ +
         cell_ * (block.low.cast<double>() + Vector3d::Constant(std::ldexp(0.5, block.level)));
}

std::vector<NearestGrid::Candidate> NearestGrid::near(const Block& block,
                                                      const std::vector<Candidate>& above,
                                                      const TriangleTree& tree) const {
  const Vector3d middle = centre(block);
  const double reach = std::sqrt(3.0) / 2 * std::ldexp(cell_, block.level) * (1 + 1e-9);
  std::vector<Candidate> here;
  here.reserve(above.size());
  double least = std::numeric_limits<double>::infinity();
  // What was near before is asked first, so that most of the rest can be left out unasked.
  for (const Candidate& candidate : above) {
    const Ball& ball = balls_[candidate.triangle];
    const double most = least + 2 * reach + ball.radius;
    if ((ball.centre - middle).squaredNorm() > most * most) continue;
    const double distance = std::sqrt(foot_on(tree.forms()[candidate.triangle], middle).squared);
    least = std::min(least, distance);
    if (distance <= least + 2 * reach) here.push_back({distance, candidate.triangle});
  }
  const auto end = std::remove_if(here.begin(), here.end(), [&](const Candidate& candidate) {
    return candidate.distance > least + 2 * reach;
  });
  here.erase(end, here.end());
  if (here.size() > kFew) drop_beaten(block, here, tree);
  std::swap(here.front(), *std::min_element(here.begin(), here.end(), nearer));
  return here;
}

bool NearestGrid::nearer(const Candidate& a, const Candidate& b) {
  return a.distance < b.distance || (a.distance == b.distance && a.triangle < b.triangle);
}

void NearestGrid::drop_beaten(const Block& block, std::vector<Candidate>& here,
                              const TriangleTree& tree) const {
  const double edge = std::ldexp(cell_, block.level), rounding = 1e-9 * edge;
  Eigen::Array<double, 8, 3> corner;
  for (int c = 0; c < 8; ++c)
    corner.row(c) = (origin_ + cell_ * block.low.cast<double>() +
                     edge * Vector3d(c & 1, c >> 1 & 1, c >> 2 & 1))
                        .transpose();
  const auto to_corners = [&](const Vector3d& p) -> PerCorner {
    return ((corner.col(0) - p.x()).square() + (corner.col(1) - p.y()).square() +
            (corner.col(2) - p.z()).square())
        .sqrt();
  };
  // How far the triangles' balls are, and the points of the mesh nearest to the corners.
  std::vector<PerCorner> least;
  least.reserve(here.size());
  std::array<FootPoint, 8> best;
  for (FootPoint& foot : best) foot.squared = std::numeric_limits<double>::infinity();
  for (const Candidate& candidate : here) {
    const Ball& ball = balls_[candidate.triangle];
    least.push_back(to_corners(ball.centre) - ball.radius);
    for (int c = 0; c < 8; ++c)
      if (least.back()(c) < 0 || least.back()(c) * least.back()(c) < best[c].squared)
        tree.forms()[candidate.triangle].improve(corner.row(c).transpose(), best[c]);
  }
  std::array<PerCorner, 8> rival;
  for (int s = 0; s < 8; ++s) rival[s] = to_corners(best[s].at) + rounding;
  const auto beaten = [&](const PerCorner& distance) {
    return std::any_of(rival.begin(), rival.end(),
                       [&](const PerCorner& point) { return (distance > point).all(); });
  };
  std::size_t kept = 0;
  for (std::size_t i = 0; i < here.size(); ++i) {
    if (beaten(least[i])) continue;
    PerCorner exact;
    for (int c = 0; c < 8; ++c)
      exact(c) =
          std::sqrt(foot_on(tree.forms()[here[i].triangle], corner.row(c).transpose()).squared);
    if (!beaten(exact)) here[kept++] = here[i];
  }
  here.resize(kept);
}

void NearestGrid::refine(int at, const Block& block, const std::vector<Candidate>& above,
                         const TriangleTree& tree) {
  std::vector<Candidate> here = near(block, above, tree);
  const double edge = std::ldexp(cell_, block.level);
  const double far = here.front().distance;
  const bool in_vain = edge<far&& static_cast<double>(here.size())> kInVain * above.size();
  if (block.level > 0 && here.size() > kFew && edge > share_ * far && !in_vain) {
    const int first = static_cast<int>(cells_.size());
    cells_[at] = {first, kDivided};
    cells_.resize(cells_.size() + 8);
    const int half = 1 << (block.level - 1);
    for (int c = 0; c < 8; ++c)
      refine(first + c,
             {block.low + half * Vector3i(c & 1, c >> 1 & 1, c >> 2 & 1), block.level - 1}, here,
             tree);
    return;
  }
  const bool listed = here.size() <= kMost;
  if (listed) std::sort(here.begin(), here.end(), nearer);
  cells_[at] = {static_cast<int>(candidates_.size()),
                listed ? static_cast<int>(here.size()) : kGuess};
  candidates_.insert(candidates_.end(), here.begin(), listed ? here.end() : here.begin() + 1);
}

NearestTriangle NearestGrid::nearest(const Vector3d& p, const TriangleTree& tree) const {
  NearestTriangle best;
  best.foot.squared = std::numeric_limits<double>::infinity();
  const Vector3d scaled = inverse_ * (p - origin_);
  const double size = std::ldexp(1.0, levels_);
  const Vector3i at = scaled.cwiseMax(0.0).cwiseMin(size - 1).cast<int>();
  int level = levels_;
  const Cell* cell = cells_.data();
  while (cell->count == kDivided) {
    --level;
    const Vector3i side = at.unaryExpr([level](int a) { return a >> level & 1; });
    cell = &cells_[cell->first + side.x() + 2 * side.y() + 4 * side.z()];
  }
  const Candidate* candidate = candidates_.data() + cell->first;
  if (cell->count == kGuess || !(scaled.array() >= 0 && scaled.array() < size).all()) {
    if (tree.forms()[candidate->triangle].improve(p, best.foot))
      best.triangle = candidate->triangle;
    return tree.nearest(p, best);
  }
  const Vector3i low = at.unaryExpr([level](int a) { return a >> level << level; });
  const double off = (p - centre({low, level})).norm();
  for (int i = 0; i < cell->count; ++i) {
    const double bound = candidate[i].distance - off;
    if (bound > 0 && bound * bound >= best.foot.squared) break;
    if (tree.forms()[candidate[i].triangle].improve(p, best.foot))
      best.triangle = candidate[i].triangle;
  }
  return best;
}

}  // namespace thenar::internal
