#pragma once

/// Evaluation of one hand on one object, in tasks that several threads can share.

#include <atomic>
#include <memory>
#include <mutex>
#include <vector>

#include "base/task_queue.h"
#include "grasp/closing/collision_hand.h"
#include "grasp/closing/setup.h"
#include "grasp/compare/comparison.h"

namespace thenar {

/// An object to grasp, built on first use.
class LazyObject {
 public:
  /// @param scale  scale of the object [1]
  LazyObject(const BodySpec& object, double scale, const Materials& materials)
      : object_(object), scale_(scale), materials_(materials) {}

  /// Returns the object alone in the world.
  [[nodiscard]] const GraspSetup& setup();
  /// Returns the object's mass [kg].
  [[nodiscard]] double mass();
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

/// A compared hand with its collision model, built on first use.
class LazyCollisionHand {
 public:
  LazyCollisionHand(const ComparedHand& hand, const Materials& materials)
      : hand_(hand), materials_(materials) {}

  [[nodiscard]] const ComparedHand& hand() const { return hand_; }
  [[nodiscard]] const CollisionHand& surfaces();

 private:
  const ComparedHand& hand_;
  const Materials& materials_;
  std::once_flag built_;
  std::unique_ptr<CollisionHand> surfaces_;
};

/// Evaluation of a hand on an object: one task for each approach and, when all are done, one for
/// the loads of each of the best grasps. All arguments must outlive it.
class CellWork {
 public:
  CellWork(LazyCollisionHand& hand, LazyObject& object, const CompareOptions& options,
           const Progress& progress);

  /// Adds its approaches to a queue; tasks that follow from them precede all waiting ones.
  void add_to(TaskQueue& queue);
  /// Returns the number of finished approaches.
  [[nodiscard]] int tried() const { return tried_count_; }
  /// Returns whether all tasks are finished; never true after a stop.
  [[nodiscard]] bool done() const { return done_; }
  /// Moves the result out, once all tasks are finished.
  [[nodiscard]] HandOnObject take_result() { return std::move(cell_); }

 private:
  /// An approach and the epsilon that the hand's own efforts give it.
  struct Tried {
    Grasp grasp;
    double hand_epsilon = std::numeric_limits<double>::quiet_NaN();  // of closures [N]
    std::string message;                                             // why it is 0 or unknown
    [[nodiscard]] bool closes() const;
  };

  void run_approach(int number, TaskQueue& queue);
  void rank_grasps(TaskQueue& queue);
  void compute_loads(std::size_t rank, int number);
  [[nodiscard]] Grasp make_grasp(int number);
  void add_time(double seconds);

  LazyCollisionHand& hand_;
  LazyObject& object_;
  const CompareOptions& options_;
  const Progress& progress_;
  std::vector<Tried> tried_;         // results of the approaches, by number
  std::atomic<int> tried_count_{0};  // number of finished approaches
  std::atomic<int> pending_{0};      // unfinished approaches, then unfinished load tasks
  std::atomic<bool> done_{false};
  std::mutex timing_;
  HandOnObject cell_;
};

}  // namespace thenar
