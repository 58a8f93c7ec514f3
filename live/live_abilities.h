#pragma once

/// Interfaces of abilities that some live models have: editing, saving, moving in time. Servers use
/// them without knowing the type of the model.

#include <optional>
#include <string>

namespace thenar {

/// State of an edited model: its file, and the edits that undo() and redo() would change.
struct LiveEditState {
  std::string name;                 // of the world
  std::string file;                 // it was loaded from or saved to; empty: none
  bool unsaved = false;             // edited since
  std::optional<std::string> undo;  // what undo() takes back: "move mug"; none: nothing is left
  std::optional<std::string> redo;  // what redo() does again
};

/// A model that is edited, as a world is.
class LiveEdits {
 public:
  virtual ~LiveEdits() = default;
  [[nodiscard]] virtual LiveEditState edit_state() const = 0;
  /// Takes the last edit back. @returns what it was: "move mug"
  /// @throws InputError if nothing is left to undo.
  virtual std::string undo() = 0;
  /// Repeats the edit that was undone last. @returns what it was
  /// @throws InputError if nothing is left to redo.
  virtual std::string redo() = 0;
};

/// Time of a model, and the settings of play.
struct LiveTime {
  double t = 0;                    // [s]
  double step = 1e-3;              // that one step of `motion.step` takes [s]
  bool playing = false;            // whether it goes on by itself
  double speed = 1;                // of play, 1: real time [1]
  std::optional<double> duration;  // where play pauses, once: of a scene or recorded run; none: it
                                   // has no end [s]
  bool recorded = false;           // a run that is shown again
};

/// A model that moves by itself. While it plays, the server asks for `motion.step` with as many
/// steps as wall-clock time wants: speed / step of them a second. A model that comes to its end
/// stops playing.
class LiveClock {
 public:
  virtual ~LiveClock() = default;
  [[nodiscard]] virtual LiveTime live_time() const = 0;
  /// Goes on no longer by itself.
  virtual void pause() = 0;
};

}  // namespace thenar
