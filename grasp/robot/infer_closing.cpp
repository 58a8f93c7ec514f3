#include "grasp/robot/infer_closing.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "base/numbers.h"
#include "grasp/closing/closing_drives.h"
#include "grasp/robot/ball_grasp.h"
#include "grasp/robot/digit_motion.h"

namespace thenar {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

// Gap between a ball and the fixed jaw beside which it comes down [m]
constexpr double kBesideGap = 3e-4;
constexpr double kBallRadius = 0.035;  // radius of the ball for hands of human size [m]
// Radius of the ball for other hands, over the length of a finger [1]
constexpr double kOfReach = 0.35;
constexpr double kHumanSize[] = {0.5, 2};          // range of human size, by kBallRadius [1]
constexpr double kNoLength = 1e-6;                 // Smaller hands have no length [m]
constexpr int kCoarseSteps = 24, kFineSteps = 60;  // steps of closing
constexpr double kAsideWeight = 0.5;               // weight of a push across the approach [1]
constexpr std::size_t kTriedCandidates = 12;       // candidates that are tried on three balls
// Sizes of further balls, where no digits face each other across the first one [1].
constexpr double kFurther[] = {1.0 / 2, 1.0 / 4, 1.0 / 8, 1.0 / 16, 1.5, 2.25, 3.4};

/// A way of closing, and its score.
struct Candidate {
  std::size_t option = 0;  // of DigitMotion::options()
  VectorXd open;           // (coordinates)
  Vector3d origin{0, 0, 0}, direction{0, 0, 1};
  double against = 0;  // evidence against it [1]
  double score = -kInfinity;
};

/// A direction of approach, and points through which a ball may come.
struct Ways {
  Vector3d direction;
  std::vector<Vector3d> origins;
};

/// Search for the way of closing in which digits best face each other across a ball.
class ClosingSearch {
 public:
  ClosingSearch(const RobotSpec& robot, const StatedClosing& known)
      : robot_(robot), known_(known), grip_(robot), motion_(grip_, known.closing) {
    // A ball for the size of the hand; a digit that only slides has no length.
    const double size = kOfReach * motion_.mean_digit_length();
    const bool human = size > kHumanSize[0] * kBallRadius && size < kHumanSize[1] * kBallRadius;
    ball_ = human || size < kNoLength ? kBallRadius : size;
  }

  InferredClosing run() {
    // Where no digits face each other across it, smaller ones, for jaws of a short stroke, and
    // larger ones, for jaws that stay apart.
    const double first = ball_;
    const Candidate on_first = best_on_ball();
    if (faces(on_first)) return guess_of(on_first);
    for (const double size : kFurther) {
      ball_ = size * first;
      const Candidate best = best_on_ball();
      if (faces(best)) return guess_of(best);
    }
    ball_ = first;
    return guess_of(on_first);
  }

 private:
  /// Returns whether any digits face each other across the ball.
  static bool faces(const Candidate& best) { return best.score + best.against > 0; }

  /// All candidates coarsely, then the best ones on three balls.
  Candidate best_on_ball() {
    tried_.clear();
    for (std::size_t option = 0; option < motion_.options().size(); ++option) try_option(option);
    std::stable_sort(tried_.begin(), tried_.end(),
                     [](const Candidate& a, const Candidate& b) { return a.score > b.score; });
    if (tried_.size() > kTriedCandidates) tried_.resize(kTriedCandidates);
    for (Candidate& candidate : tried_) candidate.score = fine_score(candidate);
    return *std::max_element(
        tried_.begin(), tried_.end(),
        [](const Candidate& a, const Candidate& b) { return a.score < b.score; });
  }

  void try_option(std::size_t option) {
    const DigitRoles roles = motion_.roles(option);
    const std::vector<VectorXd> opens = motion_.openings(option, roles, known_.closing);
    // Every approach with every opening.
    for (const Ways& ways : ways_of(option, roles, opens.front()))
      for (const VectorXd& open : opens) {
        const std::vector<Pose<double>> links = grip_.hand().pose(open);
        for (const Vector3d& origin : ways.origins) {
          Candidate candidate{
              option, open, origin, ways.direction, motion_.options()[option].against, 0};
          candidate.score = score(candidate, links, roles, ball_, kCoarseSteps, {});
          tried_.push_back(std::move(candidate));
        }
      }
  }

  [[nodiscard]] std::vector<Ways> ways_of(std::size_t option, const DigitRoles& roles,
                                          const VectorXd& open) const {
    const RobotApproach& stated = robot_.approach;
    // A stated approach is the only one.
    if (known_.approach) return {{stated.direction, {stated.point}}};
    std::vector<Ways> ways;
    // A ball that comes down beside a fixed jaw touches it.
    if (motion_.digits().size() == 1)
      if (const auto jaw = motion_.fixed_jaw(option, open))
        return {{jaw->direction, {jaw->face + (ball_ + kBesideGap) * jaw->out}}};
    const PalmApproach ahead = motion_.ahead(option);
    // Towards the ends where digits stand round a palm; along the normal of a row of fingers.
    if (!roles.palm || !roles.row) ways.push_back({ahead.direction, {ahead.point}});
    if (roles.palm) ways.push_back({roles.normal, over_palm(roles)});
    return ways;
  }

  /// Points around the fingers' roots, along and across the fingers.
  static std::vector<Vector3d> over_palm(const DigitRoles& roles) {
    std::vector<Vector3d> origins;
    const Vector3d across = roles.normal.cross(roles.along);
    for (const double u : {0.1, -0.1, 0.3, -0.3, -0.5})
      for (const double w : {0.0, -0.25, 0.25, -0.5, 0.5})
        origins.emplace_back(roles.root + roles.length * (u * roles.along + w * across));
    return origins;
  }

  /// Places the ball where it comes to rest on its approach. @returns whether it meets the hand
  [[nodiscard]] bool place(const Candidate& candidate, const std::vector<Pose<double>>& links,
                           ProbeBall& ball) const {
    const double way = grip_.sphere_cast(links, candidate.origin, candidate.direction, ball.radius);
    if (way == -kInfinity) return false;
    ball.centre = candidate.origin + (way + 1e-4) * candidate.direction;
    return true;
  }

  [[nodiscard]] double score(const Candidate& candidate, const std::vector<Pose<double>>& links,
                             const DigitRoles& roles, double radius, int steps,
                             const std::vector<std::string>& self) const {
    ProbeBall ball{{}, radius};
    if (!place(candidate, links, ball)) return -candidate.against;
    const double aside = roles.palm ? kAsideWeight * aside_of(candidate.direction, links, ball) : 0;
    return facing(grip_.close(motion_.drives(candidate.option), candidate.open, ball, steps, self),
                  roles) -
           candidate.against - aside;
  }

  /// Share of the push on the ball where it comes to rest that is across the approach, so that it
  /// would slip off to the side [1]
  [[nodiscard]] double aside_of(const Vector3d& direction, const std::vector<Pose<double>>& links,
                                const ProbeBall& ball) const {
    Vector3d push = Vector3d::Zero();
    for (const BallContact& contact : grip_.contacts(links, ball)) push += contact.normal;
    return push.isZero(0) ? 0 : push.normalized().cross(direction).norm();
  }

  /// Score of how digits face each other, and the palm if they stand round it.
  [[nodiscard]] double facing(const std::vector<BallContact>& contacts,
                              const DigitRoles& roles) const {
    const std::vector<std::string>& digits = motion_.digits();
    const auto count = static_cast<Eigen::Index>(digits.size());
    const Eigen::Index others = roles.palm ? count : count + 1;  // last: contacts of no digit
    Eigen::MatrixXd faces = Eigen::MatrixXd::Zero(count, others);
    const auto digit_of = [&](const BallContact& contact) {
      return std::find(digits.begin(), digits.end(),
                       grip_.surfaces()[static_cast<std::size_t>(contact.surface)].digit) -
             digits.begin();
    };
    // Best opposition of normals for each pair of digits.
    for (const BallContact& a : contacts)
      for (const BallContact& b : contacts) {
        const auto i = digit_of(a), j = digit_of(b);
        if (i < count && j < others && i != j)
          faces(i, j) = std::max(faces(i, j), -a.normal.dot(b.normal));
      }
    // Mean over digits, plus the best pair of a finger and an opposed digit.
    double sum =
        faces.size() == 0 ? 0 : faces.rowwise().maxCoeff().sum() / static_cast<double>(count);
    double best = 0;
    for (Eigen::Index i = 0; i < count; ++i)
      for (Eigen::Index j = 0; j < count; ++j)
        if (roles.opposed[static_cast<std::size_t>(i)] &&
            !roles.opposed[static_cast<std::size_t>(j)])
          best = std::max(best, faces(i, j));
    return sum + best;
  }

  [[nodiscard]] double fine_score(const Candidate& candidate) const {
    const DigitRoles roles = motion_.roles(candidate.option);
    const std::vector<Pose<double>> links = grip_.hand().pose(candidate.open);
    double sum = 0;
    for (const double size : {1.0, 0.8, 1.2})
      sum += score(candidate, links, roles, size * ball_, kFineSteps, standing(roles)) / 3;
    return sum;
  }

  /// Digits that others may stop: opposed ones, or all if they curl at each other.
  [[nodiscard]] std::vector<std::string> standing(const DigitRoles& roles) const {
    return roles.palm ? opposed(roles) : motion_.digits();
  }

  [[nodiscard]] std::vector<std::string> opposed(const DigitRoles& roles) const {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < roles.opposed.size(); ++i)
      if (roles.opposed[i]) names.push_back(motion_.digits()[i]);
    return names;
  }

  [[nodiscard]] InferredClosing guess_of(const Candidate& best) const {
    InferredClosing guess{robot_, ball_, {}, {}, {}, {}, {}};
    std::optional<FixedJaw> jaw;
    if (motion_.digits().size() == 1) jaw = motion_.fixed_jaw(best.option, best.open);
    guess.facing = faces(best) && (motion_.digits().size() > 1 || jaw);
    const DigitRoles roles = motion_.roles(best.option);
    if (const std::vector<std::string> thumbs = opposed(roles); roles.row && thumbs.size() == 1)
      guess.thumb = thumbs.front();
    // Close once more to see which digits touch.
    const std::vector<Drive> drives = motion_.drives(best.option);
    const std::vector<Pose<double>> links = grip_.hand().pose(best.open);
    ProbeBall ball{{}, ball_};
    std::set<std::string> touching;
    if (place(best, links, ball)) {
      for (const BallContact& contact :
           grip_.close(drives, best.open, ball, kFineSteps, standing(roles)))
        touching.insert(grip_.surfaces()[static_cast<std::size_t>(contact.surface)].digit);
      if (!known_.approach && roles.palm)
        guess.robot.approach.point = ball.centre - ball.radius * best.direction;
    }
    for (const std::string& digit : motion_.digits())
      if (touching.count(digit) == 0) guess.idle.push_back(digit);
    // The approach that was found.
    if (!known_.approach) {
      guess.robot.approach.direction = best.direction;
      const PalmApproach ahead = motion_.ahead(best.option);
      if (!roles.palm || (best.origin == ahead.point && best.direction == ahead.direction))
        guess.robot.approach.point = best.origin;
      // Objects of any size come down between two jaws, of which one is fixed.
      if (jaw) guess.robot.approach = {jaw->face + jaw->opening / 2 * jaw->out, jaw->direction};
    }
    if (!known_.closing) write_motors(guess, drives, best.open);
    return guess;
  }

  void write_motors(InferredClosing& guess, const std::vector<Drive>& drives,
                    const VectorXd& open) const {
    for (const Drive& drive : drives)
      for (RobotDof& dof : guess.robot.dofs) {
        if (dof.name != drive.name) continue;
        dof.speed = drive.speed;
        // Motors that close, with their sense.
        if (dof.speed != 0) {
          guess.closing.push_back(
              fmt::format("{} {}", dof.name, dof.speed > 0 ? "upwards" : "downwards"));
        }
        // Motors that start elsewhere than without a stated posture; a stated one is kept.
        if (dof.open) continue;
        const DrivenCoordinate& first = drive.moves.front();
        const double at = open[first.coordinate] / first.ratio;
        if (std::abs(open[first.coordinate] - unsaid_open(first, dof.speed)) < 1e-9) continue;
        dof.open = std::min(std::max(at, dof.lower), dof.upper);
        guess.set.push_back(fmt::format("{} at {:.4g}", dof.name, *dof.open));
      }
  }

  /// Start of a coordinate without RobotDof::open.
  [[nodiscard]] double unsaid_open(const DrivenCoordinate& driven, double speed) const {
    const HandLayout& layout = grip_.hand().layout();
    const double rate = speed * driven.ratio;
    if (rate == 0) return motion_.rest()[driven.coordinate];
    return (rate > 0 ? layout.lower : layout.upper)[driven.coordinate];
  }

  const RobotSpec& robot_;
  StatedClosing known_;
  BallGrasp grip_;
  DigitMotion motion_;
  double ball_ = kBallRadius;
  std::vector<Candidate> tried_;
};

}  // namespace

InferredClosing infer_closing(const RobotSpec& robot, const StatedClosing& known) {
  return ClosingSearch(robot, known).run();
}

}  // namespace thenar
