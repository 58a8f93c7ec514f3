#pragma once

/// History of a motion with bounded memory.

#include <deque>

#include "dynamics/stepping/scene_stepper.h"

namespace thenar {

/// Instant of the history.
struct PastInstant {
  SceneInstant scene;
  std::vector<ContactSample> pads;  // contacts that force elements (soft pads) stood for
  std::vector<double> readings;     // readings of the force elements (readings)
  std::vector<double> efforts;      // efforts of the drives or inputs [N m], [N] (coordinates)
};

/// Limits of the history; the oldest instants are removed first.
struct HistoryLimits {
  std::size_t instants = 20000;               // largest number of instants
  std::size_t bytes = std::size_t{64} << 20;  // largest memory of all instants [bytes]
};

/// Instants of a motion in order of time, the newest last. The memory of removed instants is
/// reused, so that it stays constant once a limit is reached.
class MotionHistory {
 public:
  explicit MotionHistory(const HistoryLimits& limits = {}) : limits_(limits) {}

  void add(const PastInstant& instant);
  void clear();
  /// Removes all instants after the one at `index`.
  void erase_after(std::size_t index);

  [[nodiscard]] std::size_t size() const { return past_.size(); }
  [[nodiscard]] const PastInstant& instant(std::size_t index) const { return past_.at(index); }
  /// Returns the index of the instant nearest to time t [s]. @throws InputError if there is none
  [[nodiscard]] std::size_t nearest_index(double t) const;
  /// Returns the memory of all instants [bytes].
  [[nodiscard]] std::size_t bytes() const { return bytes_; }

 private:
  HistoryLimits limits_;
  std::deque<PastInstant> past_;
  std::size_t bytes_ = 0;
};

}  // namespace thenar
