#include "solvers/incremental_hull.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/LU>
#include <Eigen/QR>

namespace thenar::internal {
namespace {

constexpr double kUnitRoundoff = std::numeric_limits<double>::epsilon();
// Rounding error of n'p - d, over the size [1]
constexpr double kPlaneRounding = 32 * kUnitRoundoff;
// Plane error above which the residual is computed, over the size [1]
constexpr double kErrorToCheck = 1e-13;

/// Hashes a number to 64 bits (the finaliser of SplitMix64).
std::uint64_t hash(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15ULL;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

/// Returns the position of vertex j in the facet without vertex i, such that all facets have the
/// same orientation: in order, but with the first two swapped in every other facet.
int position_in_simplex(int i, int j) {
  const int place = j < i ? j : j - 1;
  return i % 2 == 1 && place < 2 ? 1 - place : place;
}

}  // namespace

Hull::Hull(const std::array<HullPoint, 7>& simplex)
    : offset_limit_(std::numeric_limits<double>::infinity()) {
  // Add the seven points; their mean is an inner point.
  for (const HullPoint& p : simplex) {
    inside_ += p / 7;
    size_ = std::max(size_, p.norm());
    codes_.push_back(hash(points_.size()));
    points_.push_back(p);
  }
  // Link the facets: facet i lacks vertex i, and is the neighbour of facet j across the ridge
  // without j.
  for (int i = 0; i < 7; ++i) (void)new_facet();
  for (int i = 0; i < 7; ++i) {
    Links& links = links_[i];
    for (int j = 0; j < 7; ++j) {
      if (j == i) continue;
      const int place = position_in_simplex(i, j);
      links.vertex[place] = links.neighbour[place] = j;
      links.back[place] = static_cast<std::int8_t>(position_in_simplex(j, i));
    }
    planes_[i] = solve(links);
    error_ = std::max(error_, planes_[i].error);
    queue(i);
  }
}

int Hull::new_facet() {
  // Reuse a free entry.
  ++facet_count_;
  int facet = static_cast<int>(links_.size());
  if (free_.empty()) {
    links_.emplace_back();
    planes_.emplace_back();
  } else {
    facet = free_.back();
    free_.pop_back();
  }
  links_[facet].serial = ++last_serial_;
  links_[facet].insertion = insertion_;
  links_[facet].s = 0;
  return facet;
}

void Hull::queue(int facet) {
  const double d = planes_[facet].d;
  if (d >= offset_limit_) return;
  queue_.push_back({d, facet, links_[facet].serial});
  std::push_heap(queue_.begin(), queue_.end(),
                 [](const Queued& a, const Queued& b) { return a.d > b.d; });
}

int Hull::pop_nearest() {
  while (!queue_.empty()) {
    std::pop_heap(queue_.begin(), queue_.end(),
                  [](const Queued& a, const Queued& b) { return a.d > b.d; });
    const Queued next = queue_.back();
    queue_.pop_back();
    if (links_[next.facet].serial != next.serial) continue;
    if (next.d < offset_limit_) return next.facet;
    queue_.clear();  // all others are farther away
  }
  return -1;
}

bool Hull::insert(const HullPoint& p, int facet) {
  size_ = std::max(size_, p.norm());
  find_visible(p, facet);
  if (visible_.empty()) return false;
  const int point = static_cast<int>(points_.size());
  points_.push_back(p);
  codes_.push_back(hash(points_.size()));

  // Enlarge the hash table of ridges.
  std::size_t capacity = std::max<std::size_t>(table_.size(), 64);
  while (capacity < 8 * horizon_.size()) capacity *= 2;
  if (capacity != table_.size()) table_.assign(capacity, {0, 0, -1, 0});

  // Add a new facet over every ridge of the horizon, and free the visible ones.
  for (const Ridge& ridge : horizon_) match_ridges(add_facet(ridge, point), ridge.place);
  for (const int facet_to_free : visible_) {
    links_[facet_to_free].serial = 0;
    free_.push_back(facet_to_free);
    --facet_count_;
  }
  return true;
}

void Hull::find_visible(const HullPoint& p, int facet) {
  ++insertion_;
  visible_.clear();
  horizon_.clear();
  // Computes the signed distance of each facet once per insertion.
  const auto is_visible = [&](int f) {
    Links& links = links_[f];
    if (links.insertion == insertion_) return links.s > 0;
    links.insertion = insertion_;
    const Plane& plane = planes_[f];
    const double s = plane.n.dot(p) - plane.d;
    links.s = s > plane.error + kPlaneRounding * size_ ? s : std::min(s, 0.0);
    if (links.s > 0) visible_.push_back(f);
    return links.s > 0;
  };
  // Search breadth-first; ridges to hidden neighbours form the horizon.
  is_visible(facet);
  // NOLINTNEXTLINE(modernize-loop-convert): visible_ grows in the loop
  for (std::size_t k = 0; k < visible_.size(); ++k) {
    const int f = visible_[k];
    for (int i = 0; i < 6; ++i)
      if (!is_visible(links_[f].neighbour[i])) horizon_.push_back({f, i});
  }
}

int Hull::add_facet(const Ridge& ridge, int point) {
  const int facet = new_facet();
  Links& links = links_[facet];
  const Links& seen = links_[ridge.facet];
  const int place = ridge.place;
  const int across = seen.neighbour[place];
  Links& hidden = links_[across];

  // Replace the visible facet at the ridge.
  links.vertex = seen.vertex;
  links.vertex[place] = point;
  links.neighbour[place] = across;
  links.back[place] = seen.back[place];
  hidden.neighbour[seen.back[place]] = facet;
  hidden.back[seen.back[place]] = static_cast<std::int8_t>(ridge.place);

  // Its plane is in the pencil of both planes.
  planes_[facet] = pencil_plane(seen, planes_[ridge.facet], hidden, planes_[across]);
  check_plane(facet);
  queue(facet);
  return facet;
}

Hull::Plane Hull::pencil_plane(const Links& seen, const Plane& a, const Links& hidden,
                               const Plane& b) const {
  // Weighted sum with nonnegative weights.
  const double wa = -hidden.s, wb = seen.s;
  Plane out{wa * a.n + wb * b.n, wa * a.d + wb * b.d, 0};
  const double scale = 1 / out.n.norm();
  out.n *= scale;
  out.d *= scale;
  out.error = scale * (wa * a.error + wb * b.error + kPlaneRounding * size_ * (wa + wb));
  return out;
}

void Hull::check_plane(int facet) {
  Plane& plane = planes_[facet];
  const Links& links = links_[facet];
  // If the error bound is large, compute the residual and, if necessary, solve for the plane.
  if (!(plane.error <= kErrorToCheck * size_)) {
    plane.error = residual(plane, links);
    if (!(plane.error <= kErrorToCheck * size_)) {
      const Plane solved = solve(links);
      if (!(plane.error <= solved.error)) plane = solved;
    }
  }
  error_ = std::max(error_, plane.error);
}

double Hull::residual(const Plane& plane, const Links& links) const {
  double worst = 0;
  for (const int v : links.vertex)
    worst = std::max(worst, std::abs(plane.n.dot(points_[v]) - plane.d));
  return std::isfinite(plane.d) ? worst + kPlaneRounding * size_
                                : std::numeric_limits<double>::infinity();
}

Hull::Plane Hull::solve(const Links& links) const {
  // Find the normal to five edges by QR.
  Eigen::Matrix<double, 6, 5> edges;
  const HullPoint& origin = points_[links.vertex[5]];
  for (int i = 0; i < 5; ++i) edges.col(i) = points_[links.vertex[i]] - origin;
  const Eigen::ColPivHouseholderQR<Eigen::Matrix<double, 6, 5>> qr(edges);
  const Eigen::Matrix<double, 6, 6> Q = qr.householderQ();
  Plane plane{Q.col(5), Q.col(5).dot(origin), 0};
  if (plane.n.dot(inside_) > plane.d) plane = {-plane.n, -plane.d, 0};
  plane.error = residual(plane, links);
  return plane;
}

void Hull::match_ridges(int facet, int place_of_point) {
  const Links& links = links_[facet];
  // Each ridge of the new facet meets one of another new facet with the same five vertices.
  std::uint64_t sum = 0;
  for (const int v : links.vertex) sum += codes_[v];
  for (int i = 0; i < 6; ++i)
    if (i != place_of_point)
      match_ridge(facet, static_cast<std::int8_t>(i), sum - codes_[links.vertex[i]]);
}

void Hull::match_ridge(int facet, std::int8_t place, std::uint64_t key) {
  // Hash table: the first ridge of a pair is stored until the second one comes.
  const std::size_t mask = table_.size() - 1;
  for (std::size_t i = key & mask;; i = (i + 1) & mask) {
    Slot& slot = table_[i];
    if (slot.insertion != insertion_) {
      slot = {key, insertion_, facet, place};
      return;
    }
    if (slot.key != key || slot.facet < 0) continue;
    links_[facet].neighbour[place] = slot.facet;
    links_[facet].back[place] = slot.place;
    links_[slot.facet].neighbour[slot.place] = facet;
    links_[slot.facet].back[slot.place] = place;
    slot.facet = -1;
    return;
  }
}

double Hull::inner_radius() const {
  double radius = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < links_.size(); ++i)
    if (links_[i].serial != 0) radius = std::min(radius, planes_[i].d - planes_[i].n.dot(inside_));
  return radius;
}

double Hull::volume() const {
  double sum = 0;
  for (const Links& links : links_) {
    if (links.serial == 0) continue;
    Eigen::Matrix<double, 6, 6> edges;
    for (int i = 0; i < 6; ++i) edges.col(i) = points_[links.vertex[i]] - inside_;
    sum += edges.determinant();
  }
  return std::abs(sum) / 720;  // 6!; all facets have the same orientation
}

}  // namespace thenar::internal
