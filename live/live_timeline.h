#pragma once

/// Interface of live models with a time axis, simulated or recorded: clients step them, play them,
/// seek in time and query their state.

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

/// Selection of the parts of a TimelineState.
struct MotionParts {
  bool joints = false, bodies = false, contacts = false, energy = false, muscles = false;
};

/// State of a coordinate at an instant.
struct CoordinateState {
  std::string name;
  double value = 0;              // [rad] or [m]
  double rate = 0;               // [rad/s] or [m/s]
  std::optional<double> effort;  // effort of its drives or input; absent: not recorded [N m], [N]
};

/// State of a moving body at an instant.
struct BodyState {
  std::string name;
  Pose<double> X_WB;
  SceneVelocity velocity;  // velocity of its centre of mass
};

/// Energies of a scene, and their balance since the start.
struct MotionEnergy {
  double kinetic = 0, weight = 0, springs = 0;  // parts of the energy; NaN: not recorded [J]
  std::optional<FlowBalance> balance;           // energy balance; absent: not recorded
  double total = 0;                             // sum of the parts [J]
};

/// State of a motion at the instant that is shown; parts that were not selected are empty.
struct TimelineState {
  double t = 0;  // time [s]
  std::vector<CoordinateState> joints;
  std::vector<BodyState> bodies;
  std::vector<ContactSample> contacts;
  std::vector<std::string> body_names;  // names of the bodies that contacts refer to by index
  std::optional<MotionEnergy> energy;
  std::vector<ElementValue> muscles;  // tensions and activations
};

/// Accuracy of the steps: unsolved contact problems, residuals and penetration.
struct MotionQuality {
  long steps = 0;             // number of steps
  long unsolved = 0;          // contact problems that missed their tolerance
  double worst_residual = 0;  // largest residual of a contact problem [1]
  double deepest = 0;         // largest penetration [m]
  long leaps = 0;  // steps in which surfaces moved so far that they may have passed through each
                   // other: SceneCost::tunnelling_steps
  std::optional<FlowBalance>
      balance;                      // energy balance from the start to the instant that is shown;
                                    // for a recorded run worst_balance(); absent: not recorded
  std::vector<PassedLimit> limits;  // joint limits that were exceeded
  double restitution = 0;           // largest restitution in the scene, which the steps ignore [1]
};

/// Live model with a time axis.
class LiveTimeline : public LiveModel, public LiveClock {
 public:
  /// Takes `count` steps of size live_time().step, fewer if it is stopped or fails.
  /// @return quality of the steps that were taken
  virtual MotionQuality step(long count, const Progress& progress) = 0;
  /// Shows the instant nearest to t. @param t  time [s]  @return time of that instant [s]
  virtual double seek(double t) = 0;
  /// Returns to the start and stops playing.
  virtual void reset() = 0;
  [[nodiscard]] virtual TimelineState state(const MotionParts& parts) const = 0;
  /// Returns the quality of all steps since the start or the last reset, or as it was recorded.
  [[nodiscard]] virtual MotionQuality quality() const = 0;
  /// Returns the assumptions of the motion.
  [[nodiscard]] virtual std::vector<std::string> warnings() const = 0;
  [[nodiscard]] virtual const std::string& name() const = 0;

  /// Starts playing. @param speed  playback speed over real time, > 0 [1]
  /// @throws InputError if the speed is not positive
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
