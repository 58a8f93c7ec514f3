#include "pads/press_curve.h"

#include <cmath>
#include <memory>

#include "base/error.h"
#include "pads/contact_area.h"
#include "pads/pad_press.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

constexpr int kMaxHalvings = 10;  // Most halvings of a step
// First depth of a press to a force, over the pad's height [1]
constexpr double kFirstTouch = 0.005;
// An object that has not touched within this depth passes the pad by [m]
constexpr double kDeepestTouch = 3e-3;

/// A pad on its way.
struct PadTrack {
  PadTrack(const PadModel& pad, const PressCourse& course)
      : press(pad, course.object, course.X_PO, {}), tissues(pad.tissues) {
    (void)press.touch(course.along);
    state = press.state();
    touched = state.X_PO.p;
    skin = skin_nodes(press.mesh());
  }
  PadPress press;  // mesh, body and surface; the state is ours
  std::vector<Tissue> tissues;
  std::vector<bool> skin;  // nodes of the mesh
  PressState state;
  Vector3d touched;  // the object's place at first touch [m] (3)
};

class CurveWalk {
 public:
  CurveWalk(const std::vector<PadModel>& pads, const PressCourse& course) : course_(course) {
    for (const PadModel& pad : pads) pads_.push_back(std::make_unique<PadTrack>(pad, course));
    factors_ = std::make_unique<PressFactors>(pads_[0]->press.body());
    for (const auto& each : pads_)
      require(each->press.body().unknowns() == pads_[0]->press.body().unknowns(),
              "pads that are pressed together need one mesh");
    first_touch_ = kFirstTouch * pads[0].shape.height;
  }

  /// Presses up to a load.
  /// @return empty, or the reason of the failure
  std::string go_to(const PressLoad& load) {
    // A force needs something to act on: press until the first pad touches.
    double depth = first_touch_;
    while (load.force && pads_[0]->state.push.force.isZero(0) && depth < kDeepestTouch) {
      std::string failed = step({{}, depth, 0}, 0);
      if (!failed.empty()) return failed;
      depth *= 2;
    }
    return step(load, 0);
  }

  [[nodiscard]] PressPoint point(std::size_t pad) const {
    const PadTrack& p = *pads_[pad];
    return {indentation(p), course_.along.dot(p.state.push.force),
            contact_area(p.press.mesh(), p.press.body(), p.tissues, p.skin, p.press.surface(),
                         course_.object, p.state)};
  }
  [[nodiscard]] std::size_t pads() const { return pads_.size(); }
  [[nodiscard]] int iterations() const { return iterations_; }

 private:
  [[nodiscard]] double indentation(const PadTrack& p) const {
    return course_.along.dot(p.state.X_PO.p - p.touched);
  }

  std::string step(const PressLoad& load, int cuts) {
    // Step to the load, the others after the first.
    PadTrack& first = *pads_[0];
    const double before = indentation(first), push = course_.along.dot(first.state.push.force);
    PressState next = first.state;
    const PressOutcome out = solve(first, load, load.force ? before : load.indentation, next);
    if (out.status == Status::kSolved) {
      std::string failed = follow(load, next);
      if (failed.empty()) first.state = std::move(next);
      return failed;
    }
    if (cuts >= kMaxHalvings) return out.message;
    // Half of the way first.
    PressLoad half = load, rest = load;
    half.time = rest.time = load.time / 2;
    if (load.force)
      half.force = 0.5 * (*load.force + push);
    else
      half.indentation = 0.5 * (load.indentation + before);
    std::string failed = step(half, cuts + 1);
    return failed.empty() ? step(rest, cuts + 1) : failed;
  }

  /// The other pads, from the answer of the first but with their own past.
  std::string follow(const PressLoad& load, const PressState& answer) {
    // Each goes from the first one's answer, but relaxes and rubs from its own past.
    const double at = course_.along.dot(answer.X_PO.p - pads_[0]->touched);
    for (std::size_t k = 1; k < pads_.size(); ++k) {
      PadTrack& pad = *pads_[k];
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

  /// @param from  indentation at which the object is, or from where it seeks a force [m]
  PressOutcome solve(PadTrack& pad, const PressLoad& load, double from, PressState& state) {
    PressGoal goal;
    goal.X_PO = course_.X_PO;
    goal.X_PO.p = pad.touched + from * course_.along;
    goal.along = course_.along;
    goal.force = load.force;
    goal.time = load.time;
    PressOutcome out = press_step(pad.press.body(), pad.press.surface(), course_.object, goal, {},
                                  *factors_, state);
    iterations_ += out.iterations;
    return out;
  }

  const PressCourse& course_;
  std::vector<std::unique_ptr<PadTrack>> pads_;
  std::unique_ptr<PressFactors> factors_;
  double first_touch_ = 0;  // [m]
  int iterations_ = 0;
};

std::string name_of(const PressLoad& load) {
  return load.force ? fmt::format("{:g} N", *load.force)
                    : fmt::format("{:g} mm", load.indentation * 1e3);
}

void check_course(const PressCourse& course) {
  require(std::abs(course.along.norm() - 1) < 1e-9, "the direction of a press is no unit vector");
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
  CurveWalk walk(pads, course);
  PressCurves out;
  out.points.resize(pads.size());
  // Load by load, until a stop or a failure.
  for (std::size_t i = 0; i < course.loads.size(); ++i) {
    if (progress.stop()) {
      out.status = Status::kStopped;
      break;
    }
    progress(static_cast<double>(i) / static_cast<double>(course.loads.size()),
             name_of(course.loads[i]));
    const std::string failed = walk.go_to(course.loads[i]);
    if (!failed.empty()) {
      out.status = Status::kStalled;
      out.message = fmt::format("at {}: {}", name_of(course.loads[i]), failed);
      break;
    }
    for (std::size_t pad = 0; pad < pads.size(); ++pad) out.points[pad].push_back(walk.point(pad));
  }
  out.iterations = walk.iterations();
  return out;
}

}  // namespace thenar
