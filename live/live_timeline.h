#pragma once

/// Interface of live models with a time axis, simulated or recorded: clients step them, play them,
/// turn them back and ask for their state.

#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/progress.h"
#include "dynamics/scene/measure_run.h"
#include "dynamics/stepping/limit_excess.h"
#include "live/live_abilities.h"
#include "live/live_picture.h"

namespace thenar {

/// Parts of a state that are asked for.
struct MotionParts {
  bool joints = false, bodies = false, contacts = false, energy = false, muscles = false;
};

/// A coordinate at an instant.
struct CoordinateState {
  std::string name;
  double value = 0;              // [rad] or [m]
  double rate = 0;               // [rad/s] or [m/s]
  std::optional<double> effort;  // of its drives or its input [N m] or [N]; nothing: not recorded
};

/// A body that moves, at an instant.
struct BodyState {
  std::string name;
  Pose<double> X_WB;
  SceneVelocity velocity;  // of its centre of mass
};

/// Energies of a scene, and what became of them since the start.
struct MotionEnergy {
  double kinetic = 0, weight = 0, springs = 0;  // NaN: not known one by one [J]
  std::optional<FlowBalance> balance;           // nothing: not recorded
  double total = 0;                             // [J]
};

/// A motion at the instant that is shown; of what was not asked for, nothing.
struct TimelineState {
  double t = 0;  // [s]
  std::vector<CoordinateState> joints;
  std::vector<BodyState> bodies;
  std::vector<ContactSample> contacts;
  std::vector<std::string> body_names;  // by which contacts number them
  std::optional<MotionEnergy> energy;
  std::vector<ElementValue> muscles;  // tensions and activations
};

/// Accuracy of the steps: unsolved contact problems, residuals and penetration.
struct MotionQuality {
  long steps = 0;
  long unsolved = 0;          // contact problems that missed their tolerance
  double worst_residual = 0;  // [1]
  double deepest = 0;         // penetration [m]
  long leaps = 0;  // steps in which surfaces moved so far that they may have gone through
                   // each other: SceneCost::leaps
  std::optional<FlowBalance> balance;  // from the start to the instant that is shown; of a recorded
                                       // run worst_balance(); nothing: not recorded
  std::vector<PassedLimit> limits;     // that joints went beyond
  double restitution = 0;  // the largest one that the scene states and steps leave out [1]
};

/// A model on a line of time.
class LiveTimeline : public LiveModel, public LiveClock {
 public:
  /// Goes on by steps of live_time().step each. @return how they went; stopped, as many as were
  /// made
  virtual MotionQuality step(long count, const Progress& progress) = 0;
  /// Shows the instant nearest to t. @return its time [s]
  virtual double seek(double t) = 0;
  /// Back to the start; pauses.
  virtual void reset() = 0;
  [[nodiscard]] virtual TimelineState state(const MotionParts& parts) const = 0;
  /// Returns the accuracy of all steps since the start or the last reset; of a recorded run, as it
  /// was recorded.
  [[nodiscard]] virtual MotionQuality quality() const = 0;
  /// Returns the assumptions of the motion.
  [[nodiscard]] virtual std::vector<std::string> warnings() const = 0;
  [[nodiscard]] virtual const std::string& name() const = 0;

  /// @param speed  times real time [1]  @throws InputError unless it is above 0
  void play(double speed) {
    require(speed > 0 && speed < 1e6, "wanted a speed above 0, got {}", speed);
    speed_ = speed;
    playing_ = true;
  }
  void pause() override { playing_ = false; }

 protected:
  bool playing_ = false;
  double speed_ = 1;
};

}  // namespace thenar
