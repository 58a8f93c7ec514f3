#include "grasp/contact/time_of_contact.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "base/error.h"

namespace thenar {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The gap that certainly is there [m].
double certain(const Separation& at) {
  return std::isfinite(at.error) ? at.distance - at.error : at.distance;
}

bool touching(const Separation& at, double gap) {
  return at.distance <= gap || certain(at) <= gap / 10;
}

class Follower {
 public:
  Follower(const std::vector<Approach>& pairs, double end, const TimeOfContactOptions& options)
      : pairs_(pairs), end_(end), options_(options) {}

  TimeOfContact advance() {
    std::vector<double> free(pairs_.size(), 0);  // up to where each pair cannot touch
    while (true) {
      const auto next = std::min_element(free.begin(), free.end());
      if (next == free.end() || *next > end_) return none(end_, false);
      if (questions_ >= options_.most_questions) return none(*next, true);
      const auto i = static_cast<std::size_t>(next - free.begin());
      const Separation at = ask(i, *next, pairs_[i].speed * (end_ - *next));
      if (touching(at, options_.gap)) return found(i, *next, at);
      *next = pairs_[i].speed > 0 ? *next + certain(at) / pairs_[i].speed : kInfinity;
    }
  }

  TimeOfContact bisect() {
    double fastest = 0;
    for (const Approach& pair : pairs_) fastest = std::max(fastest, pair.speed);
    const double step = fastest > 0 ? std::min(end_, options_.step / fastest) : end_;
    double before = 0;
    for (int k = 0; true; ++k) {
      const double s = std::min(end_, k * step);
      for (std::size_t i = 0; i < pairs_.size(); ++i) {
        if (questions_ >= options_.most_questions) return none(before, true);
        const Separation at = ask(i, s, options_.gap);
        if (touching(at, options_.gap)) return earliest(i, before, s, at);
      }
      if (s >= end_) return none(end_, false);
      before = s;
    }
  }

 private:
  Separation ask(std::size_t i, double s, double cutoff) {
    ++questions_;
    return pairs_[i].separation(s, std::max(cutoff, options_.gap));
  }

  [[nodiscard]] TimeOfContact none(double s, bool gave_up) const {
    return {false, s, -1, {}, questions_, gave_up};
  }
  [[nodiscard]] TimeOfContact found(std::size_t i, double s, const Separation& at) const {
    return {true, s, static_cast<int>(i), at, questions_, false};
  }

  /// Of pair i, and of those after it that touch before, between `from`, free, and `to`.
  TimeOfContact earliest(std::size_t i, double from, double to, const Separation& at) {
    TimeOfContact best = halve(i, from, to, at);
    for (++i; i < pairs_.size() && best.s > from; ++i) {
      const Separation there = ask(i, best.s, options_.gap);
      if (touching(there, options_.gap)) best = halve(i, from, best.s, there);
    }
    best.questions = questions_;
    return best;
  }

  /// Halves until the gap is small, but there.
  TimeOfContact halve(std::size_t i, double from, double to, Separation at) {
    double s = to;
    bool free = false;
    for (int k = 0; k < kMostHalvings && to > 0 && (free || at.distance < 0); ++k) {
      s = (from + to) / 2;
      at = ask(i, s, options_.gap);
      free = !touching(at, options_.gap);
      (free ? from : to) = s;
    }
    return found(i, s, at);
  }

  static constexpr int kMostHalvings = 60;  // to the rounding of s

  const std::vector<Approach>& pairs_;
  const double end_;
  const TimeOfContactOptions options_;
  int questions_ = 0;
};

}  // namespace

TimeOfContact time_of_contact(const std::vector<Approach>& pairs, double end,
                              const TimeOfContactOptions& options) {
  require(end > 0 && std::isfinite(end), "a motion must end after 0, got {}", end);
  require(options.gap > 0, "the gap must be positive, got {} m", options.gap);
  require(options.step > 0, "the step must be positive, got {} m", options.step);
  for (std::size_t i = 0; i < pairs.size(); ++i)
    require(pairs[i].speed >= 0 && std::isfinite(pairs[i].speed),
            "speed of pair {} must be finite and >= 0, got {}", i, pairs[i].speed);
  Follower follower(pairs, end, options);
  return options.search == ContactSearch::kAdvance ? follower.advance() : follower.bisect();
}

double reach_from(const TouchBody& a, const Eigen::Vector3d& point,
                  const Eigen::Vector3d& direction) {
  double reach = 0;
  for (const TouchTriangle& triangle : a.triangles)
    for (int k = 0; k < 3; ++k)
      reach = std::max(reach,
                       (triangle.corners.col(k) - point).cross(direction).norm() + triangle.radius);
  return reach;
}

}  // namespace thenar
