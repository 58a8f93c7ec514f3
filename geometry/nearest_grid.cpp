#include "geometry/nearest_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "base/lists.h"

namespace thenar::internal {

using Eigen::Vector3d, Eigen::Vector3i;
using PerCorner = Eigen::Array<double, 8, 1>;

namespace {

constexpr double kMaxCells = 1e5;  // maximum number of cells; the mesh gets a quarter
constexpr double kGridMargin = 1;  // margin of the cubes around the mesh over its longest side [1]
// Dividing is in vain if it leaves more than this share of the candidates [1]
constexpr double kInVain = 0.7;
constexpr std::size_t kFewCandidates =
    32;                           // number of candidates up to which a cube is not divided
constexpr std::size_t kMax = 64;  // number of candidates above which the tree is searched instead
// Candidates that are tested in the time of one search by the tree
constexpr int kTreeCandidates = 24;

/// Returns the edge of the smallest cubes: about that of a triangle.
double cell_of(const TriangleTree& tree) {
  double area = 0;
  for (const TriangleForm& form : tree.forms())
    area += (form.corner[1] - form.corner[0]).cross(form.corner[2] - form.corner[0]).norm() / 2;
  const double count = std::min(static_cast<double>(tree.forms().size()), kMaxCells / 4);
  return std::min(std::sqrt(area / count), tree.bounds().sizes().maxCoeff() / 8);
}

FootPoint foot_on(const TriangleForm& form, const Vector3d& p) {
  FootPoint foot;
  form.find_foot(p, std::numeric_limits<double>::infinity(), foot);
  return foot;
}

/// Keeps the point of a triangle nearest to p if it is nearer than the best so far.
void keep_nearer(const TriangleForm& form, const Vector3d& p, FootPoint& best) {
  FootPoint foot;
  if (form.find_foot(p, best.squared, foot) && foot.squared < best.squared) best = foot;
}

}  // namespace

NearestGrid::Ball NearestGrid::bounding_ball(const TriangleForm& form) {
  const Vector3d centre = (form.corner[0] + form.corner[1] + form.corner[2]) / 3;
  double radius = 0;
  for (const Vector3d& corner : form.corner) radius = std::max(radius, (corner - centre).norm());
  return {centre, radius};
}

NearestGrid::NearestGrid(const TriangleTree& tree, double share) : share_(share) {
  // Enclose the mesh in a cube of a power of two of smallest cubes.
  const double longest = tree.bounds().sizes().maxCoeff();
  const double whole = (1 + 2 * kGridMargin) * longest;
  levels_ = std::max(0, static_cast<int>(std::floor(std::log2(whole / cell_of(tree)))));
  cell_ = std::ldexp(whole, -levels_);
  inverse_ = 1 / cell_;
  origin_ = tree.bounds().center().array() - whole / 2;
  // List all triangles, with a ball around each.
  all_triangles_.resize(tree.forms().size());
  std::iota(all_triangles_.begin(), all_triangles_.end(), 0);
  balls_.reserve(all_triangles_.size());
  for (const TriangleForm& form : tree.forms()) balls_.push_back(bounding_ball(form));
}

NearestGrid::~NearestGrid() = default;

Vector3d NearestGrid::centre(const Block& block) const {
  return origin_ +
         cell_ * (block.low.cast<double>() + Vector3d::Constant(std::ldexp(0.5, block.level)));
}

std::vector<NearestGrid::Candidate> NearestGrid::find_candidates(const Block& block,
                                                                 const std::vector<int>& above,
                                                                 const TriangleTree& tree) const {
  const Vector3d middle = centre(block);
  const double reach = std::sqrt(3.0) / 2 * std::ldexp(cell_, block.level) * (1 + 1e-9);
  std::vector<Candidate> here;
  here.reserve(above.size());
  double least = std::numeric_limits<double>::infinity();
  // Evaluate candidates of the larger cube first: they exclude most others without evaluation.
  for (const int triangle : above) {
    const Ball& ball = balls_[triangle];
    const double most = least + 2 * reach + ball.radius;
    if ((ball.centre - middle).squaredNorm() > most * most) continue;
    const double distance = std::sqrt(foot_on(tree.forms()[triangle], middle).squared);
    least = std::min(least, distance);
    if (distance <= least + 2 * reach) here.push_back({distance, triangle});
  }
  // Remove triangles too far for any point of the cube.
  erase_where(here, [&](const Candidate& each) { return each.distance > least + 2 * reach; });
  // Apply a sharper test to long lists, and put the nearest first.
  if (here.size() > kFewCandidates) remove_dominated(block, here, tree);
  std::swap(here.front(), *std::min_element(here.begin(), here.end(), is_nearer));
  return here;
}

bool NearestGrid::is_nearer(const Candidate& a, const Candidate& b) {
  return a.distance < b.distance || (a.distance == b.distance && a.triangle < b.triangle);
}

void NearestGrid::remove_dominated(const Block& block, std::vector<Candidate>& here,
                                   const TriangleTree& tree) const {
  // Compute the corners of the cube, and distances of a point from all of them.
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
  // Compute the distances of the triangles' balls, and the points of the mesh nearest to the
  // corners.
  std::vector<PerCorner> least;
  least.reserve(here.size());
  std::array<FootPoint, 8> best;
  for (FootPoint& foot : best) foot.squared = std::numeric_limits<double>::infinity();
  for (const Candidate& candidate : here) {
    const Ball& ball = balls_[candidate.triangle];
    least.emplace_back(to_corners(ball.centre) - ball.radius);
    for (int c = 0; c < 8; ++c)
      if (least.back()(c) < 0 || least.back()(c) * least.back()(c) < best[c].squared)
        keep_nearer(tree.forms()[candidate.triangle], corner.row(c).transpose(), best[c]);
  }
  // Take those eight points of the mesh as rivals.
  std::array<PerCorner, 8> rival;
  for (int s = 0; s < 8; ++s) rival[s] = to_corners(best[s].point) + rounding;
  const auto beaten = [&](const PerCorner& distance) {
    return any_of(rival, [&](const PerCorner& point) { return (distance > point).all(); });
  };
  // Remove triangles that a rival beats everywhere, by their ball or exactly.
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

bool NearestGrid::fill_if_due(Cell& cell, const Block& block, const std::vector<int>& above,
                              const TriangleTree& tree) const {
  // Fill the cell only after enough queries, and if no other thread fills it.
  const int queries = cell.queries.fetch_add(1, std::memory_order_relaxed);
  if (queries < static_cast<int>(above.size()) / kTreeCandidates) return false;
  const std::unique_lock lock(filling_, std::try_to_lock);
  if (!lock.owns_lock()) return false;
  if (cell.count.load(std::memory_order_relaxed) == kUnfilled) fill(cell, block, above, tree);
  return true;
}

void NearestGrid::fill(Cell& cell, const Block& block, const std::vector<int>& above,
                       const TriangleTree& tree) const {
  // Find candidates, and decide whether dividing would help.
  std::vector<Candidate> here = find_candidates(block, above, tree);
  const double edge = std::ldexp(cell_, block.level);
  const double far = here.front().distance;
  const bool in_vain = edge<far&& static_cast<double>(here.size())> kInVain * above.size();
  // Divide the cube.
  if (block.level > 0 && here.size() > kFewCandidates && edge > share_ * far && !in_vain) {
    auto divided = std::make_unique<Divided>();
    divided->triangles = transformed(here, [](const Candidate& each) { return each.triangle; });
    cell.divided = divided.get();
    divided_.push_back(std::move(divided));
    cell.count.store(kDivided, std::memory_order_release);
    return;
  }
  // Otherwise store a list, or the nearest as a guess for the tree.
  const bool listed = here.size() <= kMax;
  if (listed) std::sort(here.begin(), here.end(), is_nearer);
  const std::size_t count = listed ? here.size() : 1;
  candidates_.push_back(std::make_unique<Candidate[]>(count));
  std::copy_n(here.begin(), count, candidates_.back().get());
  cell.candidates = candidates_.back().get();
  cell.count.store(listed ? static_cast<int>(count) : kGuess, std::memory_order_release);
}

NearestTriangle NearestGrid::nearest(const Vector3d& p, const TriangleTree& tree) const {
  // Find the cell of the point, clamped to the grid.
  NearestTriangle best;
  const Vector3d scaled = inverse_ * (p - origin_);
  const double size = std::ldexp(1.0, levels_);
  const Vector3i at = scaled.cwiseMax(0.0).cwiseMin(size - 1).cast<int>();
  const auto block_at = [&](int level) -> Block {
    return {at.unaryExpr([level](int a) { return a >> level << level; }), level};
  };
  // Descend to the smallest cube that is not divided.
  int level = levels_;
  Cell* cell = &root_;
  const std::vector<int>* above = &all_triangles_;
  int count = cell->count.load(std::memory_order_acquire);
  while (count < kGuess) {
    if (count == kDivided) {
      --level;
      const Vector3i side = at.unaryExpr([level](int a) { return a >> level & 1; });
      Divided& divided = *cell->divided;
      above = &divided.triangles;
      cell = &divided.cells[side.x() + 2 * side.y() + 4 * side.z()];
    } else if (!fill_if_due(*cell, block_at(level), *above, tree)) {
      tree.update_nearest(above->front(), p, best);
      return tree.nearest(p, best);
    }
    count = cell->count.load(std::memory_order_acquire);
  }
  // Search the tree for a point outside, or from a guess.
  const Candidate* candidate = cell->candidates;
  if (count == kGuess || !(scaled.array() >= 0 && scaled.array() < size).all()) {
    tree.update_nearest(candidate->triangle, p, best);
    return tree.nearest(p, best);
  }
  // Search the list until no triangle can be nearer.
  const double off = (p - centre(block_at(level))).norm();
  for (int i = 0; i < count; ++i) {
    const double bound = candidate[i].distance - off;
    if (bound > 0 && bound * bound > best.limit) break;
    tree.update_nearest(candidate[i].triangle, p, best);
  }
  return best;
}

}  // namespace thenar::internal
