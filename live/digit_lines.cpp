#include "live/digit_lines.h"

#include <algorithm>
#include <utility>

#include "base/numbers.h"
#include "tendons/net/band_course.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

constexpr int kMostPoints = 10;       // of a tendon's line
constexpr int kBentPoints = 6;        // of a band that may bend over a bone
constexpr double kArcSpacing = 1e-3;  // of points on a surface before they are thinned [m]
constexpr double kSamePoint = 1e-9;   // [m]
constexpr double kNoShare = 1e-9;     // of a muscle's tension: rounding [1]

/// The points of a path up to where it leaves the digit: the first one on the base.
std::vector<Vector3d> points_of(const TendonPath<double>& path, const TreeState<double>& state) {
  std::vector<Vector3d> points;
  for (const PathNode<double>& node : path) {
    points.push_back(moved(state, node.link, node.p));
    if (node.link < 0 && points.size() > 1) break;
  }
  return points;
}

int count_points(const TendonPath<double>& path) {
  int count = 0;
  for (const PathNode<double>& node : path)
    if (++count > 1 && node.link < 0) break;
  return count;
}

/// Resamples a course at `count` points that have even distances along it.
std::vector<Vector3d> evenly(const std::vector<Vector3d>& points, int count) {
  // Measure the distance of each point along the course, then interpolate at even steps.
  std::vector<double> way{0};
  for (std::size_t i = 1; i < points.size(); ++i)
    way.push_back(way.back() + (points[i] - points[i - 1]).norm());
  std::vector<Vector3d> even;
  std::size_t i = 1;
  for (int k = 0; k < count; ++k) {
    const double at = way.back() * k / (count - 1);
    while (i + 1 < points.size() && way[i] < at) ++i;
    const double length = way[i] - way[i - 1];
    const double part = length > 0 ? std::clamp((at - way[i - 1]) / length, 0.0, 1.0) : 0;
    even.push_back(points[i - 1] + part * (points[i] - points[i - 1]));
  }
  return even;
}

/// Tension of each strand before friction in sheaths [N] (strands).
Eigen::VectorXd strand_tensions(const TendonModel<double>& model, const Eigen::VectorXd& q,
                                const Eigen::VectorXd& t) {
  return strand_matrix(model, q) * t;
}

}  // namespace

DigitLines::DigitLines(const Subject& subject, const std::string& name,
                       std::shared_ptr<const DigitTendons> tendons)
    : tendons_(std::move(tendons)), net_(dynamic_cast<const NetTendons*>(tendons_.get())) {
  const TendonDigit& digit = tendons_->digit();
  // Strands without a path over surfaces run straight between their points.
  path_of_strand_.assign(digit.names.strands.size(), -1);
  // Paths over surfaces, where tendons are on that rung.
  if (digit.fidelity.path >= Path::kFitted) {
    paths_ = std::make_unique<PathSet>(build_paths(subject, digit.skeleton, digit.names.strands));
    solver_ = std::make_unique<PathSolver>(*paths_);
    for (std::size_t s = 0; s < path_of_strand_.size(); ++s)
      for (std::size_t k = 0; k < paths_->paths.size(); ++k)
        if (paths_->paths[k].name == digit.names.strands[s] && !paths_->paths[k].points.empty())
          path_of_strand_[s] = static_cast<int>(k);
  }
  // Strands, or a net with what runs outside of it.
  if (net_ != nullptr)
    add_net(name);
  else
    for (int s = 0; s < static_cast<int>(digit.names.strands.size()); ++s) add_strand(s, name);
}

void DigitLines::add(const std::string& name, const std::string& digit, const Source& source,
                     int points) {
  lines_.push_back({name, digit, source.band >= 0, points});
  sources_.push_back(source);
}

void DigitLines::add_strand(int strand, const std::string& digit) {
  const auto s = static_cast<std::size_t>(strand);
  const std::string& name = tendons_->digit().names.strands[s];
  Source source;
  source.strand = strand;
  if (path_of_strand_[s] >= 0) return add(name, digit, source, kMostPoints);
  const int points = count_points(model().paths[s]);
  if (points > 1) add(name, digit, source, std::min(points, kMostPoints));
}

void DigitLines::add_net(const std::string& digit) {
  const std::vector<std::string>& muscles = tendons_->digit().names.muscles;
  const BuiltNet& built = net_->net();
  // Whole tendons: of muscles that do not enter the net, or only with a part.
  std::vector<double> whole(muscles.size(), 1);
  for (const NetMuscle& muscle : built.muscles) whole[muscle.muscle] -= muscle.to_net;
  for (std::size_t m = 0; m < muscles.size(); ++m)
    if (whole[m] > kNoShare) add_strand(model().pulls[m], digit);
  // Muscles up to the net, then its bands.
  for (std::size_t k = 0; k < built.muscles.size(); ++k) {
    Source source;
    source.muscle = static_cast<int>(k);
    const int points = count_points(built.muscles[k].own_path);
    if (points > 1)
      add(muscles[built.muscles[k].muscle] + " to net", digit, source,
          std::min(points, kMostPoints));
  }
  for (std::size_t k = 0; k < built.net.bands.size(); ++k) {
    Source source;
    source.band = static_cast<int>(k);
    add(built.net.bands[k].name, digit, source, built.net.bands[k].over < 0 ? 2 : kBentPoints);
  }
}

std::vector<Vector3d> DigitLines::wrapped(const PathShape& shape,
                                          const TreeState<double>& state) const {
  const Eigen::Matrix3Xd all = path_points(*paths_, state, shape, kArcSpacing);
  // Up to the end of the first run that ends on the base.
  const auto last = std::find_if(shape.spans.begin(), shape.spans.end(),
                                 [](const PathSpan& span) { return span.link_b == -1; });
  std::vector<Vector3d> points;
  for (const auto& p : all.colwise()) {
    points.emplace_back(p);
    if (last != shape.spans.end() && points.size() > 1 && (p - last->b).norm() < kSamePoint) break;
  }
  return points;
}

std::vector<Vector3d> DigitLines::course(std::size_t line, const TreeState<double>& state,
                                         const NetEquilibrium& rest,
                                         const std::vector<PathShape>& shapes) const {
  // A band of the net, a muscle up to the net, a wrapped tendon, or straight runs.
  const Source& source = sources_[line];
  if (source.band >= 0) return band_course(net_->net().net, state, rest, source.band).points;
  if (source.muscle >= 0) return points_of(net_->net().muscles[source.muscle].own_path, state);
  const auto strand = static_cast<std::size_t>(source.strand);
  if (path_of_strand_[strand] >= 0) return wrapped(shapes[path_of_strand_[strand]], state);
  return points_of(model().paths[strand], state);
}

std::vector<Vector3d> DigitLines::points(const TreeState<double>& state,
                                         const NetEquilibrium& rest) const {
  // Solve all wrapped paths of this posture together; straight runs need no solver.
  static const std::vector<PathShape> none;
  const std::vector<PathShape>& shapes = solver_ ? solver_->solve(state) : none;
  std::vector<Vector3d> all;
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    std::vector<Vector3d> points = course(i, state, rest, shapes);
    // A line keeps its number of points, which the viewer allocated once.
    if (static_cast<int>(points.size()) != lines_[i].points)
      points = evenly(points, lines_[i].points);
    all.insert(all.end(), points.begin(), points.end());
  }
  return all;
}

std::vector<double> DigitLines::tensions(const Eigen::VectorXd& q, const Eigen::VectorXd& t,
                                         const NetEquilibrium& rest) const {
  // Tensions of a net that is not at rest mean nothing, and are shown as unknown.
  const bool unbalanced = net_ != nullptr && (rest.status == NetStatus::kStalled ||
                                              rest.status == NetStatus::kFarSideWrap);
  // Of a muscle that enters a net in part, its whole tendon has the other part.
  Eigen::VectorXd outside = t;
  if (net_ != nullptr)
    for (const NetMuscle& muscle : net_->net().muscles)
      outside[muscle.muscle] -= muscle.to_net * t[muscle.muscle];
  const Eigen::VectorXd strands = strand_tensions(model(), q, outside);
  std::vector<double> tensions;
  // A slack band carries rounding errors, which are shown as zero.
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
