#pragma once

/// Settings and results of a comparison of hands by the same approaches to the same objects.

#include <array>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "base/enum_names.h"
#include "base/fidelity.h"
#include "base/progress.h"
#include "data/io/world/world.h"
#include "grasp/closing/grasp.h"
#include "grasp/quality/robustness.h"
#include "hand/hand.h"

namespace thenar {

/// A named landmark of a hand, in the reference posture.
struct HandPlace {
  std::string name;
  int link = -1;               // link that carries it; -1: the base
  Eigen::Vector3d p{0, 0, 0};  // hand frame [m] (3)
  int score = 0;               // score on Kapandji's scale, for its landmarks
};

/// A hand to be compared.
struct ComparedHand {
  std::string name;
  std::shared_ptr<const Hand> hand;
  ContactModel contact = ContactModel::kHardPoint;  // contact model of its surfaces
  ClosingRates rates;                               // closing rates: CloseOptions::rates
  HandPlace thumb;                                  // pad of the thumb, for `places`
  /// Landmarks of Kapandji's scale; empty: an analogous scale is used.
  std::vector<HandPlace> places;
  std::vector<std::string> warnings;
};

/// Task of a grasp, evaluated with the actuation of the hand.
enum class GraspTask {
  kForceClosure,  // [1] no load: share of approaches that reach force closure
  kHoldWeight,    // [1] load over the object's weight, along each of its axes, both ways
  kPull,          // [N] pull along its z axis, both ways
  kTurn           // [N m] torque about its z axis, both ways
};
inline constexpr std::array kGraspTaskNames{EnumName{GraspTask::kForceClosure, "force-closure"},
                                            EnumName{GraspTask::kHoldWeight, "hold-weight"},
                                            EnumName{GraspTask::kPull, "pull"},
                                            EnumName{GraspTask::kTurn, "turn"}};
[[nodiscard]] inline std::string name_of(GraspTask task) { return name_in(kGraspTaskNames, task); }
/// Returns the task of a name. @throws InputError listing the names.
[[nodiscard]] inline GraspTask grasp_task(const std::string& name) {
  return value_in(kGraspTaskNames, name, "task");
}

/// Returns the key of a task's load in tables and files, with its unit: "hold_weights", "pull_N",
/// "turn_Nm"; without one for "force_closure".
[[nodiscard]] std::string load_key(GraspTask task);

/// Returns the key of a task's load that rigid structure helps to support:
/// "hold_with_structure_weights".
[[nodiscard]] std::string structure_key(GraspTask task);

struct Comparison;

/// Settings of compare().
struct CompareOptions {
  int approaches = 20;  // number of approaches of every hand to every object
  unsigned seed = 1;    // seed of all generators
  int threads = 1;      // number of threads; 0: one for each processor
  int best = 3;         // number of grasps of each hand and object for which loads are computed
  /// Scale objects by the ratio of reach_of_digits() to the first hand's.
  bool normalise_size = false;
  std::vector<GraspTask> tasks{GraspTask::kForceClosure, GraspTask::kHoldWeight};
  int workspace_draws = 150000;   // number of sampled postures
  double workspace_voxel = 5e-3;  // edge of a voxel [m]
  GraspOptions grasp;             // settings of every grasp; distances are set for each approach
  std::function<void(const Comparison&)> keep;  // called after every finished cell
  Materials materials = built_in_materials();   // materials and friction of all hands and objects
};

/// Loads that a grasp resists.
struct GraspLoads {
  /// Smallest sum of normal forces that holds the weight by friction alone, for the worst of the
  /// axes pointing down [N]; infinite: impossible.
  double min_grasp_force = 0;
  double standing_grasp_force = 0;       // the same for the object upright, z up [N]; NaN: unknown
  std::map<std::string, double> margin;  // task -> largest load that efforts and friction resist,
                                         // unit as GraspTask; NaN: unknown
  /// Margin with the hand's rigid structure, whose strength no source states; infinite: no effort
  /// is needed.
  std::map<std::string, double> with_structure;
  /// Task or "epsilon" -> reason why it is zero, unknown or infinite.
  std::map<std::string, std::string> reasons;
};

/// One of the best grasps of a hand on an object.
struct BestGrasp : GraspLoads {
  int approach = 0;                   // number of the approach
  Pose<double> X_WH;                  // final pose of the hand; the object is at the world's origin
  Eigen::VectorXd q;                  // (coordinates)
  std::vector<HandContact> contacts;  // in the object's frame
  double epsilon = 0;                 // certified lower bound [unit forces]
  std::string type;                   // grasp_type()
  /// Smallest wrench that the actuation of the hand cannot resist [N]; NaN: unknown.
  double hand_epsilon = std::numeric_limits<double>::quiet_NaN();
};

/// The largest load over several grasps.
struct LoadFound {
  /// Unit as in BestGrasp; NaN: unknown for all.
  double max = std::numeric_limits<double>::quiet_NaN();
  int known = 0;  // number of grasps for which it is known
  int total = 0;  // number of grasps
};

/// Result of one hand on one object.
struct HandOnObject {
  std::string hand, object;
  double scale = 1;  // scale of the object: 1 without normalise_size
  int approaches = 0;
  std::array<int, 6> outcomes{};      // number of approaches by GraspOutcome
  int closures = 0;                   // number of approaches with certified force closure
  int between_two = 0;                // number without, held between two hard points
  double success = 0;                 // closures over approaches [1]
  ConfidenceInterval interval{0, 1};  // Wilson's 95 % interval of the probability of success
  Eigen::VectorXd epsilon;            // of all closures, ascending [unit forces]
  Eigen::VectorXd hand_epsilon;       // of closures for which it is known, ascending [N]
  std::map<std::string, int> types;   // grasp_type() -> number of closures
  std::vector<BestGrasp> best;        // best first
  double seconds = 0;                 // sum of the durations of all tasks [s]

  /// Returns the largest margin of a task over `best`; force closure has none: see `success`.
  [[nodiscard]] LoadFound load(GraspTask task) const;
  /// Returns the largest margin of a task with rigid structure over `best`.
  [[nodiscard]] LoadFound load_with_structure(GraspTask task) const;

  /// Returns the largest epsilon of the hand over all closures.
  [[nodiscard]] LoadFound best_hand_epsilon() const;

  /// Returns the smallest `min_grasp_force` of `best` [N]; NaN without grasps.
  [[nodiscard]] double min_grasp_force() const;

  /// Returns the smallest `standing_grasp_force` of `best` [N]; NaN without grasps.
  [[nodiscard]] double standing_grasp_force() const;

  /// Returns a quantile of epsilon, interpolated linearly; NaN without closures.
  /// @param p  in [0, 1]
  [[nodiscard]] double quantile(double p) const;
};

/// Returns the result of a hand on an object; null: there is none.
[[nodiscard]] const HandOnObject* find_cell(const std::vector<HandOnObject>& cells,
                                            const std::string& hand, const std::string& object);

/// Abilities of one digit.
struct DigitAbility {
  std::string digit;
  int dimension = 0;           // dimension of the tip's motion: 0 .. 3
  double workspace = 0;        // [m^dimension]
  double workspace_error = 0;  // half of the volume of boundary voxels [m^dimension]
  double closing_force = 0;    // maximum force along the tip's direction of closing, tip_forces()
                               // [N]; NaN: efforts unknown
  double max_tip_force = 0;    // maximum force over 64 directions [N]; NaN: efforts unknown
};

/// Abilities of a hand without an object.
struct HandAbilities {
  std::string hand;
  double reach = 0;                  // reach_of_digits() [m]
  double opposition = 0;             // score 0 .. 10; NaN: not defined
  std::string opposition_scale;      // name of the scale
  std::vector<std::string> reached;  // landmarks or digits that the thumb meets
  std::vector<DigitAbility> digits;
  double overlap = 0;  // overlap of the opposing digit's workspace with all others [m^3]
  std::vector<std::string> types;  // distinct grasp_type() of all closures, in alphabetic order
};

/// Returns whether opposition is Kapandji's score of a human thumb; otherwise it is ten times the
/// share of tips that a thumb meets.
[[nodiscard]] bool is_kapandji(const HandAbilities& abilities);

/// Counts the types of grasp that a hand has made. Returns nothing for a hand that made no pinch:
/// its approaches allowed none, so that a count would describe the approaches and not the hand.
[[nodiscard]] std::optional<std::size_t> count_grasp_types(const HandAbilities& abilities);

/// Result of compare().
struct Comparison {
  unsigned seed = 1;
  int approaches = 0;
  bool normalise_size = false;
  std::vector<std::string> hands, objects, tasks;
  std::vector<HandAbilities> abilities;  // abilities of each finished hand
  std::vector<HandOnObject> cells;       // results, hand by hand, with the objects of each in order
  std::vector<std::string> warnings;
  bool complete = false;  // false: stopped early; `cells` holds the finished ones
};

/// Returns the maximum distance of the tips of an open hand from its point of approach [m].
[[nodiscard]] double reach_of_digits(const Hand& hand);

/// Returns the body scaled at the same density. @param scale  > 0 [1]
[[nodiscard]] BodySpec scaled(BodySpec body, double scale);

}  // namespace thenar
