#include "live/digit_lines.h"

#include <algorithm>
#include <utility>

#include "base/lists.h"
#include "base/numbers.h"
#include "tendons/net/band_course.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

constexpr int kMaxTendonPoints = 10;      // largest number of points of a tendon's line
constexpr int kBandPoints = 6;            // points of a band that may bend over a bone
constexpr double kArcSpacing = 1e-3;      // spacing of points on a surface before resampling [m]
constexpr double kPointTolerance = 1e-9;  // distance below which two points are equal [m]
constexpr double kMinPullShare = 1e-9;    // share of a muscle's tension below which it is rounding

/// Counts the points of a path up to its first point on the base after the start.
int count_points(const TendonPath<double>& path) {
  int count = 0;
  for (const PathNode<double>& node : path)
    if (++count > 1 && node.link < 0) break;
  return count;
}

/// Returns these points.
std::vector<Vector3d> node_points(const TendonPath<double>& path, const TreeState<double>& state) {
  std::vector<Vector3d> points(count_points(path));
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = moved(state, path[i].link, path[i].p);
  return points;
}

/// Resamples a polyline at `count` points with equal spacing along it.
std::vector<Vector3d> resampled_evenly(const std::vector<Vector3d>& points, int count) {
  // Compute the arc length at each point.
  std::vector<double> arc{0};
  for (std::size_t i = 1; i < points.size(); ++i)
    arc.push_back(arc.back() + (points[i] - points[i - 1]).norm());
  // Interpolate at equal steps of arc length.
  std::vector<Vector3d> resampled;
  std::size_t i = 1;
  for (int k = 0; k < count; ++k) {
    const double wanted = arc.back() * k / (count - 1);
    while (i + 1 < points.size() && arc[i] < wanted) ++i;
    const double length = arc[i] - arc[i - 1];
    const double part = length > 0 ? std::clamp((wanted - arc[i - 1]) / length, 0.0, 1.0) : 0;
    resampled.push_back(points[i - 1] + part * (points[i] - points[i - 1]));
  }
  return resampled;
}

}  // namespace

DigitLines::DigitLines(const Subject& subject, const std::string& name,
                       std::shared_ptr<const DigitTendons> tendons)
    : tendons_(std::move(tendons)), net_(dynamic_cast<const NetTendons*>(tendons_.get())) {
  const TendonDigit& digit = tendons_->digit();
  // Find the wrapped path of each strand; strands without one run straight between their points.
  path_of_strand_.assign(digit.names.strands.size(), -1);
  if (digit.fidelity.path >= Path::kFitted) {
    paths_ = std::make_unique<PathSet>(build_paths(subject, digit.skeleton, digit.names.strands));
    solver_ = std::make_unique<PathSolver>(*paths_);
    for (std::size_t s = 0; s < path_of_strand_.size(); ++s)
      for (std::size_t k = 0; k < paths_->paths.size(); ++k)
        if (paths_->paths[k].name == digit.names.strands[s] && !paths_->paths[k].points.empty())
          path_of_strand_[s] = static_cast<int>(k);
  }
  // Add the lines of all strands, or of a net and the tendons outside of it.
  if (net_ != nullptr)
    add_net(name);
  else
    for (int s = 0; s < static_cast<int>(digit.names.strands.size()); ++s) add_strand(s, name);
}

void DigitLines::add_line(const std::string& name, const std::string& digit, const Source& source,
                          int points) {
  lines_.push_back({name, digit, source.band >= 0, points});
  sources_.push_back(source);
}

void DigitLines::add_strand(int strand, const std::string& digit) {
  const std::string& name = tendons_->digit().names.strands[strand];
  const Source source{strand};
  if (path_of_strand_[strand] >= 0) return add_line(name, digit, source, kMaxTendonPoints);
  const int points = count_points(model().paths[strand]);
  if (points > 1) add_line(name, digit, source, std::min(points, kMaxTendonPoints));
}

void DigitLines::add_net(const std::string& digit) {
  const std::vector<std::string>& muscles = tendons_->digit().names.muscles;
  const BuiltNet& built = net_->net();
  // Add the tendons of muscles that pull on the net with a part of their tension, or not at all.
  std::vector<double> whole(muscles.size(), 1);
  for (const NetMuscle& muscle : built.muscles) whole[muscle.muscle] -= muscle.to_net;
  for (std::size_t m = 0; m < muscles.size(); ++m)
    if (whole[m] > kMinPullShare) add_strand(model().pulls[m], digit);
  // Add the paths of muscles up to the net, then its bands.
  for (std::size_t k = 0; k < built.muscles.size(); ++k) {
    Source source;
    source.muscle = static_cast<int>(k);
    const int points = count_points(built.muscles[k].own_path);
    if (points > 1)
      add_line(muscles[built.muscles[k].muscle] + " to net", digit, source,
               std::min(points, kMaxTendonPoints));
  }
  for (std::size_t k = 0; k < built.net.bands.size(); ++k) {
    Source source;
    source.band = static_cast<int>(k);
    add_line(built.net.bands[k].name, digit, source, built.net.bands[k].over < 0 ? 2 : kBandPoints);
  }
}

std::vector<Vector3d> DigitLines::wrapped_points(const PathShape& shape,
                                                 const TreeState<double>& state) const {
  // Compute the whole path, and keep it up to the first span that ends on the base.
  const Eigen::Matrix3Xd all = path_points(*paths_, state, shape, kArcSpacing);
  const auto last = std::find_if(shape.spans.begin(), shape.spans.end(),
                                 [](const PathSpan& span) { return span.link_b == -1; });
  std::vector<Vector3d> points;
  for (const auto& p : all.colwise()) {
    points.emplace_back(p);
    if (last != shape.spans.end() && points.size() > 1 && (p - last->b).norm() < kPointTolerance)
      break;
  }
  return points;
}

std::vector<Vector3d> DigitLines::line_course(std::size_t line, const TreeState<double>& state,
                                              const NetEquilibrium& rest,
                                              const std::vector<PathShape>& shapes) const {
  // Dispatch on the source: a band, a muscle up to the net, a wrapped tendon, or a straight one.
  const Source& source = sources_[line];
  if (source.band >= 0) return band_course(net_->net().net, state, rest, source.band).points;
  if (source.muscle >= 0) return node_points(net_->net().muscles[source.muscle].own_path, state);
  const int wrapped = path_of_strand_[source.strand];
  if (wrapped >= 0) return wrapped_points(shapes[wrapped], state);
  return node_points(model().paths[source.strand], state);
}

std::vector<Vector3d> DigitLines::points(const TreeState<double>& state,
                                         const NetEquilibrium& rest) const {
  // Solve all wrapped paths of this posture; straight ones need no solver.
  static const std::vector<PathShape> none;
  const std::vector<PathShape>& shapes = solver_ ? solver_->solve(state) : none;
  std::vector<Vector3d> all;
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    std::vector<Vector3d> points = line_course(i, state, rest, shapes);
    // Resample the line to its fixed number of points.
    if (static_cast<int>(points.size()) != lines_[i].points)
      points = resampled_evenly(points, lines_[i].points);
    append_all(all, points);
  }
  return all;
}

std::vector<double> DigitLines::tensions(const Eigen::VectorXd& q, const Eigen::VectorXd& t,
                                         const NetEquilibrium& rest) const {
  // Tensions of a net without equilibrium are unknown.
  const bool unbalanced = net_ != nullptr && is_unbalanced(rest);
  // Compute the strand tensions from the parts of the muscle tensions that do not enter the net.
  Eigen::VectorXd outside = t;
  if (net_ != nullptr)
    for (const NetMuscle& muscle : net_->net().muscles)
      outside[muscle.muscle] -= muscle.to_net * t[muscle.muscle];
  const Eigen::VectorXd strands = strand_matrix(model(), q) * outside;
  // Look up the tension of each line; rounding errors in slack bands become zero.
  std::vector<double> tensions;
  for (const Source& source : sources_) {
    if (source.strand >= 0) {
      tensions.push_back(strands[source.strand]);
    } else if (source.muscle >= 0) {
      const NetMuscle& muscle = net_->net().muscles[source.muscle];
      tensions.push_back(muscle.to_net * t[muscle.muscle]);
    } else {
      const double tension = rest.tension[source.band];
      tensions.push_back(unbalanced ? kNaN : tension > kTautTension ? tension : 0);
    }
  }
  return tensions;
}

}  // namespace thenar
