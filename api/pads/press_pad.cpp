#include "api/pads/press_pad.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "base/lists.h"
#include "base/progress_parts.h"
#include "base/thread_seconds.h"
#include "base/units.h"
#include "pads/pad_press.h"

namespace thenar {
namespace {

// Limits of a request, far above those of fingertips: larger numbers are mistakes in units.
constexpr double kMaxPressDepth = 0.1;    // [m]
constexpr double kMaxPressForce = 1e4;    // [N]
constexpr double kMaxPressRate = 100;     // [m/s]
constexpr int kMaxPressPoints = 1000;     // largest number of points of a curve
constexpr int kMaxPadElements = 200'000;  // largest number of elements of a mesh
// Penetration of faces by the object between nodes above which they are refined [m]
constexpr double kMaxFacePenetration = 5e-5;
// Force error above that of any mesh: meshes are not refined [1]
constexpr double kUnrefinedError = 1e9;
// Force error during the first third of the motion, over the requested one [1]
constexpr double kEarlyErrorRatio = 3;
// Exponent n of force ~ depth^n for a sphere on a half space [Johnson1985]
constexpr double kHertzPower = 1.5;
// The two steps that start the prediction of depths have the force over these numbers. By Hertz's
// power they reach 1/16 and 1/9 of the depth: 16^(3/2) = 64, 9^(3/2) = 27 [1]
constexpr double kFirstForceDivisor = 64, kSecondForceDivisor = 27;
// First instant of the hold, over its duration [1]
constexpr double kFirstHoldInstant = 2e-3;
// Relative error of the time against depth / rate above which there is a warning [1]
constexpr double kMaxTimeError = 0.05;
constexpr double kMinStepTime = 1e-9;  // shortest duration of a step with a rate [s]
// Smallest size of an object across its motion, over the length of a pad [1]
constexpr double kMinSizeRatio = 1.0 / 60;
// Axes with a smaller cosine to the direction of motion are across it [1]
constexpr double kMaxAcrossCosine = 0.7;
// Estimated shares of the motion and of the hold in the processor time of a press with a hold [1]
constexpr double kMotionShare = 0.7, kHoldShare = 0.3;
// Estimated processor time of the comparison of rungs, over that of the press [1]
constexpr double kRungsTime = 4;

void check_numbers(const PressRequest& request) {
  require_field("force", request.force.has_value() != request.depth.has_value(),
                "wanted a force or a depth, got {}", request.force ? "both" : "none");
  if (request.force)
    require_field("force", *request.force > 0 && *request.force <= kMaxPressForce,
                  "wanted a force above 0 N, of at most {:g} N, got {:g} N", kMaxPressForce,
                  *request.force);
  if (request.depth)
    require_field("depth", *request.depth > 0 && *request.depth <= kMaxPressDepth,
                  "wanted a depth above 0 mm, of at most {:g} mm, got {:g} mm",
                  kMaxPressDepth / kMm, *request.depth / kMm);
  // Without a rate the press takes no time, and at rate 0 all has relaxed already: a hold changes
  // neither.
  if (request.rate)
    require_field("rate", *request.rate >= 0 && *request.rate <= kMaxPressRate,
                  "wanted a rate of 0 to {:g} mm/s, got {:g} mm/s", kMaxPressRate / kMm,
                  *request.rate / kMm);
  require_field("hold", request.hold >= 0 && std::isfinite(request.hold),
                "wanted a holding time of 0 s or more, got {:g} s", request.hold);
  require_field("hold", request.hold == 0 || request.rate.value_or(0) > 0,
                "tissue relaxes while the object is held still after a rate above 0 only");
  require_field("friction", request.friction >= 0 && std::isfinite(request.friction),
                "wanted friction of at least 0, got {:g}", request.friction);
  for (const auto& [field, points] :
       {std::pair{"points", request.points}, std::pair{"hold_points", request.hold_points}})
    require_field(field, points >= 1 && points <= kMaxPressPoints,
                  "wanted 1 to {} points of a curve, got {}", kMaxPressPoints, points);
  require_field("force_error", request.force_error > 0 && std::isfinite(request.force_error),
                "wanted an error of the force above 0, got {:g}", request.force_error);
  require_field("max_elements",
                request.max_elements >= 1 && request.max_elements <= kMaxPadElements,
                "wanted 1 to {} elements, got {}", kMaxPadElements, request.max_elements);
}

/// Checks that the object is thick enough: the largest mesh does not resolve the patch of a pin.
/// @throws InputError otherwise
void check_object(const PressResult& out) {
  const Eigen::Vector3d along = out.touch.X_PO.R.transpose() * out.touch.along;
  const Eigen::Vector3d sizes = out.object.shape->bounds().sizes();
  const double thinnest = kMinSizeRatio * out.pad.spec.length;
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    require_field(
        "object", std::abs(along[axis]) > kMaxAcrossCosine || sizes[axis] >= thinnest,
        "wanted an object of at least {:.2g} mm across its way into a pad of {:g} mm, as no mesh "
        "resolves thinner ones; got {}, which is {:.2g} mm",
        thinnest / kMm, out.pad.spec.length / kMm, out.object.name, sizes[axis] / kMm);
}

/// Moves the object of a request into the pad, step by step, and records an instant of each step.
class PressRun {
 public:
  PressRun(PressResult& out, const Progress& progress)
      : out_(out),
        progress_(progress),
        rate_(out.request.rate),
        press_(model_of(out), {out.object.shape, out.request.friction}, out.touch.X_PO,
               options_of(out.request, progress)) {}

  void run() {
    const bool done = out_.request.depth ? press_to_depth() : press_to_force();
    if (done) hold_still();
    out_.X_PO = press_.state().X_PO;
    out_.skin = pressed_skin(press_, out_.request.friction);
    out_.cpu = thread_seconds() - began_;
  }

 private:
  /// Returns the model of the pad; without a rate it has no relaxation, as history costs time.
  static PadModel model_of(const PressResult& out) {
    PadModel model = out.pad.model;
    if (!out.request.rate)
      for (Tissue& tissue : model.tissues) tissue.relaxation.clear();
    return model;
  }
  static PadPressOptions options_of(const PressRequest& request, const Progress& progress) {
    PadPressOptions options;
    options.step.stop = progress.stop_requested;
    options.force_error = request.force_error;
    options.max_elements = request.max_elements;
    options.max_penetration = kMaxFacePenetration;
    return options;
  }

  /// Returns the displacement of the object since first touch [m], and its force along it [N].
  [[nodiscard]] double depth() const {
    return out_.touch.along.dot(press_.state().X_PO.p - out_.touch.X_PO.p);
  }
  [[nodiscard]] double force() const { return out_.touch.along.dot(press_.state().push.force); }

  /// Returns the duration of a step to a depth [s]: at rate 0 infinite, for the relaxed state.
  [[nodiscard]] double time_to(double depth) const {
    if (!rate_) return 0;
    if (*rate_ == 0) return std::numeric_limits<double>::infinity();
    return std::max(depth / *rate_ - time_, kMinStepTime);
  }

  /// Returns the goal of a step to a depth [m] that takes a time [s].
  [[nodiscard]] PressGoal goal_at(double depth, double time) const {
    PressGoal goal;
    goal.X_PO = out_.touch.X_PO;
    goal.X_PO.p += depth * out_.touch.along;
    goal.along = out_.touch.along;
    goal.time = time;
    return goal;
  }

  /// Makes one step and records its instant. @param fraction  share of the press before it, 0..1
  /// @returns false if the press ends: the step failed or was stopped
  bool step(const PressGoal& goal, PressPhase phase, double fraction) {
    if (progress_.stop()) {
      out_.outcome.status = Status::kStopped;
      return false;
    }
    progress_(fraction, phase == PressPhase::kWay ? "pressing" : "standing still");
    // Solve for equilibrium at this goal; a failure ends the press with the instants before it.
    const PadPressResult result = press_.step(goal);
    if (result.solved.status != Status::kSolved) {
      out_.outcome.status = result.solved.status;
      if (out_.outcome.status != Status::kStopped) out_.message = result.solved.message;
      return false;
    }
    // An infinite time requests the relaxed state, and is not added.
    if (std::isfinite(goal.time)) time_ += goal.time;
    PressInstant now;
    now.phase = phase;
    now.time = time_;
    now.depth = depth();
    now.force = force();
    now.push = result.push.force;
    now.area = result.area;
    now.stick = result.stick;
    // Where few nodes touch, their pressures are less than the mean over the patch.
    now.pressure = pressed_skin(press_, out_.request.friction).pressure.maxCoeff();
    if (now.area > 0) now.pressure = std::max(now.pressure, now.force / now.area);
    now.force_error = result.force_error;
    now.penetration = result.penetration;
    now.elements = result.elements;
    now.iterations = result.iterations;
    now.cpu = thread_seconds() - began_;
    out_.instants.push_back(now);
    return true;
  }

  /// Returns the share of the motion in the processor time of the press.
  [[nodiscard]] double motion_share() const { return out_.request.hold > 0 ? kMotionShare : 1; }

  /// Sets the allowed force error of step k. It is larger during the first third of the motion,
  /// where the patch is small and would need the finest elements. Refinement does not wait for the
  /// end of the motion, since large displacements may invert elements of the refined mesh.
  void allow_error(int k) {
    const bool early = 3 * k < out_.request.points;
    press_.set_force_error((early ? kEarlyErrorRatio : 1) * out_.request.force_error);
  }

  /// Moves the object to the requested depth, in even steps. @returns as step()
  bool press_to_depth() {
    const int count = out_.request.points;
    for (int k = 1; k <= count; ++k) {
      const double to = *out_.request.depth * k / count;
      allow_error(k);
      if (!step(goal_at(to, time_to(to)), PressPhase::kWay, motion_share() * (k - 1) / count))
        return false;
    }
    return true;
  }

  /// Makes a step to a force [N]; on a coarse mesh its depth may be less than that of first touch.
  /// With a rate the step takes the shortest time. @returns as step()
  bool step_to_force(double to, double fraction) {
    PressGoal goal = goal_at(depth(), rate_.value_or(0) > 0 ? kMinStepTime : time_to(depth()));
    goal.force = to;
    return step(goal, PressPhase::kWay, fraction);
  }

  /// Returns the depth [m] at a force `wanted` [N] on the curve force^(2/3) ~ depth through the
  /// present and the previous instant. If refinement between the two makes that curve fall, it goes
  /// through first touch and the present instant instead; without a force it is the present depth.
  [[nodiscard]] double predicted_depth(double wanted, double was_depth, double was_force) const {
    const auto grown = [](double force) { return std::pow(force, 1 / kHertzPower); };
    double slope = (grown(force()) - grown(was_force)) / (depth() - was_depth);
    if (!(slope > 0)) slope = grown(force()) / depth();
    return slope > 0 ? depth() + (grown(wanted) - grown(force())) / slope : depth();
  }

  /// Raises the force to the requested one. @returns as step()
  bool press_to_force() {
    const double wanted = *out_.request.force;
    // Two steps with small forces start the prediction of depths, and are not recorded. The first
    // uses a mesh that is not refined, where its depth may be less than that of first touch.
    press_.set_force_error(kUnrefinedError);
    bool goes = step_to_force(wanted / kFirstForceDivisor, 0);
    double was_depth = depth(), was_force = force();
    allow_error(0);
    goes = goes && step_to_force(wanted / kSecondForceDivisor, 0);
    if (goes) out_.instants.clear();
    // Forces rise with the power 3/2 of the step number, so that depths are about even.
    const int count = out_.request.points;
    for (int k = 1; goes && k <= count; ++k) {
      const double to = wanted * std::pow(static_cast<double>(k) / count, kHertzPower);
      if (k < count && to <= force()) continue;
      const double fraction = motion_share() * (k - 1) / count;
      const double at_depth = depth(), at_force = force();
      allow_error(k);
      goes = rate_.value_or(0) > 0
                 ? step_at_rate(to, predicted_depth(to, was_depth, was_force), k == count, fraction)
                 : step_to_force(to, fraction);
      was_depth = at_depth;
      was_force = at_force;
    }
    return goes;
  }

  /// Makes a step at the requested rate to the depth [m] predicted for a force [N]. At the last
  /// step the force itself follows, whose instant replaces that of the depth. @returns as step()
  bool step_at_rate(double force, double depth, bool is_last, double fraction) {
    if (!step(goal_at(depth, time_to(depth)), PressPhase::kWay, fraction)) return false;
    if (!is_last) return true;
    if (!step_to_force(force, fraction)) return false;
    out_.instants.erase(out_.instants.end() - 2);
    return true;
  }

  /// Holds the object at its depth for the requested time, in steps that grow.
  void hold_still() {
    if (out_.request.hold <= 0) return;
    const double began = time_, at = depth();
    const int count = out_.request.hold_points;
    // Times since the beginning of the hold grow by the same factor.
    const double factor = count > 1 ? std::pow(1 / kFirstHoldInstant, 1.0 / (count - 1)) : 1;
    for (int k = 1; k <= count; ++k) {
      const double to = began + out_.request.hold * std::pow(factor, k - count);
      if (!step(goal_at(at, to - time_), PressPhase::kHold,
                kMotionShare + kHoldShare * (k - 1) / count))
        return;
    }
  }

  PressResult& out_;
  const Progress& progress_;
  std::optional<double> rate_;
  double began_ = thread_seconds();
  double time_ = 0;  // time since first touch [s]
  PadPress press_;
};

void add_warnings(PressResult& out) {
  if (const std::string assumed = assumption_of(out.pad.spec); !assumed.empty())
    out.outcome.warnings.push_back(assumed);
  if (!out.rungs.empty())
    if (const std::string doubt = laws_warning(out); !doubt.empty())
      out.outcome.warnings.push_back(doubt);
  if (out.instants.empty()) return;
  const PressInstant& last = out.instants.back();
  if (out.outcome.status == Status::kSolved && last.force_error > out.request.force_error)
    out.outcome.warnings.push_back(fmt::format(
        "the estimated error of the force is {:.2g} %, above the {:.2g} % asked for: {}",
        100 * last.force_error, 100 * out.request.force_error,
        out.pad.model.element == HexElement::kQuadratic ? "quadratic elements are not refined"
                                                        : "the mesh has all elements it may have"));
  if (last.penetration > kMaxFacePenetration)
    out.outcome.warnings.push_back(
        fmt::format("between nodes the object is up to {:.2g} mm inside the skin: it is small "
                    "against the elements",
                    last.penetration / kMm));
  // Compare the time of each instant with depth / rate.
  double off = 0;
  for (const PressInstant& now : out.instants)
    if (now.phase == PressPhase::kWay && out.request.rate.value_or(0) > 0)
      off = std::max(off, std::abs(now.time * *out.request.rate / now.depth - 1));
  if (off > kMaxTimeError)
    out.outcome.warnings.push_back(fmt::format(
        "on the way to the force the time is up to {:.2g} % off the depth over the rate",
        100 * off));
}

}  // namespace

bool PressResult::relaxes() const {
  return request.rate.value_or(0) > 0 &&
         any_of(pad.model.tissues, [](const Tissue& tissue) { return !tissue.relaxation.empty(); });
}

const PressInstant* PressResult::end_of_motion() const {
  const PressInstant* last = nullptr;
  for (const PressInstant& now : instants)
    if (now.phase == PressPhase::kWay) last = &now;
  return last;
}

PressResult press_pad(const PressRequest& request, const Progress& progress) {
  check_numbers(request);
  PressResult out;
  // Open the pad and the object, and turn the object until it is about to touch.
  out.request = request;
  out.pad = open_pad(request.pad);
  out.object = open_press_object(request.object, out.pad.spec.length);
  out.touch = touch_pad(out.pad.model.shape, *out.object.shape, request.angle, request.turn);
  check_object(out);
  // The comparison of rungs takes most of the time, if it is requested.
  ProgressParts parts(progress, request.rungs ? 1 + kRungsTime : 1);
  const Progress of_way = parts.next(1);
  PressRun(out, of_way).run();
  // Compare with simpler laws only if the press itself was solved.
  if (request.rungs && out.outcome.status == Status::kSolved) {
    out.rungs = compare_rungs(out, parts.next(kRungsTime));
    if (progress.stop()) out.outcome.status = Status::kStopped;
  }
  // Count the instants, for the progress of a stopped request.
  out.outcome.part = "step";
  out.outcome.done = out.instants.size();
  out.outcome.asked =
      static_cast<std::size_t>(request.points + (request.hold > 0 ? request.hold_points : 0));
  add_warnings(out);
  return out;
}

}  // namespace thenar
