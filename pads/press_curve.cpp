#include "pads/press_curve.h"

#include <cmath>
#include <memory>

#include "base/error.h"
#include "pads/contact_area.h"
#include "pads/pad_press.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

constexpr int kMaxCurveHalvings = 10;  // nested halvings of a step
// First depth of a press to a force over the pad's height [1]
constexpr double kFirstDepthRatio = 0.005;
// Depth within which an object must touch [m]
constexpr double kMaxTouchDepth = 3e-3;

/// A pad with its present state.
struct TrackedPad {
  TrackedPad(const PadModel& pad, const PressCourse& course)
      : press(pad, course.object, course.X_PO, {}), tissues(pad.tissues) {
    (void)press.touch(course.along);
    state = press.state();
    first_touch = state.X_PO.p;
    skin = skin_nodes(press.mesh());
  }
  PadPress press;  // mesh, body and surface; its own state is not used
  std::vector<Tissue> tissues;
  std::vector<bool> skin;  // nodes of the mesh
  PressState state;
  Vector3d first_touch;  // position of the object at first touch [m] (3)
};

/// Press of several pads along one course.
class CurvePresser {
 public:
  CurvePresser(const std::vector<PadModel>& pads, const PressCourse& course) : course_(course) {
    for (const PadModel& pad : pads) pads_.push_back(std::make_unique<TrackedPad>(pad, course));
    factors_ = std::make_unique<PressFactors>(pads_[0]->press.body());
    for (const auto& each : pads_)
      require(each->press.body().unknowns() == pads_[0]->press.body().unknowns(),
              "pads that are pressed together need one mesh");
    first_depth_ = kFirstDepthRatio * pads[0].shape.height;
  }

  /// Presses up to a load.
  /// @return empty, or the reason of the failure
  std::string press_to(const PressLoad& load) {
    // A force needs a contact: press by increasing depths until the first pad touches.
    double depth = first_depth_;
    while (load.force && pads_[0]->state.push.force.isZero(0) && depth < kMaxTouchDepth) {
      std::string error = step({{}, depth, 0}, 0);
      if (!error.empty()) return error;
      depth *= 2;
    }
    return step(load, 0);
  }

  [[nodiscard]] PressPoint press_point(std::size_t pad) const {
    const TrackedPad& p = *pads_[pad];
    return {indentation(p), course_.along.dot(p.state.push.force),
            contact_area(p.press.mesh(), p.press.body(), p.tissues, p.skin, p.press.surface(),
                         course_.object, p.state)};
  }
  [[nodiscard]] std::size_t pads() const { return pads_.size(); }
  [[nodiscard]] int iterations() const { return iterations_; }

 private:
  [[nodiscard]] double indentation(const TrackedPad& p) const {
    return course_.along.dot(p.state.X_PO.p - p.first_touch);
  }

  /// Presses all pads to a load. @return empty, or the reason of the failure
  std::string step(const PressLoad& load, int cuts) {
    // Solve the first pad, then its neighbours.
    TrackedPad& first = *pads_[0];
    const double before = indentation(first), push = course_.along.dot(first.state.push.force);
    PressState next = first.state;
    const PressOutcome out = solve(first, load, load.force ? before : load.indentation, next);
    if (out.status == Status::kSolved) {
      std::string error = solve_neighbours(load, next);
      if (error.empty()) first.state = std::move(next);
      return error;
    }
    if (cuts >= kMaxCurveHalvings) return out.message;
    // Solve the two halves of the step.
    PressLoad half = load, rest = load;
    half.time = rest.time = load.time / 2;
    if (load.force)
      half.force = 0.5 * (*load.force + push);
    else
      half.indentation = 0.5 * (load.indentation + before);
    std::string error = step(half, cuts + 1);
    return error.empty() ? step(rest, cuts + 1) : error;
  }

  /// Solves the other pads from the solution of the first one.
  /// @return empty, or the reason of the failure
  std::string solve_neighbours(const PressLoad& load, const PressState& answer) {
    // Each pad keeps its own history of relaxation and friction.
    const double at = course_.along.dot(answer.X_PO.p - pads_[0]->first_touch);
    for (std::size_t k = 1; k < pads_.size(); ++k) {
      TrackedPad& pad = *pads_[k];
      PressState next = answer;
      next.history = pad.state.history;
      next.anchor = pad.state.anchor;
      next.friction_force = pad.state.friction_force;
      const PressOutcome out = solve(pad, load, at, next);
      if (out.status != Status::kSolved) return "a neighbour: " + out.message;
      pad.state = std::move(next);
    }
    return "";
  }

  /// Solves one step of a pad.
  /// @param from  indentation of the object, or from which it seeks a force [m]
  PressOutcome solve(TrackedPad& pad, const PressLoad& load, double from, PressState& state) {
    PressGoal goal;
    goal.X_PO = course_.X_PO;
    goal.X_PO.p = pad.first_touch + from * course_.along;
    goal.along = course_.along;
    goal.force = load.force;
    goal.time = load.time;
    PressOutcome out = press_step(pad.press.body(), pad.press.surface(), course_.object, goal, {},
                                  *factors_, state);
    iterations_ += out.iterations;
    return out;
  }

  const PressCourse& course_;
  std::vector<std::unique_ptr<TrackedPad>> pads_;
  std::unique_ptr<PressFactors> factors_;
  double first_depth_ = 0;  // [m]
  int iterations_ = 0;
};

std::string name_of(const PressLoad& load) {
  return load.force ? fmt::format("{:g} N", *load.force)
                    : fmt::format("{:g} mm", load.indentation * 1e3);
}

void check_course(const PressCourse& course) {
  require(std::abs(course.along.norm() - 1) < 1e-9,
          "the direction of a press is not a unit vector");
  for (const PressLoad& load : course.loads) {
    require(!load.force || (*load.force > 0 && std::isfinite(*load.force)),
            "a force of a press must be above 0, got {} N", load.force.value_or(0));
    require(load.force || (load.indentation > 0 && std::isfinite(load.indentation)),
            "an indentation must be above 0, got {} m", load.indentation);
    require(load.time >= 0, "a load takes 0 s or more, got {} s", load.time);
  }
}

}  // namespace

PressCurves press_curves(const std::vector<PadModel>& pads, const PressCourse& course,
                         const Progress& progress) {
  require(!pads.empty(), "a course needs a pad to press");
  check_course(course);
  CurvePresser presser(pads, course);
  PressCurves out;
  out.points.resize(pads.size());
  // Press to each load, until a stop or a failure.
  for (std::size_t i = 0; i < course.loads.size(); ++i) {
    if (progress.stop()) {
      out.status = Status::kStopped;
      break;
    }
    progress(static_cast<double>(i) / static_cast<double>(course.loads.size()),
             name_of(course.loads[i]));
    const std::string error = presser.press_to(course.loads[i]);
    if (!error.empty()) {
      out.status = Status::kStalled;
      out.message = fmt::format("at {}: {}", name_of(course.loads[i]), error);
      break;
    }
    for (std::size_t pad = 0; pad < pads.size(); ++pad)
      out.points[pad].push_back(presser.press_point(pad));
  }
  out.iterations = presser.iterations();
  return out;
}

}  // namespace thenar
