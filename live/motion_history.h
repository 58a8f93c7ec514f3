#pragma once

/// The past of a motion, in a bounded room.

#include <deque>

#include "dynamics/stepping/scene_stepper.h"

namespace thenar {

/// An instant of the past.
struct PastInstant {
  SceneInstant at;
  std::vector<ContactSample> pads;  // contacts that elements stood for then
  std::vector<double> readings;     // what elements said of themselves then (readings)
  std::vector<double> efforts;      // of drives, by the inputs of then [N m], [N] (coordinates)
};

/// Limits of the history; older instants are removed.
struct HistoryLimits {
  std::size_t instants = 20000;               // at most
  std::size_t bytes = std::size_t{64} << 20;  // the same
};

/// Instants of a motion by rising time, the newest last. Room of forgotten ones is used again, so
/// that memory stays as it is once the limits are reached.
class MotionHistory {
 public:
  explicit MotionHistory(const HistoryLimits& limits = {}) : limits_(limits) {}

  void add(const PastInstant& instant);
  void clear();
  /// Forgets all instants behind one.
  void cut_behind(std::size_t index);

  [[nodiscard]] std::size_t size() const { return past_.size(); }
  [[nodiscard]] const PastInstant& at(std::size_t index) const { return past_.at(index); }
  /// The instant whose time is nearest to t. @throws InputError if there is none
  [[nodiscard]] std::size_t nearest(double t) const;
  /// Returns the memory of all instants [bytes].
  [[nodiscard]] std::size_t bytes() const { return bytes_; }

 private:
  HistoryLimits limits_;
  std::deque<PastInstant> past_;
  std::size_t bytes_ = 0;
};

}  // namespace thenar
