#include "tendons/wrapping/arm_slopes.h"

#include <utility>

#include <Eigen/Geometry>

#include "base/lists.h"

namespace thenar {
namespace {

using Eigen::Vector3d;
using internal::BodyTwist;
using internal::ChainTangent;
using internal::TouchRate;
using internal::TreeVelocity;
using Column = Eigen::Ref<Eigen::VectorXd>;

/// Direction or point with its rate.
struct RatedVector {
  Vector3d at, dot;
};

/// Straight run with the velocities of its ends.
struct SpanRate {
  const PathSpan* span;
  Vector3d a_dot, b_dot;
  RatedVector u;      // unit direction from a to b
  double length_dot;  // [m/s]
};

/// Computes the rates of a run from the velocities of its ends.
SpanRate span_rate(const PathSpan& span, const Vector3d& a_dot, const Vector3d& b_dot) {
  const Vector3d u = span.u, move = b_dot - a_dot;
  const double stretch = u.dot(move);
  Vector3d turn = Vector3d::Zero();
  if (span.length > 0) turn = (move - stretch * u) / span.length;
  return {&span, a_dot, b_dot, {u, turn}, stretch};
}

/// Motion of the tree by one coordinate, which gives one column of derivatives.
struct JointRotation {
  const Tree<double>& tree;
  const TreeState<double>& state;
  TreeVelocity rate;
};

/// Adds the rate of  sum over hinges between the links of -u . (db/dq - da/dq),  times `scale`.
void add_span(const JointRotation& turn, const SpanRate& run, double scale, double scale_dot,
              Column column) {
  if (run.span->link_a == run.span->link_b) return;
  // Compute scaled direction and moment of the run's line, with their rates.
  const Vector3d u = scale * run.u.at, u_dot = scale * run.u.dot + scale_dot * run.u.at;
  const Vector3d m = run.span->a.cross(u), m_dot = run.a_dot.cross(u) + run.span->a.cross(u_dot);
  // Add the hinges on the two branches up to the common ancestor.
  for_each_hinge_between(turn.tree, run.span->link_a, run.span->link_b, [&](int i, bool on_b) {
    const auto& at = turn.state[i];
    const double pull = turn.rate.axis[i].dot(m - at.point.cross(u)) +
                        at.axis.dot(m_dot - turn.rate.point[i].cross(u) - at.point.cross(u_dot));
    column[turn.tree[i].coordinate] += turn.tree[i].ratio * (on_b ? -pull : pull);
  });
}

/// Adds the rate of  w . dp/dq  of a point of a link.
void add_motion(const JointRotation& turn, int link, const RatedVector& p, const RatedVector& w,
                Column column) {
  for_each_hinge_to_base(turn.tree, link, [&](int i) {
    const auto& at = turn.state[i];
    const Vector3d lever = p.at - at.point;
    column[turn.tree[i].coordinate] +=
        turn.tree[i].ratio *
        (w.dot.dot(at.axis.cross(lever)) + w.at.dot(turn.rate.axis[i].cross(lever)) +
         w.at.dot(at.axis.cross(p.dot - turn.rate.point[i])));
  });
}

/// Surfaces of one run of a path, linearised, with the links that carry them.
struct RunChain {
  std::size_t first_arc;
  std::vector<int> links;  // links of the surfaces
  ChainTangent tangent;
};

/// Linearises the runs of a path that bend over surfaces.
std::vector<RunChain> run_chains(const TreeState<double>& state, const PathSet& set,
                                 const PathShape& shape) {
  std::vector<RunChain> chains;
  for (std::size_t i = 0; i < shape.arcs.size();) {
    // Collect consecutive arcs without a fixed point between them.
    std::vector<ChainArc> arcs;
    std::vector<int> links;
    const std::size_t first = i;
    do {
      const PathArc& arc = shape.arcs[i];
      const BoneSurface& surface = set.surfaces[arc.surface];
      const Pose<double> X = surface_pose(surface, state);
      arcs.push_back({&surface, X, arc.arc});
      links.push_back(surface.link);
      ++i;
    } while (i < shape.arcs.size() && shape.arcs[i].after == shape.arcs[i - 1].after + 1);
    // Linearise the chain between the points before its first arc and after its last one.
    const auto before = static_cast<std::size_t>(shape.arcs[first].after);
    const auto after = static_cast<std::size_t>(shape.arcs[i - 1].after) + 1;
    chains.push_back(
        {first, std::move(links), ChainTangent(shape.spans[before].a, shape.spans[after].b, arcs)});
  }
  return chains;
}

/// Position of a riding origin on the carrier's run, with its rates.
struct RideRate {
  const std::vector<SpanRate>* carrier;
  std::size_t span;         // span of the carrier
  double share, share_dot;  // fraction of the span's length and its rate
  Vector3d x_dot;           // velocity of the origin
};

/// Computes the rates of a riding origin. The origin x = A + d v stays at a fixed length from the
/// carrier's insertion: d is the remainder of that length after A, whose excursion is a column of
/// the carrier's arms.
RideRate ride_rate(const PathShape& rider, const std::vector<SpanRate>& carrier,
                   double shortened_dot) {
  const auto k = static_cast<std::size_t>(rider.ride_span);
  const SpanRate& run = carrier[k];
  // Compute the distance of the origin along its carrier's span, and its rate.
  const double l = run.span->length;
  const double d = (rider.spans.back().b - run.span->a).dot(run.u.at);
  return {&carrier, k, d / l, shortened_dot / l - d * run.length_dot / (l * l),
          run.a_dot + shortened_dot * run.u.at + d * run.u.dot};
}

/// Adds the rates of the terms of a riding origin; see path_arms.cpp.
void add_riding(const JointRotation& turn, const SpanRate& last, const RideRate& ride,
                const Column& column) {
  const SpanRate& run = (*ride.carrier)[ride.span];
  // Split the pull into the part along the carrier and the rest across it.
  const RatedVector &u = last.u, &v = run.u;
  const double along = u.at.dot(v.at), along_dot = u.dot.dot(v.at) + u.at.dot(v.dot);
  const RatedVector across{u.at - along * v.at, u.dot - along_dot * v.at - along * v.dot};
  const double s = ride.share, s_dot = ride.share_dot;
  // Compute the weights of the span's two ends, with their rates.
  const RatedVector on_a{
      -along * v.at - (1 - s) * across.at,
      -along_dot * v.at - along * v.dot + s_dot * across.at - (1 - s) * across.dot};
  const RatedVector on_b{-s * across.at, -s_dot * across.at - s * across.dot};
  add_motion(turn, run.span->link_a, {run.span->a, run.a_dot}, on_a, column);
  add_motion(turn, run.span->link_b, {run.span->b, run.b_dot}, on_b, column);
  // Add the part along the carrier, which follows that tendon's excursion.
  for (std::size_t k = 0; k < ride.span; ++k)
    add_span(turn, (*ride.carrier)[k], -along, -along_dot, column);
}

/// Workspace of span_rates().
struct SpanWorkspace {
  std::vector<Vector3d> a_dot, b_dot;  // (spans)
  std::vector<BodyTwist> on;           // twists of the surfaces (arcs of a chain)
  std::vector<TouchRate> touch;        // touch points (arcs of a chain)
};

/// Computes the rates of all runs while one coordinate moves, written over `out`. Runs between
/// points of one link do not affect the arms; their rates are computed only for a carrier.
void span_rates(const TreeVelocity& rate, const PathShape& shape,
                const std::vector<RunChain>& chains, const Vector3d* origin_dot, bool carries,
                SpanWorkspace& workspace, std::vector<SpanRate>& out) {
  auto& [a_dot, b_dot, on, touch] = workspace;
  a_dot.clear();
  b_dot.clear();
  // Compute the velocities of ends that are fixed to links.
  for (const PathSpan& span : shape.spans) {
    a_dot.push_back(rate.body(span.link_a).velocity_at(span.a));
    b_dot.push_back(span.link_b == kRiding ? *origin_dot
                                           : rate.body(span.link_b).velocity_at(span.b));
  }
  // Compute those of touch points from the linearised tangency conditions.
  for (const RunChain& chain : chains) {
    const auto before = static_cast<std::size_t>(shape.arcs[chain.first_arc].after);
    on.clear();
    for (int link : chain.links) on.push_back(rate.body(link));
    chain.tangent.rates(a_dot[before], b_dot[before + on.size()], on, touch);
    for (std::size_t i = 0; i < on.size(); ++i) {
      b_dot[before + i] = touch[i].on;
      a_dot[before + i + 1] = touch[i].off;
    }
  }
  // Compute the rates of the spans between those ends.
  out.clear();
  for (std::size_t s = 0; s < shape.spans.size(); ++s) {
    const PathSpan& span = shape.spans[s];
    if (carries || span.link_a != span.link_b)
      out.push_back(span_rate(span, a_dot[s], b_dot[s]));
    else
      out.push_back({&span, a_dot[s], b_dot[s], {Vector3d::Zero(), Vector3d::Zero()}, 0});
  }
}

/// Returns whether all touch points are determined, and all runs between links are long enough to
/// define their rotation.
bool has_slopes(const PathShape& shape, const std::vector<RunChain>& chains) {
  if (shape.status != PathStatus::kTaut) return false;
  return all_of(chains, [](const RunChain& chain) { return chain.tangent.regular(); }) &&
         all_of(shape.spans, [](const PathSpan& span) {
           return span.length > kShortRun || span.link_a == span.link_b;
         });
}

/// Returns whether a coordinate turns a hinge between the ends of a run, without which it does not
/// affect the path.
bool has_hinge(const Tree<double>& tree, const PathShape& shape, int coordinate) {
  return any_of(shape.spans, [&](const PathSpan& span) {
    bool found = span.link_b == kRiding;
    if (!found)
      for_each_hinge_between(tree, span.link_a, span.link_b, [&](int i, bool /*on_b*/) {
        found = found || tree[i].coordinate == coordinate;
      });
    return found;
  });
}

/// Computes the shortening rate of the carrier before the run on which the origin lies, -d(length
/// up to it). Touch points count as fixed: where a path is tangent, sliding them does not change
/// the length.
double carrier_shortening_rate(const TreeVelocity& rate, const std::vector<SpanRate>& carrier,
                               std::size_t before) {
  double sum = 0;
  for (std::size_t k = 0; k < before; ++k) {
    const PathSpan& span = *carrier[k].span;
    sum -= carrier[k].u.at.dot(rate.body(span.link_b).velocity_at(span.b) -
                               rate.body(span.link_a).velocity_at(span.a));
  }
  return sum;
}

}  // namespace

std::vector<ArmDerivatives> arm_derivatives(const Tree<double>& tree,
                                            const TreeState<double>& state, const PathSet& set,
                                            const std::vector<PathShape>& shapes, int coordinates) {
  // Linearise the chains of all paths, and test whether derivatives exist.
  std::vector<ArmDerivatives> slopes(shapes.size());
  std::vector<std::vector<RunChain>> chains;
  std::vector<bool> carries(shapes.size(), false);
  for (const WrappedPath& path : set.paths)
    if (path.carrier >= 0) carries[path.carrier] = true;
  for (std::size_t k = 0; k < shapes.size(); ++k) {
    chains.push_back(run_chains(state, set, shapes[k]));
    const int carrier = set.paths[k].carrier;
    slopes[k].exist = has_slopes(shapes[k], chains[k]) && (carrier < 0 || slopes[carrier].exist);
    slopes[k].dR = Eigen::MatrixXd::Zero(coordinates, coordinates);
  }
  // Compute one column per coordinate: rates while it moves at unit speed.
  std::vector<std::vector<SpanRate>> runs(shapes.size());
  SpanWorkspace workspace;
  for (int l = 0; l < coordinates; ++l) {
    const JointRotation turn{tree, state, internal::joint_velocity_tree(tree, state, l)};
    for (std::size_t k = 0; k < shapes.size(); ++k) {
      const PathShape& shape = shapes[k];
      if (!slopes[k].exist || (!carries[k] && !has_hinge(tree, shape, l))) continue;
      // Move a riding origin with its carrier, which precedes it in the set.
      RideRate ride{};
      if (set.paths[k].carrier >= 0) {
        const auto& carrier = runs[set.paths[k].carrier];
        ride = ride_rate(
            shape, carrier,
            carrier_shortening_rate(turn.rate, carrier, static_cast<std::size_t>(shape.ride_span)));
      }
      span_rates(turn.rate, shape, chains[k], &ride.x_dot, carries[k], workspace, runs[k]);
      // Add the rate of each span's part of the arms.
      for (const SpanRate& run : runs[k]) {
        if (run.span->link_b != kRiding) {
          add_span(turn, run, 1, 0, slopes[k].dR.col(l));
          continue;
        }
        add_motion(turn, run.span->link_a, {run.span->a, run.a_dot}, run.u, slopes[k].dR.col(l));
        add_riding(turn, run, ride, slopes[k].dR.col(l));
      }
    }
  }
  return slopes;
}

}  // namespace thenar
