#include "contact/friction_pyramids.h"

#include <cmath>

#include "base/units.h"

namespace thenar::internal {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Returns the unit directions of a polygon, or of a polyhedron in a ball (tangents, count).
MatrixXd edge_directions(int tangents, int edges) {
  // A polygon has the equator alone; a polyhedron has circles of latitude, one angle step apart.
  const double angle_step = 2 * kPi / edges;
  const int circles = tangents == 2 ? 0 : edges / 4;  // circles of latitude above the equator
  std::vector<Eigen::Vector3d> out;
  for (int circle = -circles; circle <= circles; ++circle) {
    const double latitude = circle * angle_step;
    // All directions at a pole coincide.
    if (std::abs(latitude) > kPi / 2 - angle_step / 4) {
      out.emplace_back(0, 0, circle > 0 ? 1 : -1);
      continue;
    }
    for (int k = 0; k < edges; ++k)
      out.emplace_back(std::cos(latitude) * std::cos(k * angle_step),
                       std::cos(latitude) * std::sin(k * angle_step), std::sin(latitude));
  }
  MatrixXd directions(tangents, static_cast<Index>(out.size()));
  for (Index k = 0; k < directions.cols(); ++k) directions.col(k) = out[k].head(tangents);
  return directions;
}

/// Builder of a PyramidProblem from its generators and limits.
class PyramidBuilder {
 public:
  explicit PyramidBuilder(Index rows) : rows_(rows), origin_(VectorXd::Zero(rows)) {}

  /// Adds an unknown impulse along a direction of some rows. @return its index
  Index add_generator(int start, const VectorXd& direction) {
    VectorXd column = VectorXd::Zero(rows_);
    column.segment(start, direction.size()) = direction;
    generators_.push_back(column);
    return static_cast<Index>(generators_.size()) - 1;
  }
  /// Adds the constraint  bound + factor z_normal >= sum of the unknowns from `first` on,  with its
  /// multiplier. @param normal  index of an unknown; -1: none
  void add_limit(Index first, double bound, Index normal, double factor) {
    limits_.push_back({first, static_cast<Index>(generators_.size()), bound, normal, factor});
  }
  void set_origin(int row, double f) { origin_(row) = f; }

  [[nodiscard]] PyramidProblem build(const ScaledContacts& contacts) const {
    const auto g = static_cast<Index>(generators_.size()), l = static_cast<Index>(limits_.size());
    // Collect the generators as columns.
    PyramidProblem out;
    out.origin = origin_;
    out.generators.resize(rows_, g);
    for (Index k = 0; k < g; ++k) out.generators.col(k) = generators_[k];

    // The complement of a generator is the velocity along it.
    MatrixXd& M = out.lcp.M;
    M = MatrixXd::Zero(g + l, g + l);
    M.topLeftCorner(g, g) = out.generators.transpose() * contacts.A() * out.generators;
    out.lcp.q = VectorXd::Zero(g + l);
    out.lcp.q.head(g) = out.generators.transpose() * (contacts.A() * origin_ + contacts.b());
    // The complement of a multiplier is the slack of its limit.
    for (Index k = 0; k < l; ++k) {
      const Limit& limit = limits_[k];
      const Index count = limit.end - limit.first;
      M.block(limit.first, g + k, count, 1).setOnes();
      M.block(g + k, limit.first, 1, count).setConstant(-1);
      if (limit.normal >= 0) M(g + k, limit.normal) = limit.factor;
      out.lcp.q(g + k) = limit.bound;
    }
    return out;
  }

 private:
  struct Limit {
    Index first, end;  // range of the unknowns in the sum
    double bound;      // constant part of the limit
    Index normal;      // unknown with a factor; -1: none
    double factor;     // factor of that unknown
  };
  Index rows_;
  VectorXd origin_;
  std::vector<VectorXd> generators_;
  std::vector<Limit> limits_;
};

/// Adds an interval: an origin at a finite bound and a generator away from it, or two generators if
/// there is no finite bound.
void add_interval(const ScaledBlock& block, PyramidBuilder* builder) {
  const VectorXd up = VectorXd::Ones(1), down = -up;
  const bool has_lower = std::isfinite(block.lower), has_upper = std::isfinite(block.upper);
  builder->set_origin(block.start, has_lower ? block.lower : has_upper ? block.upper : 0);
  if (block.lower == block.upper) return;
  if (!has_lower && !has_upper) builder->add_generator(block.start, up);
  const Index only = builder->add_generator(block.start, has_lower ? up : down);
  if (has_lower && has_upper) builder->add_limit(only, block.upper - block.lower, -1, 0);
}

/// Adds a normal and the edges of its pyramid, whose sum is at most mu times the normal.
void add_pyramid(const ScaledBlock& block, int edges, PyramidBuilder* builder) {
  const Index normal = builder->add_generator(block.start, VectorXd::Ones(1));
  const MatrixXd directions = edge_directions(block.rows - 1, edges);
  for (Index k = 0; k < directions.cols(); ++k)
    builder->add_generator(block.start + 1, directions.col(k));
  builder->add_limit(normal + 1, 0, normal, block.mu);
}

}  // namespace

PyramidProblem friction_pyramids(const ScaledContacts& contacts, int edges) {
  PyramidBuilder builder(contacts.rows());
  for (const ScaledBlock& block : contacts.blocks()) {
    if (block.is_cone())
      add_pyramid(block, edges, &builder);
    else
      add_interval(block, &builder);
  }
  return builder.build(contacts);
}

}  // namespace thenar::internal
