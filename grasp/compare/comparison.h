#pragma once

/// Hands compared on the same objects by the same approaches: what goes in, and what comes out.

#include <array>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "base/fidelity.h"
#include "base/progress.h"
#include "data/io/world/world.h"
#include "grasp/closing/grasp.h"
#include "grasp/quality/robustness.h"
#include "hand/hand.h"

namespace thenar {

/// A place on a hand, reference posture.
struct HandPlace {
  std::string name;
  int link = -1;               // that carries it; -1: the base
  Eigen::Vector3d p{0, 0, 0};  // hand frame [m] (3)
  int score = 0;               // of Kapandji's ten, where it is one of them
};

/// A hand to be compared.
struct ComparedHand {
  std::string name;
  std::shared_ptr<const Hand> hand;
  ContactModel contact = ContactModel::kHardPoint;  // or soft fingers
  ClosingRates rates;                               // as CloseOptions::rates
  HandPlace thumb;                                  // its pad, where there are `opposition` places
  std::vector<HandPlace> places;                    // Kapandji's; empty: an analogous scale serves
  std::vector<std::string> warnings;
};

/// What a grasp is asked to do, measured with what drives the hand.
enum class GraspTask {
  kForceClosure,  // [1] no load: the share of approaches that reach it
  kHoldWeight,    // [1] times the object's weight, along each of its axes both ways
  kPull,          // [N] along its z axis, either way
  kTurn           // [N m] about its z axis, either way
};

/// "force-closure", "hold-weight", "pull", "turn"; the reverse @throws InputError listing them.
[[nodiscard]] std::string name_of(GraspTask task);
[[nodiscard]] GraspTask grasp_task(const std::string& name);

struct Comparison;

struct CompareOptions {
  int approaches = 20;          // of every hand to every object
  unsigned seed = 1;            //
  int threads = 1;              //
  int best = 3;                 // grasps whose loads are worked out, of each hand and object
  bool normalise_size = false;  // objects scaled by reach_of_digits() over the first hand's
  std::vector<GraspTask> tasks{GraspTask::kForceClosure, GraspTask::kHoldWeight};
  int workspace_draws = 150000;                 // postures
  double workspace_voxel = 5e-3;                // [m]
  GraspOptions grasp;                           // `way` is set for each approach
  std::function<void(const Comparison&)> keep;  // hears of every finished cell
};

/// One of the best grasps of a cell.
struct BestGrasp {
  int approach = 0;   // its number
  Pose<double> X_WH;  // where the hand came to; the object stands at the world's origin
  Eigen::VectorXd q;  // (coordinates)
  std::vector<HandContact> contacts;     // object frame
  double epsilon = 0;                    // certified lower bound [unit forces]
  std::string type;                      // of grasp_type()
  double hold = 0;                       // smallest sum of normal forces that holds the weight
                                         // whichever axis points down, by friction alone [N];
                                         // infinite: they cannot
  std::map<std::string, double> margin;  // task -> largest load withstood with the hand's
                                         // actuators; units as GraspTask; NaN: not known
  std::map<std::string, std::string>
      reasons;  // task or "epsilon" -> why it is zero, not known or infinite
  /// Least of all wrenches that the hand's actuators withstand [N]; NaN: not known.
  double hand_epsilon = std::numeric_limits<double>::quiet_NaN();
};

/// A load over several grasps: the largest, whichever grasp withstands it.
struct LoadFound {
  double most = std::numeric_limits<double>::quiet_NaN();  // as BestGrasp; NaN: none is known
  int known = 0;                                           // grasps that it is known of
  int of = 0;                                              // grasps that were asked
};

/// One hand on one object.
struct HandOnObject {
  std::string hand, object;
  double scale = 1;  // of the object: 1 without normalise_size
  int approaches = 0;
  std::array<int, 6> outcomes{};      // by GraspOutcome
  int closures = 0;                   // force closure, certified
  double success = 0;                 // closures by approaches [1]
  ConfidenceInterval interval{0, 1};  // of its probability, Wilson, 95 %
  Eigen::VectorXd epsilon;            // of all closures, ascending [unit forces]
  Eigen::VectorXd hand_epsilon;       // of those where it is known, ascending [N]
  std::map<std::string, int> types;   // of grasp_type() -> closures
  std::vector<BestGrasp> best;        // best first
  double seconds = 0;                 // wall time

  /// Margins of a task over `best`. Force closure has none: it is `success`.
  [[nodiscard]] LoadFound load(GraspTask task) const;

  /// Epsilon of the hand over all closures.
  [[nodiscard]] LoadFound best_hand_epsilon() const;

  /// Least `hold` of `best`; NaN if there is none [N].
  [[nodiscard]] double min_grasp_force() const;

  /// Of epsilon by linear interpolation; NaN without closures. @param p  in [0, 1]
  [[nodiscard]] double quantile(double p) const;
};

/// What one digit can do.
struct DigitAbility {
  std::string digit;
  int dimension = 0;           // in which its tip moves: 0 .. 3
  double workspace = 0;        // [m^dimension]
  double workspace_error = 0;  // half of the cells at its rim [m^dimension]
  double closing_force = 0;    // largest along the tip's way in closing, tip_forces() [N]; NaN:
                               // efforts unknown
  double max_tip_force = 0;    // over 64 directions [N]; NaN: efforts unknown
};

/// What a hand can do without an object.
struct HandAbilities {
  std::string hand;
  double reach = 0;                  // reach_of_digits() [m]
  double opposition = 0;             // 0 .. 10; NaN: not defined
  std::string opposition_scale;      // which scale it is
  std::vector<std::string> reached;  // places, or digits, that are met
  std::vector<DigitAbility> digits;
  double overlap = 0;              // of the workspaces of the opposing digit and all others [m^3]
  std::vector<std::string> types;  // distinct grasp_type() of all closures, alphabetic
};

struct Comparison {
  unsigned seed = 1;
  int approaches = 0;
  bool normalise_size = false;
  std::vector<std::string> hands, objects, tasks;
  std::vector<HandAbilities> abilities;  // of each hand that is finished
  std::vector<HandOnObject> cells;       // hand by hand, the objects of each in order
  std::vector<std::string> warnings;
  bool complete = false;  // false: stopped; `cells` are whole as far as they go
};

/// How far the tips of an open hand are from its point of approach, at most [m].
[[nodiscard]] double reach_of_digits(const Hand& hand);

/// The object, larger or smaller, of the same density. @param scale  > 0
[[nodiscard]] BodySpec scaled(BodySpec body, double scale);

}  // namespace thenar
