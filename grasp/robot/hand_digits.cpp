#include "grasp/robot/hand_digits.h"

#include <algorithm>
#include <cmath>

#include "base/lists.h"
#include "grasp/closing/fingertip_paths.h"
#include "grasp/robot/posed_surfaces.h"

namespace thenar {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kMinCurlCosine = 0.7;  // cosine of a curling joint to the last joint's axis [1]
constexpr double kSameDistance = 1e-9;  // relative change of tip distances that counts as none [1]
constexpr double kNoMotion = 1e-9;      // rotation or motion that counts as none [1], [m]
// Motion of another tip over a tip's own, from which a drive spreads both [1]
constexpr double kMinSpreadRatio = 0.85;

}  // namespace

HandDigits::HandDigits(const BallGrasp& grip) : grip_(grip), drives_(grip.hand().layout().drives) {
  const HandLayout& layout = grip.hand().layout();
  rest_ = layout.lower.cwiseMax(0).cwiseMin(layout.upper);
  find_digits();
  sort_drives();
  // Curling drives and tip motions are defined for straight digits.
  straighten();
  find_digits();
  sort_drives();
  orient_drives();
  join_rows();
}

void HandDigits::find_digits() {
  digits_.clear();
  names_.clear();
  const std::vector<Pose<double>> links = grip_.hand().pose(rest_);
  const std::vector<SampledSurface>& surfaces = grip_.surfaces();
  std::vector<int> depth;  // number of joints between each surface and the base
  depth.reserve(surfaces.size());
  // Innermost and outermost surface of each digit.
  for (const SampledSurface& surface : surfaces)
    depth.push_back(joints_to(grip_.hand().layout(), surface.link));
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    if (surfaces[s].digit.empty()) continue;
    HandDigit* digit = find_named(digits_, surfaces[s].digit);
    if (digit == nullptr) {
      digits_.push_back({surfaces[s].digit, s, s, {}, {}, {}, {}});
      names_.push_back(surfaces[s].digit);
      continue;
    }
    if (depth[s] < depth[digit->first]) digit->first = s;
    if (depth[s] >= depth[digit->last]) digit->last = s;
  }
  // Centre of a surface at rest.
  const auto centre = [&](std::size_t s) {
    return moved_with(links, surfaces[s].link, surfaces[s].centre);
  };
  for (HandDigit& digit : digits_) {
    // The root is the hinge of the digit's first link, or the link itself for a slide.
    digit.tip = centre(digit.last);
    digit.root = centre(digit.first);
    const int link = surfaces[digit.first].link;
    if (link >= 0 && !grip_.hand().is_prismatic(link))
      digit.root = links[link] * grip_.hand().axis_point(link);
  }
}

Eigen::Matrix<double, 6, 1> HandDigits::twist(std::size_t drive, const HandDigit& digit) const {
  const SampledSurface& tip = grip_.surfaces()[digit.last];
  Eigen::Matrix<double, 6, 1> sum = Eigen::Matrix<double, 6, 1>::Zero();
  if (tip.link < 0) return sum;
  const auto J = grip_.hand().jacobian(rest_, tip.link, tip.centre);
  for (const DrivenCoordinate& moved : drives_[drive].moves)
    sum += moved.ratio * J.col(moved.coordinate);
  return sum;
}

Vector3d HandDigits::tip_rotation(std::size_t drive, const HandDigit& digit) const {
  return twist(drive, digit).head<3>();
}

Vector3d HandDigits::tip_translation(std::size_t drive, const HandDigit& digit) const {
  return twist(drive, digit).tail<3>();
}

std::vector<int> HandDigits::links_of(const HandDigit& digit) const {
  std::vector<int> links;
  for (int link = grip_.surfaces()[digit.last].link; link >= 0;
       link = grip_.hand().layout().parents[link])
    links.push_back(link);
  return links;
}

/// Returns whether a drive moves every tip, and none relative to another, like a wrist.
bool HandDigits::moves_alike(std::size_t drive) const {
  for (const HandDigit& digit : digits_)
    if (tip_translation(drive, digit).norm() < kNoMotion &&
        tip_rotation(drive, digit).norm() < kNoMotion)
      return false;
  if (digits_.size() < 2) return false;
  // Distances between tips must be equal with the drive moved either way.
  std::vector<double> senses(drives_.size(), 0);
  senses[drive] = 1;
  const double up = tip_separation(posture_at(senses, 0.1));
  senses[drive] = -1;
  const double down = tip_separation(posture_at(senses, 0.1));
  return std::abs(up - down) <= kSameDistance * std::max(up, down);
}

/// Returns the axis of the outermost rotating joint of a digit; zero: there is none. (3)
Vector3d HandDigits::last_axis(const HandDigit& digit) const {
  for (const int link : links_of(digit))
    if (!grip_.hand().is_prismatic(link)) return grip_.hand().axis(rest_, link);
  return Vector3d::Zero();
}

/// Assigns each drive to the digits that it moves, as a curling or as a turning drive.
void HandDigits::sort_drives() {
  for (std::size_t d = 0; d < drives_.size(); ++d) {
    if (moves_alike(d)) continue;
    // A drive of several digits has the kind that it has for the digit whose tip moves most.
    double farthest = -1;
    bool curls = true;
    std::vector<HandDigit*> moved;
    for (HandDigit& digit : digits_) {
      const Vector3d w = tip_rotation(d, digit), v = tip_translation(d, digit);
      if (w.norm() < kNoMotion && v.norm() < kNoMotion) continue;
      moved.push_back(&digit);
      if (v.norm() <= farthest) continue;
      farthest = v.norm();
      // Parallel to the last axis it curls the digit, otherwise it turns it.
      const Vector3d last = last_axis(digit);
      curls = w.norm() < kNoMotion || last.isZero(0) ||
              std::abs(w.dot(last)) >= kMinCurlCosine * w.norm() * last.norm();
    }
    for (HandDigit* digit : moved)
      (curls ? digit->curls : digit->turns).push_back(static_cast<int>(d));
  }
}

/// Returns the sign of a drive relative to a digit's outermost one, by rotation or by motion of the
/// tip.
double HandDigits::sign_against(std::size_t outer, std::size_t drive,
                                const HandDigit& digit) const {
  const Vector3d w = tip_rotation(drive, digit), w_outer = tip_rotation(outer, digit);
  const bool turn = w.norm() > kNoMotion && w_outer.norm() > kNoMotion;
  const double along =
      turn ? w.dot(w_outer) : tip_translation(drive, digit).dot(tip_translation(outer, digit));
  return along < 0 ? -1.0 : 1.0;
}

/// Finds the signs of drives that curl each digit, and their groups.
void HandDigits::orient_drives() {
  groups_.orientation.assign(drives_.size(), 0);
  groups_.group.assign(drives_.size(), -1);
  // Drives without any rotation.
  for (std::size_t d = 0; d < drives_.size(); ++d)
    groups_.slides.push_back(all_of(digits_, [&](const HandDigit& digit) {
      return tip_rotation(d, digit).norm() < kNoMotion;
    }));
  int groups = 0;
  for (const HandDigit& digit : digits_) {
    if (digit.curls.empty()) continue;
    const auto outer = static_cast<std::size_t>(digit.curls.back());
    const auto sign = [&](std::size_t d) { return sign_against(outer, d, digit); };
    // A drive that already has a sign determines that of the whole digit.
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

double HandDigits::range(std::size_t drive) const {
  const HandLayout& layout = grip_.hand().layout();
  const DrivenCoordinate& first = drives_[drive].moves.front();
  return (layout.upper[first.coordinate] - layout.lower[first.coordinate]) / std::abs(first.ratio);
}

VectorXd HandDigits::posture_at(const std::vector<double>& senses, double share) const {
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

/// Returns the mean distance between points of the only digit's end and the palm [m].
double HandDigits::distance_from_palm(const std::vector<Pose<double>>& links) const {
  const Eigen::Matrix3Xd palm = points_of(grip_, palm_surfaces(grip_), links),
                         end = points_of(grip_, {digits_.front().last}, links);
  if (palm.cols() == 0) return 0;
  double sum = 0;
  for (const auto& p : end.colwise())
    sum += std::sqrt((palm.colwise() - p).colwise().squaredNorm().minCoeff());
  return sum / static_cast<double>(end.cols());
}

double HandDigits::tip_separation(const VectorXd& q) const {
  const std::vector<Pose<double>> links = grip_.hand().pose(q);
  if (digits_.size() == 1) return distance_from_palm(links);
  // Positions of the tips, then the sum over all pairs.
  std::vector<Vector3d> tips;
  for (const HandDigit& digit : digits_) {
    const SampledSurface& tip = grip_.surfaces()[digit.last];
    tips.push_back(moved_with(links, tip.link, tip.centre));
  }
  double sum = 0;
  for (std::size_t a = 0; a < tips.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) sum += (tips[a] - tips[b]).norm();
  return sum;
}

double HandDigits::mean_digit_length() const {
  double sum = 0;
  for (const HandDigit& digit : digits_) sum += (digit.tip - digit.root).norm();
  if (sum > kNoMotion * static_cast<double>(digits_.size()))
    return sum / static_cast<double>(digits_.size());
  // Jaws of one link have no length: use the distance by which they open.
  std::vector<double> up(drives_.size(), 1), down(drives_.size(), -1);
  return std::max(tip_separation(posture_at(up, 1)), tip_separation(posture_at(down, 1)));
}

bool HandDigits::rotates_digits(std::size_t drive) const {
  return any_of(digits_, [&](const HandDigit& digit) {
    return tip_rotation(drive, digit).norm() > kNoMotion;
  });
}

bool HandDigits::spreads(std::size_t drive, const HandDigit& digit) const {
  const double own = tip_translation(drive, digit).norm();
  return any_of(digits_, [&](const HandDigit& other) {
    return &other != &digit && tip_translation(drive, other).norm() > kMinSpreadRatio * own;
  });
}

}  // namespace thenar
