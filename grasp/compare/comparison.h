#pragma once

/// Input and output of comparing hands on the same objects by the same approaches.

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

/// A named place on a hand, in the reference posture.
struct HandPlace {
  std::string name;
  int link = -1;               // link of the place; -1: the base
  Eigen::Vector3d p{0, 0, 0};  // hand frame [m] (3)
  int score = 0;               // in Kapandji's scale, if it belongs to it
};

/// A hand to be compared.
struct ComparedHand {
  std::string name;
  std::shared_ptr<const Hand> hand;
  ContactModel contact = ContactModel::kHardPoint;  // or soft fingers
  ClosingRates rates;                               // as CloseOptions::rates
  HandPlace thumb;                                  // pad of the thumb, if there are `places`
  std::vector<HandPlace> places;                    // Kapandji's; empty: an analogous scale is used
  std::vector<std::string> warnings;
};

/// Task of a grasp, measured with the actuation of the hand.
enum class GraspTask {
  kForceClosure,  // [1] no load: the share of approaches that reach it
  kHoldWeight,    // [1] load in units of the object's weight, along each of its axes both ways
  kPull,          // [N] along its z axis, either way
  kTurn           // [N m] about its z axis, either way
};
inline constexpr std::array kGraspTaskNames{EnumName{GraspTask::kForceClosure, "force-closure"},
                                            EnumName{GraspTask::kHoldWeight, "hold-weight"},
                                            EnumName{GraspTask::kPull, "pull"},
                                            EnumName{GraspTask::kTurn, "turn"}};
[[nodiscard]] inline std::string name_of(GraspTask task) { return name_in(kGraspTaskNames, task); }
/// @throws InputError listing the names.
[[nodiscard]] inline GraspTask grasp_task(const std::string& name) {
  return value_in(kGraspTaskNames, name, "task");
}

/// A task with the unit of its load, as columns and members are called: "hold_weights", "pull_N",
/// "turn_Nm"; "force_closure" has none.
[[nodiscard]] std::string load_key(GraspTask task);

/// Returns the key of a task's load with rigid structure: "hold_with_structure_weights".
[[nodiscard]] std::string structure_key(GraspTask task);

struct Comparison;

/// Settings of compare().
struct CompareOptions {
  int approaches = 20;          // of every hand to every object
  unsigned seed = 1;            //
  int threads = 1;              // 0: as many as there are processors
  int best = 3;                 // number of grasps of each hand and object whose loads are computed
  bool normalise_size = false;  // objects scaled by reach_of_digits() over the first hand's
  std::vector<GraspTask> tasks{GraspTask::kForceClosure, GraspTask::kHoldWeight};
  int workspace_draws = 150000;                 // postures
  double workspace_voxel = 5e-3;                // [m]
  GraspOptions grasp;                           // `way` is set for each approach
  std::function<void(const Comparison&)> keep;  // called after every finished cell
  Materials materials = built_in_materials();   // and friction of all hands and objects
};

/// One of the best grasps of a hand on an object.
struct BestGrasp {
  int approach = 0;   // its number
  Pose<double> X_WH;  // final pose of the hand; the object stands at the world's origin
  Eigen::VectorXd q;  // (coordinates)
  std::vector<HandContact> contacts;     // in the object's frame
  double epsilon = 0;                    // certified lower bound [unit forces]
  std::string type;                      // grasp_type()
  double min_grasp_force = 0;            // smallest sum of normal forces that holds the weight,
                                         // whichever axis points down, by friction alone [N];
                                         // infinite: impossible
  double standing_grasp_force = 0;       // the same as the object stands, z up [N]; NaN: not known
  std::map<std::string, double> margin;  // task -> largest load that efforts and friction resist;
                                         // units as GraspTask; NaN: unknown
  std::map<std::string, double> with_structure;  // the same with the hand's rigid structure, whose
                                                 // strength no source states; infinite: no effort
                                                 // is needed
  std::map<std::string, std::string> reasons;  // task or "epsilon" -> why zero, unknown or infinite
  /// Smallest wrench that the actuation of the hand cannot resist [N]; NaN: unknown.
  double hand_epsilon = std::numeric_limits<double>::quiet_NaN();
};

/// The largest load over several grasps.
struct LoadFound {
  double max = std::numeric_limits<double>::quiet_NaN();  // as BestGrasp; NaN: unknown for all
  int known = 0;                                          // number of grasps for which it is known
  int asked = 0;                                          // number of grasps asked
};

/// One hand on one object.
struct HandOnObject {
  std::string hand, object;
  double scale = 1;  // of the object: 1 without normalise_size
  int approaches = 0;
  std::array<int, 6> outcomes{};      // number of approaches by GraspOutcome
  int closures = 0;                   // number with certified force closure
  int between_two = 0;                // number without, held between two hard points
  double success = 0;                 // closures by approaches [1]
  ConfidenceInterval interval{0, 1};  // of the probability of success, Wilson, 95 %
  Eigen::VectorXd epsilon;            // of all closures, ascending [unit forces]
  Eigen::VectorXd hand_epsilon;       // of closures for which it is known, ascending [N]
  std::map<std::string, int> types;   // grasp_type() -> number of closures
  std::vector<BestGrasp> best;        // best first
  double seconds = 0;                 // of all its pieces, one after the other

  /// Margin of a task over `best`, and the same with structure. Force closure has none: see
  /// `success`.
  [[nodiscard]] LoadFound load(GraspTask task) const;
  [[nodiscard]] LoadFound load_with_structure(GraspTask task) const;

  /// Epsilon of the hand over all closures.
  [[nodiscard]] LoadFound best_hand_epsilon() const;

  /// Least `min_grasp_force` of `best`; NaN without grasps [N].
  [[nodiscard]] double min_grasp_force() const;

  /// Least `standing_grasp_force` of `best`; NaN without grasps [N].
  [[nodiscard]] double standing_grasp_force() const;

  /// Quantile of epsilon by linear interpolation; NaN without closures. @param p  in [0, 1]
  [[nodiscard]] double quantile(double p) const;
};

/// Abilities of one digit.
struct DigitAbility {
  std::string digit;
  int dimension = 0;           // of the motion of its tip: 0 .. 3
  double workspace = 0;        // [m^dimension]
  double workspace_error = 0;  // half of the voxels at its rim [m^dimension]
  double closing_force = 0;  // largest along the tip's direction in closing, tip_forces() [N]; NaN:
                             // efforts unknown
  double max_tip_force = 0;  // over 64 directions [N]; NaN: efforts unknown
};

/// Abilities of a hand without an object.
struct HandAbilities {
  std::string hand;
  double reach = 0;                  // reach_of_digits() [m]
  double opposition = 0;             // 0 .. 10; NaN: not defined
  std::string opposition_scale;      // name of the scale
  std::vector<std::string> reached;  // places or digits that the thumb meets
  std::vector<DigitAbility> digits;
  double overlap = 0;              // of the workspaces of the opposing digit and all others [m^3]
  std::vector<std::string> types;  // distinct grasp_type() of all closures, in alphabetic order
};

/// Returns whether opposition is Kapandji's score of a human thumb; otherwise it is the share of
/// tips that a thumb meets, times 10.
[[nodiscard]] bool is_kapandji(const HandAbilities& abilities);

/// Counts the types of grasp that a hand has taken. There is no count for a hand that pinched
/// nowhere: its starts offered it no pinch, so a count would describe the starts, not the hand.
[[nodiscard]] std::optional<std::size_t> count_grasp_types(const HandAbilities& abilities);

/// Result of compare().
struct Comparison {
  unsigned seed = 1;
  int approaches = 0;
  bool normalise_size = false;
  std::vector<std::string> hands, objects, tasks;
  std::vector<HandAbilities> abilities;  // of each finished hand
  std::vector<HandOnObject> cells;       // hand by hand, the objects of each in order
  std::vector<std::string> warnings;
  bool complete = false;  // false: stopped; `cells` are whole as far as they go
};

/// Largest distance of the tips of an open hand from its point of approach [m].
[[nodiscard]] double reach_of_digits(const Hand& hand);

/// The object scaled at the same density. @param scale  > 0 [1]
[[nodiscard]] BodySpec scaled(BodySpec body, double scale);

}  // namespace thenar
