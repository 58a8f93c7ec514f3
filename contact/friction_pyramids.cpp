#include "contact/friction_pyramids.h"

#include <cmath>

#include "base/units.h"

namespace thenar::internal {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Directions of a polygon, or of a polyhedron around a ball (tangents, count).
MatrixXd edge_directions(int tangents, int edges) {
  // A polygon has the equator alone; a polyhedron has circles of latitude, one turn apart.
  const double turn = 2 * kPi / edges;
  const int circles = tangents == 2 ? 0 : edges / 4;  // of latitude above the equator
  std::vector<Eigen::Vector3d> out;
  for (int circle = -circles; circle <= circles; ++circle) {
    const double latitude = circle * turn;
    // All directions of a pole coincide.
    if (std::abs(latitude) > kPi / 2 - turn / 4) {
      out.emplace_back(0, 0, circle > 0 ? 1 : -1);
      continue;
    }
    for (int k = 0; k < edges; ++k)
      out.emplace_back(std::cos(latitude) * std::cos(k * turn),
                       std::cos(latitude) * std::sin(k * turn), std::sin(latitude));
  }
  MatrixXd directions(tangents, static_cast<Index>(out.size()));
  for (Index k = 0; k < directions.cols(); ++k)
    directions.col(k) = out[static_cast<std::size_t>(k)].head(tangents);
  return directions;
}

/// Unknowns of impulses, and multipliers of sums of them.
class PyramidBuilder {
 public:
  explicit PyramidBuilder(Index rows) : rows_(rows), origin_(VectorXd::Zero(rows)) {}

  Index add_generator(int start, const VectorXd& direction) {
    VectorXd column = VectorXd::Zero(rows_);
    column.segment(start, direction.size()) = direction;
    generators_.push_back(column);
    return static_cast<Index>(generators_.size()) - 1;
  }
  /// room + share z_from - (sum of z first .. end-1)  >= 0,  with a multiplier on these.
  void add_limit(Index first, double room, Index from, double share) {
    limits_.push_back({first, static_cast<Index>(generators_.size()), room, from, share});
  }
  void set_origin(int row, double f) { origin_(row) = f; }

  [[nodiscard]] PyramidProblem build(const ScaledContacts& contacts) const {
    const auto g = static_cast<Index>(generators_.size()), l = static_cast<Index>(limits_.size());
    // Generators as columns of impulses.
    PyramidProblem out;
    out.origin = origin_;
    out.generators.resize(rows_, g);
    for (Index k = 0; k < g; ++k) out.generators.col(k) = generators_[static_cast<std::size_t>(k)];

    // Complementary to a generator is the velocity along it, to a limit its slack.
    MatrixXd& M = out.lcp.M;
    M = MatrixXd::Zero(g + l, g + l);
    M.topLeftCorner(g, g) = out.generators.transpose() * contacts.A() * out.generators;
    out.lcp.q = VectorXd::Zero(g + l);
    out.lcp.q.head(g) = out.generators.transpose() * (contacts.A() * origin_ + contacts.b());
    for (Index k = 0; k < l; ++k) {
      const Limit& limit = limits_[static_cast<std::size_t>(k)];
      const Index count = limit.end - limit.first;
      M.block(limit.first, g + k, count, 1).setOnes();
      M.block(g + k, limit.first, 1, count).setConstant(-1);
      if (limit.from >= 0) M(g + k, limit.from) = limit.share;
      out.lcp.q(g + k) = limit.room;
    }
    return out;
  }

 private:
  struct Limit {
    Index first, end;
    double room;
    Index from;
    double share;
  };
  Index rows_;
  VectorXd origin_;
  std::vector<VectorXd> generators_;
  std::vector<Limit> limits_;
};

void add_interval(const ScaledBlock& block, PyramidBuilder* builder) {
  // Start at a finite end; one generator leads away from it, or two where there is none.
  const VectorXd up = VectorXd::Ones(1), down = -up;
  const bool has_lower = std::isfinite(block.lower), has_upper = std::isfinite(block.upper);
  builder->set_origin(block.start, has_lower ? block.lower : has_upper ? block.upper : 0);
  if (block.lower == block.upper) return;
  if (!has_lower && !has_upper) builder->add_generator(block.start, up);
  const Index only = builder->add_generator(block.start, has_lower ? up : down);
  if (has_lower && has_upper) builder->add_limit(only, block.upper - block.lower, -1, 0);
}

void add_pyramid(const ScaledBlock& block, int edges, PyramidBuilder* builder) {
  // Normal, then edges whose sum is at most mu times the normal.
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
