#include "grasp/robot/digit_motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/numbers.h"

namespace thenar {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kAlongCosine = 0.7;  // Least cosine of a curling joint to the last one's axis [1]
constexpr double kSameWay = 0.7;  // smallest cosine between tip directions of similar fingers [1]
constexpr double kSameDistance = 1e-9;   // relative change of tip distances that counts as none [1]
constexpr double kNoMotion = 1e-9;       // rotation or motion that counts as none [1], [m]
constexpr std::size_t kPalmFingers = 3;  // fingers that make a palm, approached along its normal
constexpr double kOppositionRange = 0.6;  // range from which a turning motor may oppose [rad]
constexpr double kFartherRatio = 1.4;     // smallest ratio to the ranges of the others [1]
constexpr double kMostBackBend = 0.6;     // farthest that fingers bend backwards to open [rad]
constexpr double kAsFar = 0.85;  // share of a tip's motion from which another moves as far [1]
constexpr double kNearNormal = 0.9925;  // least cosine to a flat face of the palm's normal [1]

/// Number of positions at which each of so many turning motors is tried.
int places(std::size_t motors) { return motors <= 1 ? 9 : motors == 2 ? 5 : 3; }

}  // namespace

DigitMotion::DigitMotion(const BallGrasp& grip, bool closing)
    : grip_(grip), drives_(grip.hand().layout().drives) {
  const HandLayout& layout = grip.hand().layout();
  rest_ = layout.lower.cwiseMax(0).cwiseMin(layout.upper);
  find_digits();
  sort_drives();
  // What curls and where tips go is told by straight digits.
  straighten();
  find_digits();
  sort_drives();
  orient();
  join_rows();
  // Stated speeds tell how the hand closes; otherwise both senses are tried.
  if (closing) {
    SenseOption stated;
    for (const Drive& drive : drives_) stated.speed.push_back(drive.speed);
    options_ = {stated};
  } else {
    options_ = closing_options(layout, rest_, groups_, [this](const std::vector<double>& senses) {
      return apart(moved(senses, 0.5));
    });
  }
}

void DigitMotion::find_digits() {
  digits_.clear();
  names_.clear();
  const std::vector<Pose<double>> links = grip_.hand().pose(rest_);
  const std::vector<SampledSurface>& surfaces = grip_.surfaces();
  std::vector<int> depth;
  depth.reserve(surfaces.size());
  // Innermost and outermost surface of each digit, by depth in the tree.
  for (const SampledSurface& surface : surfaces)
    depth.push_back(joints_to(grip_.hand().layout(), surface.link));
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    if (surfaces[s].digit.empty()) continue;
    auto digit = std::find_if(digits_.begin(), digits_.end(),
                              [&](const Digit& d) { return d.name == surfaces[s].digit; });
    if (digit == digits_.end()) {
      digits_.push_back({surfaces[s].digit, s, s, {}, {}, {}, {}});
      names_.push_back(surfaces[s].digit);
      continue;
    }
    if (depth[s] < depth[digit->first]) digit->first = s;
    if (depth[s] >= depth[digit->last]) digit->last = s;
  }
  const auto centre = [&](std::size_t s) -> Vector3d {
    const SampledSurface& surface = surfaces[s];
    return surface.link < 0 ? surface.centre
                            : links[static_cast<std::size_t>(surface.link)] * surface.centre;
  };
  for (Digit& digit : digits_) {
    // The root is the hinge of the digit's first link; for a slide, the link itself.
    digit.tip = centre(digit.last);
    digit.root = centre(digit.first);
    const int link = surfaces[digit.first].link;
    if (link >= 0 && !grip_.hand().is_prismatic(link))
      digit.root = links[static_cast<std::size_t>(link)] * grip_.hand().axis_point(link);
  }
}

Eigen::Matrix<double, 6, 1> DigitMotion::twist(std::size_t drive, const Digit& digit) const {
  const SampledSurface& tip = grip_.surfaces()[digit.last];
  Eigen::Matrix<double, 6, 1> sum = Eigen::Matrix<double, 6, 1>::Zero();
  if (tip.link < 0) return sum;
  const auto J = grip_.hand().jacobian(rest_, tip.link, tip.centre);
  for (const DrivenCoordinate& moved : drives_[drive].moves)
    sum += moved.ratio * J.col(moved.coordinate);
  return sum;
}

Vector3d DigitMotion::spin(std::size_t drive, const Digit& digit) const {
  return twist(drive, digit).head<3>();
}

Vector3d DigitMotion::way(std::size_t drive, const Digit& digit) const {
  return twist(drive, digit).tail<3>();
}

/// Returns whether a drive moves every tip, and none relative to another: a wrist.
bool DigitMotion::moves_alike(std::size_t drive) const {
  for (const Digit& digit : digits_)
    if (way(drive, digit).norm() < kNoMotion && spin(drive, digit).norm() < kNoMotion) return false;
  if (digits_.size() < 2) return false;
  // Distances between tips are the same with the drive moved either way.
  std::vector<double> senses(drives_.size(), 0);
  senses[drive] = 1;
  const double up = apart(moved(senses, 0.1));
  senses[drive] = -1;
  const double down = apart(moved(senses, 0.1));
  return std::abs(up - down) <= kSameDistance * std::max(up, down);
}

/// Axis of the last joint of a digit that turns; zero: none does. (3)
Vector3d DigitMotion::last_axis(const Digit& digit) const {
  Vector3d last = Vector3d::Zero();
  for (int link = grip_.surfaces()[digit.last].link; link >= 0 && last.isZero(0);
       link = grip_.hand().layout().parents[static_cast<std::size_t>(link)])
    last = grip_.hand().axis(rest_, link);
  return last;
}

void DigitMotion::sort_drives() {
  for (std::size_t d = 0; d < drives_.size(); ++d) {
    if (moves_alike(d)) continue;
    // A drive of several digits has the kind that it has for the digit whose tip it moves most.
    double farthest = -1;
    bool curls = true;
    std::vector<Digit*> moved;
    for (Digit& digit : digits_) {
      const Vector3d w = spin(d, digit), v = way(d, digit);
      if (w.norm() < kNoMotion && v.norm() < kNoMotion) continue;
      moved.push_back(&digit);
      if (v.norm() <= farthest) continue;
      farthest = v.norm();
      // Parallel to the last axis: it curls; across: it turns.
      const Vector3d last = last_axis(digit);
      curls = w.norm() < kNoMotion || last.isZero(0) ||
              std::abs(w.dot(last)) >= kAlongCosine * w.norm() * last.norm();
    }
    for (Digit* digit : moved) (curls ? digit->curls : digit->turns).push_back(static_cast<int>(d));
  }
}

/// Sign of a drive relative to the outermost of a digit, by rotation or by motion of the tip.
double DigitMotion::sign_against(std::size_t outer, std::size_t drive, const Digit& digit) const {
  const Vector3d w = spin(drive, digit), w_outer = spin(outer, digit);
  const bool turn = w.norm() > kNoMotion && w_outer.norm() > kNoMotion;
  const double along = turn ? w.dot(w_outer) : way(drive, digit).dot(way(outer, digit));
  return along < 0 ? -1.0 : 1.0;
}

/// Finds the signs of drives that curl each digit, and which drives belong together.
void DigitMotion::orient() {
  groups_.orientation.assign(drives_.size(), 0);
  groups_.group.assign(drives_.size(), -1);
  for (std::size_t d = 0; d < drives_.size(); ++d)
    groups_.slides.push_back(std::all_of(digits_.begin(), digits_.end(), [&](const Digit& digit) {
      return spin(d, digit).norm() < kNoMotion;
    }));
  int groups = 0;
  for (const Digit& digit : digits_) {
    if (digit.curls.empty()) continue;
    const auto outer = static_cast<std::size_t>(digit.curls.back());
    const auto sign = [&](std::size_t d) { return sign_against(outer, d, digit); };
    // A drive that already has a sign sets that of the whole digit.
    double flip = 1;
    int group = -1;
    for (const int c : digit.curls)
      if (const auto d = static_cast<std::size_t>(c); group < 0 && groups_.group[d] >= 0) {
        group = groups_.group[d];
        flip = groups_.orientation[d] * sign(d);
      }
    if (group < 0) group = groups++;
    // The others get their signs relative to it.
    for (const int c : digit.curls) {
      const auto d = static_cast<std::size_t>(c);
      if (groups_.group[d] >= 0) continue;
      groups_.group[d] = group;
      groups_.orientation[d] = flip * sign(d);
    }
  }
}

double DigitMotion::range(std::size_t drive) const {
  const HandLayout& layout = grip_.hand().layout();
  const DrivenCoordinate& first = drives_[drive].moves.front();
  return (layout.upper[first.coordinate] - layout.lower[first.coordinate]) / std::abs(first.ratio);
}

/// Posture at a share of the range from rest in the given senses; senses of 0 stay. (coordinates)
VectorXd DigitMotion::moved(const std::vector<double>& senses, double share) const {
  const HandLayout& layout = grip_.hand().layout();
  VectorXd q = rest_;
  for (std::size_t d = 0; d < drives_.size(); ++d)
    for (const DrivenCoordinate& driven : drives_[d].moves) {
      const double sense = senses[d] * driven.ratio;
      if (sense == 0) continue;
      const double lower = layout.lower[driven.coordinate], upper = layout.upper[driven.coordinate];
      q[driven.coordinate] += (sense > 0 ? 1 : -1) * share * (upper - lower);
    }
  return q.cwiseMax(layout.lower).cwiseMin(layout.upper);
}

/// Points of surfaces with the links posed. (3, points) [m]
Eigen::Matrix3Xd DigitMotion::points_of(const std::vector<std::size_t>& surfaces,
                                        const std::vector<Pose<double>>& links) const {
  std::vector<Eigen::Matrix3Xd> parts;
  for (const std::size_t surface : surfaces) {
    const SampledSurface& points = grip_.surfaces()[surface];
    const Pose<double> X =
        points.link < 0 ? Pose<double>{} : links[static_cast<std::size_t>(points.link)];
    parts.emplace_back((X.R * points.p).colwise() + X.p);
  }
  return side_by_side(parts);
}

/// Mean distance of points of the only digit's end to the palm's [m].
double DigitMotion::from_palm(const std::vector<Pose<double>>& links) const {
  const Eigen::Matrix3Xd palm = points_of(palm_surfaces(), links),
                         end = points_of({digits_.front().last}, links);
  if (palm.cols() == 0) return 0;
  double sum = 0;
  for (const auto& p : end.colwise())
    sum += std::sqrt((palm.colwise() - p).colwise().squaredNorm().minCoeff());
  return sum / static_cast<double>(end.cols());
}

/// Sum of distances between tips; of an only digit from the palm, which may be a fixed jaw [m].
double DigitMotion::apart(const VectorXd& q) const {
  const std::vector<Pose<double>> links = grip_.hand().pose(q);
  if (digits_.size() == 1) return from_palm(links);
  std::vector<Vector3d> tips;
  for (const Digit& digit : digits_) {
    const SampledSurface& tip = grip_.surfaces()[digit.last];
    tips.push_back(tip.link < 0 ? tip.centre
                                : links[static_cast<std::size_t>(tip.link)] * tip.centre);
  }
  double sum = 0;
  for (std::size_t a = 0; a < tips.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) sum += (tips[a] - tips[b]).norm();
  return sum;
}

double DigitMotion::mean_digit_length() const {
  double sum = 0;
  for (const Digit& digit : digits_) sum += (digit.tip - digit.root).norm();
  if (sum > kNoMotion * static_cast<double>(digits_.size()))
    return sum / static_cast<double>(digits_.size());
  // Jaws of one link: the distance by which they part.
  std::vector<double> up(drives_.size(), 1), down(drives_.size(), -1);
  return std::max(apart(moved(up, 1)), apart(moved(down, 1)));
}

std::vector<Drive> DigitMotion::drives(std::size_t option) const {
  std::vector<Drive> drives = drives_;
  for (std::size_t d = 0; d < drives.size(); ++d) drives[d].speed = options_[option].speed[d];
  return drives;
}

/// Direction in which a tip moves as its digit begins to curl; zero: it does not. (3)
Vector3d DigitMotion::curl_way(const Digit& digit, std::size_t option) const {
  Vector3d sum = Vector3d::Zero();
  for (const int d : digit.curls) {
    const double speed = options_[option].speed[static_cast<std::size_t>(d)];
    sum += (speed > 0 ? 1 : speed < 0 ? -1 : 0) * way(static_cast<std::size_t>(d), digit);
  }
  return sum.norm() > kNoMotion ? Vector3d(sum.normalized()) : Vector3d::Zero();
}

/// The largest range of a motor that turns this digit alone [rad].
double DigitMotion::turn_range(const Digit& digit) const {
  double largest = 0;
  for (const int d : digit.turns)
    if (!spreads(static_cast<std::size_t>(d), digit))
      largest = std::max(largest, range(static_cast<std::size_t>(d)));
  return largest;
}

/// Returns whether a drive rotates any digit, rather than only sliding it.
bool DigitMotion::turns(std::size_t drive) const {
  return std::any_of(digits_.begin(), digits_.end(),
                     [&](const Digit& digit) { return spin(drive, digit).norm() > kNoMotion; });
}

/// Returns whether a drive turns other digits about as far as this one.
bool DigitMotion::spreads(std::size_t drive, const Digit& digit) const {
  const double own = way(drive, digit).norm();
  return std::any_of(digits_.begin(), digits_.end(), [&](const Digit& other) {
    return &other != &digit && way(drive, other).norm() > kAsFar * own;
  });
}

/// The largest group of digits whose tips move the same way, without digits that turn far.
/// @param ways   curl_way() of each digit      @param turns  turn_range() of each digit [rad]
std::vector<std::size_t> DigitMotion::find_fingers(const std::vector<Vector3d>& ways,
                                                   const std::vector<double>& turns) const {
  // A digit that turns much farther than the median is opposed, wherever it stands now.
  const std::size_t count = digits_.size();
  std::vector<double> sorted = turns;
  std::sort(sorted.begin(), sorted.end());
  std::vector<bool> turned(count, false);
  for (std::size_t i = 0; i < count; ++i)
    turned[i] = count > 2 && turns[i] > kOppositionRange &&
                turns[i] > kFartherRatio * sorted[(count - 1) / 2];
  // Groups around each digit.
  std::vector<std::size_t> fingers;
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<std::size_t> alike;
    for (std::size_t j = 0; j < count; ++j)
      if (!turned[i] && !turned[j] && ways[i].dot(ways[j]) > kSameWay) alike.push_back(j);
    if (alike.size() > fingers.size()) fingers = alike;
  }
  return fingers;
}

DigitRoles DigitMotion::roles(std::size_t option) const {
  DigitRoles roles;
  const std::size_t count = digits_.size();
  roles.opposed.assign(count, false);
  // Fingers move the same way, and do not turn far.
  std::vector<double> turns;
  for (const Digit& digit : digits_) turns.push_back(turn_range(digit));
  std::vector<Vector3d> ways;
  for (const Digit& digit : digits_) ways.push_back(curl_way(digit, option));
  std::vector<std::size_t> fingers = find_fingers(ways, turns);
  if (fingers.size() < 2) {
    // A thumb and one finger: the digit that turns farther is opposed.
    for (std::size_t i = 0; i < count && count == 2; ++i)
      roles.opposed[i] = turns[i] > kOppositionRange && turns[i] > kFartherRatio * turns[1 - i];
    if (count != 2 || roles.opposed[0] == roles.opposed[1]) return roles;
    fingers = {roles.opposed[0] ? 1U : 0U};
  } else {
    roles.opposed.assign(count, true);
    for (const std::size_t i : fingers) roles.opposed[i] = false;
  }
  // Normal, direction and mean root of the fingers.
  Vector3d normal = Vector3d::Zero(), along = Vector3d::Zero();
  for (const std::size_t i : fingers) {
    normal += ways[i];
    along += digits_[i].tip - digits_[i].root;
    roles.root += digits_[i].root / static_cast<double>(fingers.size());
    roles.length += (digits_[i].tip - digits_[i].root).norm() / static_cast<double>(fingers.size());
  }
  const std::vector<Pose<double>> links = grip_.hand().pose(rest_);
  roles.normal = normal.normalized();
  roles.normal = without_rounding(
      facing_direction(faces_of(palm_surfaces(), links), roles.normal, kNearNormal, {})
          .value_or(roles.normal));
  along -= along.dot(roles.normal) * roles.normal;
  // A palm needs fingers and an opposed digit.
  roles.palm = fingers.size() < count && along.norm() > kNoMotion;
  if (roles.palm) roles.along = along.normalized();
  roles.row = fingers.size() >= kPalmFingers;
  return roles;
}

/// The posture in which drives that close start at the limit from which they come. (coordinates)
/// @param others    posture of the other drives (coordinates)
/// @param farthest  that drives which turn open from rest, where their range goes farther [rad]
VectorXd DigitMotion::open_at(std::size_t option, const VectorXd& others, double farthest) const {
  const HandLayout& layout = grip_.hand().layout();
  VectorXd open = others;
  for (std::size_t d = 0; d < drives_.size(); ++d) {
    const double back = turns(d) ? farthest : kInfinity;
    for (const DrivenCoordinate& driven : drives_[d].moves) {
      const double rate = options_[option].speed[d] * driven.ratio;
      if (rate == 0) continue;
      const Eigen::Index c = driven.coordinate;
      const double lower = layout.lower[c], upper = layout.upper[c];
      open[c] = rate > 0 ? lower : upper;
      if (std::min(std::abs(lower - rest_[c]), std::abs(upper - rest_[c])) > back)
        open[c] = rest_[c] - std::copysign(back, rate);
    }
  }
  return open;
}

/// Returns whether every digit has one drive that curls it, as jaws have.
bool DigitMotion::are_jaws() const {
  return std::all_of(digits_.begin(), digits_.end(),
                     [](const Digit& digit) { return digit.curls.size() <= 1; });
}

/// Returns up to three motors with the largest ranges that turn opposed digits.
std::vector<std::size_t> DigitMotion::opposing_motors(const DigitRoles& roles) const {
  std::vector<std::size_t> motors;
  for (std::size_t i = 0; i < digits_.size(); ++i)
    for (const int d : digits_[i].turns)
      if (roles.opposed[i] && !spreads(static_cast<std::size_t>(d), digits_[i]) &&
          std::find(motors.begin(), motors.end(), static_cast<std::size_t>(d)) == motors.end())
        motors.push_back(static_cast<std::size_t>(d));
  std::stable_sort(motors.begin(), motors.end(),
                   [&](std::size_t a, std::size_t b) { return range(a) > range(b); });
  if (motors.size() > 3) motors.resize(3);
  return motors;
}

/// The posture with a motor at so many positions, from one end of its range to the other.
std::vector<VectorXd> DigitMotion::motor_positions(const VectorXd& before, std::size_t motor,
                                                   int positions) const {
  const HandLayout& layout = grip_.hand().layout();
  std::vector<VectorXd> postures(static_cast<std::size_t>(positions), before);
  for (int i = 0; i < positions; ++i)
    for (const DrivenCoordinate& driven : drives_[motor].moves) {
      const Eigen::Index c = driven.coordinate;
      const double share = static_cast<double>(i) / (positions - 1);
      postures[static_cast<std::size_t>(i)][c] =
          layout.lower[c] +
          (driven.ratio < 0 ? 1 - share : share) * (layout.upper[c] - layout.lower[c]);
    }
  return postures;
}

std::vector<VectorXd> DigitMotion::openings(std::size_t option, const DigitRoles& roles,
                                            bool only_one) const {
  // A stated closing opens as stated; jaws open as far as they go.
  const VectorXd& stated = grip_.hand().layout().open;
  if (only_one) return {open_at(option, stated.size() > 0 ? stated : rest_, kInfinity)};
  if (!roles.palm && are_jaws()) return {open_at(option, rest_, kInfinity)};
  // Fingers that also bend backwards do not open so far that they lie behind the palm.
  const VectorXd open = open_at(option, rest_, kMostBackBend);
  std::vector<VectorXd> openings{open};
  // Digits that curl at each other may start with outer joints open.
  if (!roles.palm)
    for (const VectorXd& inner : {open, rest_}) openings.push_back(outer_open(option, inner));
  // Each motor that opposes digits at several positions, in all combinations.
  const std::vector<std::size_t> motors = opposing_motors(roles);
  for (const std::size_t motor : motors) {
    std::vector<VectorXd> next = openings;  // where it is at rest
    for (const VectorXd& before : openings) {
      const std::vector<VectorXd> all = motor_positions(before, motor, places(motors.size()));
      next.insert(next.end(), all.begin(), all.end());
    }
    openings = std::move(next);
  }
  return openings;
}

/// The posture with outer joints as far open as they go. Otherwise the ends of digits that curl at
/// each other meet before their middles hold anything.
VectorXd DigitMotion::outer_open(std::size_t option, VectorXd open) const {
  const HandLayout& layout = grip_.hand().layout();
  for (const Digit& digit : digits_)
    for (std::size_t i = 1; i < digit.curls.size(); ++i) {
      const auto d = static_cast<std::size_t>(digit.curls[i]);
      for (const DrivenCoordinate& driven : drives_[d].moves) {
        const double rate = options_[option].speed[d] * driven.ratio;
        if (rate != 0)
          open[driven.coordinate] = (rate > 0 ? layout.lower : layout.upper)[driven.coordinate];
      }
    }
  return open;
}

/// Every coordinate that closing drives move at the middle of its range, the others at rest.
VectorXd DigitMotion::half_closed(std::size_t option) const {
  const HandLayout& layout = grip_.hand().layout();
  VectorXd q = rest_;
  for (std::size_t d = 0; d < drives_.size(); ++d)
    for (const DrivenCoordinate& driven : drives_[d].moves)
      if (options_[option].speed[d] != 0)
        q[driven.coordinate] =
            (layout.lower[driven.coordinate] + layout.upper[driven.coordinate]) / 2;
  return q;
}

/// Every coordinate that closing drives move at the limit to which they close, the others at rest.
VectorXd DigitMotion::closed(std::size_t option) const {
  const HandLayout& layout = grip_.hand().layout();
  VectorXd q = rest_;
  for (std::size_t d = 0; d < drives_.size(); ++d)
    for (const DrivenCoordinate& driven : drives_[d].moves)
      if (const double rate = options_[option].speed[d] * driven.ratio; rate != 0)
        q[driven.coordinate] = (rate > 0 ? layout.upper : layout.lower)[driven.coordinate];
  return q;
}

}  // namespace thenar
