#include "grasp/compare/cell_work.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "data/io/world/world.h"
#include "grasp/closing/describe_grasp.h"
#include "grasp/compare/grasp_loads.h"
#include "grasp/compare/grasp_type.h"
#include "grasp/compare/pregrasp.h"

namespace thenar {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Describes how a hand holds an object.
HeldObject held_by(const ComparedHand& hand, const Grasp& grasp, const GraspBody& object) {
  return {*hand.hand, grasp.closed.q, grasp.contacts,
          grasp.approached.X_WH.inverse() * object.X_WB};
}

Eigen::VectorXd ascending(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

}  // namespace

void LazyObject::build() {
  std::call_once(built_, [&] {
    PlacedBody placed;
    placed.body = scaled(object_, scale_);
    const BodyMass mass = body_mass(placed.body, materials_);
    placed.body.mass = mass;
    mass_ = mass.mass;
    setup_ = std::make_unique<GraspSetup>(GraspSetup{build_body(placed), {}, materials_});
  });
}

const GraspSetup& LazyObject::setup() {
  build();
  return *setup_;
}

double LazyObject::mass() {
  build();
  return mass_;
}

const CollisionHand& LazyCollisionHand::surfaces() {
  std::call_once(built_, [&] {
    surfaces_ = std::make_unique<CollisionHand>(collision_hand(*hand_.hand, materials_));
  });
  return *surfaces_;
}

CellWork::CellWork(LazyCollisionHand& hand, LazyObject& object, const CompareOptions& options,
                   const Progress& progress)
    : hand_(hand), object_(object), options_(options), progress_(progress) {
  cell_.hand = hand.hand().name;
  cell_.object = object.name();
  cell_.scale = object.scale();
}

void CellWork::add_to(TaskQueue& queue) {
  pending_ = options_.approaches;
  tried_.resize(options_.approaches);
  for (int n = 0; n < options_.approaches; ++n)
    queue.add([this, n, &queue] { run_approach(n, queue); });
}

bool CellWork::Tried::closes() const {
  return grasp.outcome == GraspOutcome::kGrasped && grasp.quality.force_closure;
}

Grasp CellWork::make_grasp(int number) {
  // Contact model and closing rates belong to the hand.
  GraspOptions grasping = options_.grasp;
  grasping.pads.contact = hand_.hand().contact;
  grasping.close.rates = hand_.hand().rates;
  const GraspSetup& setup = object_.setup();
  return attempt_grasp(hand_.surfaces(),
                       sample_pregrasp(hand_.surfaces(), setup.object, options_.seed, number),
                       setup, grasping);
}

/// Runs one approach; the last one of all ranks the grasps.
void CellWork::run_approach(int number, TaskQueue& queue) {
  if (progress_.stop()) return;
  const auto start = Clock::now();
  Tried& tried = tried_[number];
  tried.grasp = make_grasp(number);
  if (tried.closes()) {
    if (progress_.stop()) return;
    const GraspBody& object = object_.setup().object;
    ExplainedLoad epsilon = hand_epsilon(held_by(hand_.hand(), tried.grasp, object), object);
    tried.hand_epsilon = epsilon.value;
    tried.message = std::move(epsilon.message);
  }
  add_time(seconds_since(start));
  ++tried_count_;
  if (--pending_ == 0) rank_grasps(queue);
}

/// Counts outcomes, and adds tasks for the loads of the best grasps.
void CellWork::rank_grasps(TaskQueue& queue) {
  std::vector<std::pair<double, int>> closed;
  std::vector<double> epsilon, hand_epsilon;
  for (std::size_t n = 0; n < tried_.size(); ++n) {
    const Tried& tried = tried_[n];
    ++cell_.outcomes[static_cast<std::size_t>(tried.grasp.outcome)];
    if (!tried.closes()) {
      cell_.between_two += is_held_between_two(tried.grasp.contacts) ? 1 : 0;
      continue;
    }
    closed.emplace_back(tried.grasp.quality.lower, static_cast<int>(n));
    epsilon.push_back(tried.grasp.quality.lower);
    if (!std::isnan(tried.hand_epsilon)) hand_epsilon.push_back(tried.hand_epsilon);
    ++cell_.types[grasp_type(*hand_.hand().hand, tried.grasp.contacts)];
  }
  // Sort closures by epsilon.
  std::sort(closed.begin(), closed.end());
  cell_.approaches = options_.approaches;
  cell_.closures = static_cast<int>(closed.size());
  cell_.success = static_cast<double>(cell_.closures) / options_.approaches;
  cell_.interval = wilson_interval(cell_.closures, options_.approaches);
  cell_.epsilon = ascending(std::move(epsilon));
  cell_.hand_epsilon = ascending(std::move(hand_epsilon));
  // Add tasks for the loads of the best ones, the largest epsilon first.
  const int best = std::min(options_.best, cell_.closures);
  cell_.best.resize(best);
  pending_ = best;
  done_ = best == 0;
  for (int i = best; i-- > 0;) {
    const int number = closed[cell_.closures - 1 - i].second;
    queue.add_first([this, i, number] { compute_loads(static_cast<std::size_t>(i), number); });
  }
}

/// Computes the loads that one of the best grasps resists, with reasons for zero or unknown ones.
void CellWork::compute_loads(std::size_t rank, int number) {
  if (progress_.stop()) return;
  const auto start = Clock::now();
  const Tried& tried = tried_[number];
  const Grasp& grasp = tried.grasp;
  BestGrasp& best = cell_.best[rank];
  best.approach = number;
  best.X_WH = grasp.approached.X_WH;
  best.q = grasp.closed.q;
  best.contacts = grasp.contacts;
  best.epsilon = grasp.quality.lower;
  best.type = grasp_type(*hand_.hand().hand, grasp.contacts);
  const GraspBody& object = object_.setup().object;
  static_cast<GraspLoads&>(best) =
      grasp_loads(held_by(hand_.hand(), grasp, object), object, object_.mass(), options_.tasks);
  best.hand_epsilon = tried.hand_epsilon;
  if (!tried.message.empty()) best.reasons["epsilon"] = tried.message;
  add_time(seconds_since(start));
  if (--pending_ > 0) return;
  tried_.clear();
  done_ = true;
}

void CellWork::add_time(double seconds) {
  const std::lock_guard lock(timing_);
  cell_.seconds += seconds;
}

}  // namespace thenar
