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

// Gap between the ball and the fixed jaw beside which it approaches [m]
constexpr double kBesideGap = 3e-4;
// Gap between the ball at rest and the hand that stopped its approach [m]
constexpr double kRestGap = 1e-4;
constexpr double kBallRadius = 0.035;  // radius of the ball for hands of human size [m]
// Radius of the ball for other hands, over the length of a finger [1]
constexpr double kRadiusPerLength = 0.35;
constexpr double kHumanSizeRange[] = {0.5, 2};     // range of human size, over kBallRadius [1]
constexpr double kMinHandSize = 1e-6;              // size below which a hand has no length [m]
constexpr int kCoarseSteps = 24, kFineSteps = 60;  // number of steps of a closing motion
constexpr double kPushAsideWeight = 0.5;           // weight of a push across the approach [1]
constexpr std::size_t kFineCandidates = 12;        // number of candidates tried on three balls
constexpr double kStartTolerance = 1e-9;           // difference of starts that are equal [rad], [m]
// Sizes of further balls over the first one, on which no digits face each other [1]
constexpr double kFurtherSizes[] = {1.0 / 2, 1.0 / 4, 1.0 / 8, 1.0 / 16, 1.5, 2.25, 3.4};

/// A combination of closing directions, opening posture and approach, with its score.
struct Candidate {
  std::size_t option = 0;       // entry of DigitMotion::options()
  VectorXd open;                // opening posture (coordinates)
  Vector3d origin{0, 0, 0};     // point on the path of the ball [m] (3)
  Vector3d direction{0, 0, 1};  // approach, unit (3)
  double penalty = 0;           // SenseOption::penalty [1]
  double score = -kInfinity;    // score of the trial [1]
};

/// A direction of approach, and points on possible paths of a ball.
struct ApproachPaths {
  Vector3d direction;             // unit (3)
  std::vector<Vector3d> origins;  // points on each path [m] (3)
};

/// Search for the combination in which digits best face each other across a ball.
class ClosingSearch {
 public:
  ClosingSearch(const RobotSpec& robot, const StatedClosing& known)
      : robot_(robot),
        known_(known),
        grip_(robot),
        motion_(grip_, known.closing ? ClosingSource::kStated : ClosingSource::kInferred) {
    // The ball fits the size of the hand; a digit that only translates has no length.
    const double size = kRadiusPerLength * motion_.mean_digit_length();
    const bool human =
        size > kHumanSizeRange[0] * kBallRadius && size < kHumanSizeRange[1] * kBallRadius;
    ball_ = human || size < kMinHandSize ? kBallRadius : size;
  }

  InferredClosing run() {
    // If no digits face each other across the ball, try smaller ones, for jaws with a short stroke,
    // and larger ones, for jaws that stay apart.
    const double first = ball_;
    const Candidate on_first = best_on_ball();
    if (faces(on_first)) return inferred_from(on_first);
    for (const double size : kFurtherSizes) {
      ball_ = size * first;
      const Candidate best = best_on_ball();
      if (faces(best)) return inferred_from(best);
    }
    ball_ = first;
    return inferred_from(on_first);
  }

 private:
  /// Returns whether any digits face each other across the ball.
  static bool faces(const Candidate& best) { return best.score + best.penalty > 0; }

  /// Tries all candidates coarsely, then the best ones on three balls, and returns the best.
  Candidate best_on_ball() {
    candidates_.clear();
    for (std::size_t option = 0; option < motion_.options().size(); ++option) try_option(option);
    std::stable_sort(candidates_.begin(), candidates_.end(),
                     [](const Candidate& a, const Candidate& b) { return a.score > b.score; });
    if (candidates_.size() > kFineCandidates) candidates_.resize(kFineCandidates);
    for (Candidate& candidate : candidates_) candidate.score = fine_score(candidate);
    return *std::max_element(
        candidates_.begin(), candidates_.end(),
        [](const Candidate& a, const Candidate& b) { return a.score < b.score; });
  }

  /// Tries every approach with every opening posture for one combination of closing directions.
  void try_option(std::size_t option) {
    const DigitRoles roles = motion_.roles(option);
    const std::vector<VectorXd> opens = motion_.opening_postures(option, roles);
    for (const ApproachPaths& paths : paths_of(option, roles, opens.front()))
      for (const VectorXd& open : opens) {
        const std::vector<Pose<double>> links = grip_.hand().pose(open);
        for (const Vector3d& origin : paths.origins) {
          Candidate candidate{
              option, open, origin, paths.direction, motion_.options()[option].penalty, 0};
          candidate.score = score(candidate, links, roles, ball_, kCoarseSteps, {});
          candidates_.push_back(std::move(candidate));
        }
      }
  }

  /// Returns the paths of the ball that are worth a trial.
  [[nodiscard]] std::vector<ApproachPaths> paths_of(std::size_t option, const DigitRoles& roles,
                                                    const VectorXd& open) const {
    const RobotApproach& stated = robot_.approach;
    // A stated approach is the only one.
    if (known_.approach) return {{stated.direction, {stated.point}}};
    std::vector<ApproachPaths> paths;
    // Beside a fixed jaw the ball almost touches it.
    if (motion_.digits().size() == 1)
      if (const auto jaw = motion_.fixed_jaw(option, open))
        return {{jaw->direction, {jaw->face + (ball_ + kBesideGap) * jaw->opening_direction}}};
    const PalmApproach ahead = motion_.forward_approach(option);
    // Towards the tips of digits around a palm; along the normal of a row of fingers.
    if (!roles.palm || !roles.row) paths.push_back({ahead.direction, {ahead.point}});
    if (roles.palm) paths.push_back({roles.normal, points_over_palm(roles)});
    return paths;
  }

  /// Returns points around the fingers' roots, along and across the fingers.
  static std::vector<Vector3d> points_over_palm(const DigitRoles& roles) {
    std::vector<Vector3d> origins;
    const Vector3d across = roles.normal.cross(roles.along);
    for (const double u : {0.1, -0.1, 0.3, -0.3, -0.5})
      for (const double w : {0.0, -0.25, 0.25, -0.5, 0.5})
        origins.emplace_back(roles.root + roles.length * (u * roles.along + w * across));
    return origins;
  }

  /// Moves the ball along its approach until it meets the hand. @returns whether it does
  [[nodiscard]] bool place_ball(const Candidate& candidate, const std::vector<Pose<double>>& links,
                                ProbeBall& ball) const {
    const double distance =
        grip_.sphere_cast(links, candidate.origin, candidate.direction, ball.radius);
    if (distance == -kInfinity) return false;
    ball.centre = candidate.origin + (distance + kRestGap) * candidate.direction;
    return true;
  }

  /// Closes the hand on a ball and returns the score of its contacts.
  [[nodiscard]] double score(const Candidate& candidate, const std::vector<Pose<double>>& links,
                             const DigitRoles& roles, double radius, int steps,
                             const std::vector<std::string>& self) const {
    ProbeBall ball{{}, radius};
    if (!place_ball(candidate, links, ball)) return -candidate.penalty;
    const double aside =
        roles.palm ? kPushAsideWeight * push_aside(candidate.direction, links, ball) : 0;
    return facing_score(
               grip_.close(motion_.drives(candidate.option), candidate.open, ball, steps, self),
               roles) -
           candidate.penalty - aside;
  }

  /// Returns the sine between the push on the ball at rest and the approach, by which the ball
  /// would slip off to the side [1]
  [[nodiscard]] double push_aside(const Vector3d& direction, const std::vector<Pose<double>>& links,
                                  const ProbeBall& ball) const {
    Vector3d push = Vector3d::Zero();
    for (const BallContact& contact : grip_.contacts(links, ball)) push += contact.normal;
    return push.isZero(0) ? 0 : push.normalized().cross(direction).norm();
  }

  /// Returns a score of how digits face each other, and the palm if they surround it.
  [[nodiscard]] double facing_score(const std::vector<BallContact>& contacts,
                                    const DigitRoles& roles) const {
    const std::vector<std::string>& digits = motion_.digits();
    const auto count = static_cast<Eigen::Index>(digits.size());
    const Eigen::Index others = roles.palm ? count : count + 1;  // last: contacts of no digit
    Eigen::MatrixXd opposition = Eigen::MatrixXd::Zero(count, others);
    const auto digit_of = [&](const BallContact& contact) {
      return std::find(digits.begin(), digits.end(), grip_.surfaces()[contact.surface].digit) -
             digits.begin();
    };
    // Best opposition of normals for each pair of digits.
    for (const BallContact& a : contacts)
      for (const BallContact& b : contacts) {
        const auto i = digit_of(a), j = digit_of(b);
        if (i < count && j < others && i != j)
          opposition(i, j) = std::max(opposition(i, j), -a.normal.dot(b.normal));
      }
    // Mean over digits, plus the best pair of a finger and an opposed digit.
    double sum = opposition.size() == 0
                     ? 0
                     : opposition.rowwise().maxCoeff().sum() / static_cast<double>(count);
    double best = 0;
    for (Eigen::Index i = 0; i < count; ++i)
      for (Eigen::Index j = 0; j < count; ++j)
        if (roles.opposed[i] && !roles.opposed[j]) best = std::max(best, opposition(i, j));
    return sum + best;
  }

  /// Returns the mean score on balls of three sizes.
  [[nodiscard]] double fine_score(const Candidate& candidate) const {
    const DigitRoles roles = motion_.roles(candidate.option);
    const std::vector<Pose<double>> links = grip_.hand().pose(candidate.open);
    double sum = 0;
    for (const double size : {1.0, 0.8, 1.2})
      sum += score(candidate, links, roles, size * ball_, kFineSteps, stopping_digits(roles)) / 3;
    return sum;
  }

  /// Returns digits that can be stopped by others: opposed ones, or all if they curl towards each
  /// other.
  [[nodiscard]] std::vector<std::string> stopping_digits(const DigitRoles& roles) const {
    return roles.palm ? opposed_digits(roles) : motion_.digits();
  }

  [[nodiscard]] std::vector<std::string> opposed_digits(const DigitRoles& roles) const {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < roles.opposed.size(); ++i)
      if (roles.opposed[i]) names.push_back(motion_.digits()[i]);
    return names;
  }

  /// Returns the inference from the best candidate, and writes it into its robot.
  [[nodiscard]] InferredClosing inferred_from(const Candidate& best) const {
    InferredClosing guess{robot_, ball_, {}, {}, {}, {}, {}};
    std::optional<FixedJaw> jaw;
    if (motion_.digits().size() == 1) jaw = motion_.fixed_jaw(best.option, best.open);
    guess.facing = faces(best) && (motion_.digits().size() > 1 || jaw);
    const DigitRoles roles = motion_.roles(best.option);
    if (const std::vector<std::string> thumbs = opposed_digits(roles);
        roles.row && thumbs.size() == 1)
      guess.thumb = thumbs.front();
    // Close once more to find the digits that touch the ball.
    const std::vector<Drive> drives = motion_.drives(best.option);
    const std::vector<Pose<double>> links = grip_.hand().pose(best.open);
    ProbeBall ball{{}, ball_};
    std::set<std::string> touching;
    if (place_ball(best, links, ball)) {
      for (const BallContact& contact :
           grip_.close(drives, best.open, ball, kFineSteps, stopping_digits(roles)))
        touching.insert(grip_.surfaces()[contact.surface].digit);
      if (!known_.approach && roles.palm)
        guess.robot.approach.point = ball.centre - ball.radius * best.direction;
    }
    for (const std::string& digit : motion_.digits())
      if (touching.count(digit) == 0) guess.idle.push_back(digit);
    // The inferred approach.
    if (!known_.approach) {
      guess.robot.approach.direction = best.direction;
      const PalmApproach ahead = motion_.forward_approach(best.option);
      if (!roles.palm || (best.origin == ahead.point && best.direction == ahead.direction))
        guess.robot.approach.point = best.origin;
      // Between two jaws, of which one is fixed, for objects of any size.
      if (jaw)
        guess.robot.approach = {jaw->face + jaw->opening / 2 * jaw->opening_direction,
                                jaw->direction};
    }
    if (!known_.closing) write_motors(guess, drives, best.open);
    return guess;
  }

  /// Writes closing speeds and opening positions into the robot, and lists them.
  void write_motors(InferredClosing& guess, const std::vector<Drive>& drives,
                    const VectorXd& open) const {
    for (const Drive& drive : drives)
      for (RobotDof& dof : guess.robot.dofs) {
        if (dof.name != drive.name) continue;
        dof.speed = drive.speed;
        // Motors that close, with their direction.
        if (dof.speed != 0) {
          guess.closing.push_back(
              fmt::format("{} {}", dof.name, dof.speed > 0 ? "upwards" : "downwards"));
        }
        // Motors that start elsewhere than they would by default; stated positions are kept.
        if (dof.open) continue;
        const DrivenCoordinate& first = drive.moves.front();
        const double at = open[first.coordinate] / first.ratio;
        if (std::abs(open[first.coordinate] - default_open(first, dof.speed)) < kStartTolerance)
          continue;
        dof.open = std::min(std::max(at, dof.lower), dof.upper);
        guess.set.push_back(fmt::format("{} at {:.4g}", dof.name, *dof.open));
      }
  }

  /// Returns the start of a coordinate without RobotDof::open.
  [[nodiscard]] double default_open(const DrivenCoordinate& driven, double speed) const {
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
  std::vector<Candidate> candidates_;
};

}  // namespace

InferredClosing infer_closing(const RobotSpec& robot, const StatedClosing& known) {
  return ClosingSearch(robot, known).run();
}

}  // namespace thenar
