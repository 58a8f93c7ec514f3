#pragma once

/// One hand on one object, in pieces that several threads may share.

#include <atomic>
#include <memory>
#include <mutex>
#include <vector>

#include "base/task_queue.h"
#include "grasp/closing/collision_hand.h"
#include "grasp/closing/setup.h"
#include "grasp/compare/comparison.h"

namespace thenar {

/// An object as hands approach it, built when first asked for.
class StandingObject {
 public:
  /// @param scale  of the object [1]
  StandingObject(const BodySpec& object, double scale, const Materials& materials)
      : object_(object), scale_(scale), materials_(materials) {}

  /// Alone in the world, with its mass.
  [[nodiscard]] const GraspSetup& setup();
  [[nodiscard]] double mass();  // [kg]
  [[nodiscard]] double scale() const { return scale_; }
  [[nodiscard]] const std::string& name() const { return object_.name; }

 private:
  void build();

  const BodySpec& object_;
  double scale_;
  const Materials& materials_;
  std::once_flag built_;
  std::unique_ptr<GraspSetup> setup_;
  double mass_ = 0;
};

/// A compared hand with its surfaces for collisions, built when first asked for.
class TouchingHand {
 public:
  TouchingHand(const ComparedHand& hand, const Materials& materials)
      : hand_(hand), materials_(materials) {}

  [[nodiscard]] const ComparedHand& hand() const { return hand_; }
  [[nodiscard]] const CollisionHand& surfaces();

 private:
  const ComparedHand& hand_;
  const Materials& materials_;
  std::once_flag built_;
  std::unique_ptr<CollisionHand> surfaces_;
};

/// The comparison of a hand on an object: a piece for each approach, and when all are done one for
/// the loads of each of the best. All arguments must outlive it.
class CellWork {
 public:
  CellWork(TouchingHand& hand, StandingObject& object, const CompareOptions& options,
           const Progress& progress);

  /// Adds its approaches; what follows from them is added before all that waits.
  void add_to(TaskQueue& queue);
  /// Number of approaches that are done.
  [[nodiscard]] int tried() const { return tried_count_; }
  /// Returns whether all pieces are done; never, where it was stopped.
  [[nodiscard]] bool done() const { return done_; }
  /// The result, when all pieces are done.
  [[nodiscard]] HandOnObject take() { return std::move(cell_); }

 private:
  /// An approach and the epsilon that the hand's own efforts give it.
  struct Tried {
    Grasp grasp;
    double hand_epsilon = std::numeric_limits<double>::quiet_NaN();  // of closures [N]
    std::string message;                                             // why it is 0 or unknown
    [[nodiscard]] bool closes() const;
  };

  void attempt(int number, TaskQueue& queue);
  void rank(TaskQueue& queue);
  void describe(std::size_t place, int number);
  [[nodiscard]] Grasp make_grasp(int number);
  void spent(double seconds);

  TouchingHand& hand_;
  StandingObject& object_;
  const CompareOptions& options_;
  const Progress& progress_;
  std::vector<Tried> tried_;         // by approach
  std::atomic<int> tried_count_{0};  //
  std::atomic<int> left_{0};         // approaches, then loads, that are not done
  std::atomic<bool> done_{false};
  std::mutex timing_;
  HandOnObject cell_;
};

}  // namespace thenar
