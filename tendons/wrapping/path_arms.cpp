#include "tendons/wrapping/path_arms.h"

#include <Eigen/Geometry>

#include "base/error.h"

namespace thenar {
namespace {

using Eigen::Vector3d;
using Row = Eigen::Ref<Eigen::RowVectorXd, 0, Eigen::InnerStride<>>;

/// Adds  w . dp/dq  of a point of a link to a row.
void add_motion(const Tree<double>& tree, const TreeState<double>& state, int link,
                const Vector3d& p, const Vector3d& w, Row row) {
  for_each_hinge_to_base(tree, link, [&](int i) {
    const auto& at = state[i];
    row[tree[i].coordinate] += tree[i].ratio * w.dot(at.axis.cross(p - at.point));
  });
}

/// Adds -dL/dq of one straight run: only hinges between its two links count.
void add_span(const Tree<double>& tree, const TreeState<double>& state, const PathSpan& span,
              double scale, Row row) {
  if (span.link_a == span.link_b) return;
  // Compute direction and moment of the run's line.
  const Vector3d u = scale * span.u;
  const Vector3d moment = span.a.cross(u);
  // Climb both branches up to the common ancestor.
  for_each_hinge_between(tree, span.link_a, span.link_b, [&](int i, bool on_b) {
    const auto& at = state[i];
    const double pull = at.axis.dot(moment - at.point.cross(u));
    row[tree[i].coordinate] += tree[i].ratio * (on_b ? -pull : pull);
  });
}

/// Adds  -u . dx/dq  of an origin x that stays at a fixed distance from its carrier's insertion: dx
/// = da + v (excursion before a) + share (1 - v v') (db - da).
void add_riding(const Tree<double>& tree, const TreeState<double>& state, const PathSet& set,
                const std::vector<PathShape>& shapes, std::size_t path, const Row& row) {
  // Find the carrier's span at the origin, and the fraction of its length up to there.
  const PathShape &rider = shapes[path], &carrier = shapes[set.paths[path].carrier];
  const PathSpan &last = rider.spans.back(), &span = carrier.spans[rider.ride_span];
  const double share = span.length > 0 ? (last.b - span.a).dot(span.u) / span.length : 0;
  // Split the pull into the part along the carrier and the rest across it.
  const double along = last.u.dot(span.u);
  const Vector3d across = last.u - along * span.u;
  add_motion(tree, state, span.link_a, span.a, -along * span.u - (1 - share) * across, row);
  add_motion(tree, state, span.link_b, span.b, -share * across, row);
  // Add the part along the carrier, which shortens with that tendon.
  for (int k = 0; k < rider.ride_span; ++k) add_span(tree, state, carrier.spans[k], -along, row);
}

/// Adds the moment arms of a whole path to a row.
void add_path(const Tree<double>& tree, const TreeState<double>& state, const PathSet& set,
              const std::vector<PathShape>& shapes, std::size_t path, const Row& row) {
  // Add spans between links, and the last one of a riding tendon.
  for (const PathSpan& span : shapes[path].spans) {
    if (span.link_b != kRiding) {
      add_span(tree, state, span, 1, row);
      continue;
    }
    add_motion(tree, state, span.link_a, span.a, span.u, row);
    add_riding(tree, state, set, shapes, path, row);
  }
}

}  // namespace

void path_arms(const Tree<double>& tree, const TreeState<double>& state, const PathSet& set,
               const std::vector<PathShape>& shapes, Eigen::Ref<Eigen::MatrixXd> R) {
  require(R.rows() == static_cast<Eigen::Index>(shapes.size()),
          "moment arms of {} paths do not fit in {} rows", shapes.size(), R.rows());
  R.setZero();
  for (std::size_t k = 0; k < shapes.size(); ++k)
    add_path(tree, state, set, shapes, k, R.row(static_cast<Eigen::Index>(k)));
}

void path_arms(const Tree<double>& tree, const TreeState<double>& state, const PathSet& set,
               const std::vector<PathShape>& shapes, const std::vector<int>& rows,
               Eigen::Ref<Eigen::MatrixXd> R) {
  require(rows.size() == shapes.size(), "{} paths have {} rows", shapes.size(), rows.size());
  for (std::size_t k = 0; k < shapes.size(); ++k) {
    if (rows[k] < 0) continue;
    R.row(rows[k]).setZero();
    add_path(tree, state, set, shapes, k, R.row(rows[k]));
  }
}

}  // namespace thenar
