#pragma once

/// Interfaces that some live models implement: editing, moving in time. A server uses them without
/// knowing the type of the model.

#include <optional>
#include <string>

namespace thenar {

/// State of an edited model: its file, and the edits that undo() and redo() would apply to.
struct LiveEditState {
  std::string name;                 // name of the model
  std::string file;                 // file it was loaded from or saved to; empty: none
  bool unsaved = false;             // true: it has edits that are not in the file
  std::optional<std::string> undo;  // edit that undo() reverts, "move mug"; absent: none
  std::optional<std::string> redo;  // edit that redo() repeats; absent: none
};

/// Model with edits that can be undone, such as a world.
class LiveEdits {
 public:
  virtual ~LiveEdits() = default;
  [[nodiscard]] virtual LiveEditState edit_state() const = 0;
  /// Reverts the last edit. @return description of the edit, "move mug"
  /// @throws InputError if there is nothing to undo
  virtual std::string undo() = 0;
  /// Repeats the edit that was undone last. @return description of the edit
  /// @throws InputError if there is nothing to redo
  virtual std::string redo() = 0;
};

/// Time of a model, and the settings of its playback.
struct LiveTime {
  double t = 0;                    // time of the instant that is shown [s]
  double step = 1e-3;              // step size of `motion.step` [s]
  bool playing = false;            // true: the server advances time
  double speed = 1;                // playback speed over real time [1]
  std::optional<double> duration;  // time at which playback pauses, once; absent: no end [s]
  bool recorded = false;           // true: a recorded run, false: a simulation
};

/// Model that moves in time. While it plays, the server calls `motion.step` with speed / step steps
/// per second of wall-clock time. A model that reaches its end stops playing.
class LiveClock {
 public:
  virtual ~LiveClock() = default;
  [[nodiscard]] virtual LiveTime live_time() const = 0;
  /// Stops playing.
  virtual void pause() = 0;
};

}  // namespace thenar
