#include "pads/pad_press.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/error.h"
#include "base/lists.h"
#include "pads/carry_press.h"
#include "pads/contact_area.h"
#include "pads/force_search.h"

namespace thenar {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr int kMaxHalvingDepth = 12;  // nested halvings of a step
// First step in depth of a force search over the distance of nodes [1]
constexpr double kFirstStepRatio = 0.1;
// Relative difference up to which error estimates are equal [1]
constexpr double kEqualErrors = 1e-6;
// Least number of touching nodes times requested error of a fine patch [1]
constexpr double kMinPatchAccuracy = 1;
constexpr int kMaxPatchLevel = 3;        // halvings of cells to reach that number of touching nodes
constexpr double kTouchGap = 1e-10;      // gap up to which the object touches [m]
constexpr int kMaxTouchMotions = 10000;  // motions of the object towards the pad
constexpr int kDepthSamples = 4;  // intervals along a side of a face at which depth is sampled

/// Returns whether a step needs no further attempt: it is solved or was stopped.
bool is_final(const PressOutcome& out) {
  return out.status == Status::kSolved || out.status == Status::kStopped;
}

/// Returns the pose at a part of the motion from a to b.
Pose<double> interpolate(const Pose<double>& a, const Pose<double>& b, double part) {
  const Eigen::AngleAxisd turn(b.R * a.R.transpose());
  return {rotation_about<double>(turn.axis(), part * turn.angle()) * a.R, a.p + part * (b.p - a.p)};
}

}  // namespace

PadPress::PadPress(const PadModel& model, RigidObject object, const Pose<double>& X_PO,
                   PadPressOptions options)
    : model_(model),
      object_(std::move(object)),
      options_(options),
      mesh_(pad_mesh(model.shape, model.cells)) {
  if (model.element == HexElement::kQuadratic) mesh_.refine(std::vector<int>(mesh_.active()));
  build_body();
  state_ = start_ = rest_state(*body_, surface_, X_PO);
}

void PadPress::build_body() {
  body_ = std::make_unique<TissueBody>(mesh_, model_.element, model_.tissues, held_by_bone(mesh_));
  factors_ = std::make_unique<PressFactors>(*body_);
  surface_ = build_contact_surface(mesh_, *body_, skin_nodes(mesh_));
}

double PadPress::touch(const Vector3d& along) {
  require(std::abs(along.norm() - 1) < 1e-9, "the direction of a touch is not a unit vector");
  require(state_.normal_force.isZero(0), "the object touches already");
  double distance = 0;
  for (int k = 0;; ++k) {
    require(k < kMaxTouchMotions, "the object does not come near the pad");
    // Move by the smallest gap, which is safe because no point is nearer.
    const double gap = min_gap(surface_, *object_.shape, state_.X_PO, state_.x);
    require(k > 0 || gap > -kTouchGap, "the object begins {:g} mm inside the pad", -gap * 1e3);
    require(gap < 1, "the object passes the pad by");
    if (gap <= kTouchGap) break;
    state_.X_PO.p += gap * along;
    distance += gap;
  }
  place_object(state_.X_PO);
  return distance;
}

void PadPress::place_object(const Pose<double>& X_PO) {
  state_.X_PO = X_PO;
  const Matrix3Xd places = deformed_positions(surface_, state_.x);
  for (Eigen::Index i = 0; i < places.cols(); ++i)
    state_.anchor.col(i) = X_PO.inverse() * Vector3d(places.col(i));
  start_ = state_;
}

Eigen::Matrix<double, 6, 6> PadPress::stiffness(std::optional<double> friction) {
  const RigidObject object{object_.shape, friction.value_or(object_.friction)};
  return press_stiffness(*body_, surface_, object, options_.step, *factors_, state_);
}

PressGoal PadPress::goal_from_current_pose(const PressGoal& goal) const {
  PressGoal out = goal;
  if (goal.force) out.X_PO.p += goal.along.dot(state_.X_PO.p - goal.X_PO.p) * goal.along;
  return out;
}

PressOutcome PadPress::solve_once(const PressGoal& goal, PressState& state) {
  PressOutcome out = press_step(*body_, surface_, object_, goal, options_.step, *factors_, state);
  iterations_ += out.iterations;
  return out;
}

PressOutcome PadPress::solve(const PressGoal& goal, int cuts) {
  // Try the whole step; a force that fails is searched for by depths.
  PressOutcome out = solve_once(goal, state_);
  if (is_final(out)) return out;
  if (goal.force && options_.max_failed_pieces > 1)
    return seek_force([this](const PressGoal& to, PressState& at) { return solve_once(to, at); },
                      goal, kFirstStepRatio * std::sqrt(surface_.area.mean()), state_);
  if (cuts >= kMaxHalvingDepth || ++failed_pieces_ >= options_.max_failed_pieces) return out;
  // Solve the two halves of the step.
  PressGoal half = goal;
  half.time /= 2;
  half.X_PO = interpolate(state_.X_PO, goal.X_PO, 0.5);
  out = solve(half, cuts + 1);
  if (out.status != Status::kSolved) return out;
  PressGoal rest = goal;
  rest.time /= 2;
  return solve(rest, cuts + 1);
}

PadPressResult PadPress::step(const PressGoal& goal) {
  PadPressResult result;
  PressState start = state_;
  std::optional<Accepted> accepted;
  for (bool refined = false;; refined = true) {
    // On a refined mesh, start from the solution on the coarser one.
    if (refined) result.solved = solve_once(goal_from_current_pose(goal), state_);
    // Return to the accepted mesh if the finer one, refined for depth alone, has no solution.
    if (accepted && !is_final(result.solved)) {
      mesh_ = std::move(accepted->mesh);
      build_body();
      state_ = std::move(accepted->state);
      start = std::move(accepted->start);
      result = std::move(accepted->result);
      break;
    }
    // On the first mesh, or without a solution from there, solve from the start of the step.
    if (!refined || !is_final(result.solved)) {
      state_ = start;
      failed_pieces_ = 0;
      result.solved = solve(goal, 0);
    }
    if (result.solved.status != Status::kSolved) {
      state_ = start;
      break;
    }
    // Estimate the error of the force by the energy of the error; end if the mesh is fine enough.
    const Matrix3Xd u = body_->node_displacements(state_.x, {});
    const VectorXd errors = body_->error_energies(u);
    TissueResponse elastic;
    body_->evaluate(u, 0, {}, {}, ElementRequest::kEnergy, elastic);
    result.force_error = elastic.energy > 0 ? errors.sum() / elastic.energy : 0;
    measure_result(result);
    if ((result.force_error <= options_.force_error &&
         result.penetration <= options_.max_penetration && !has_coarse_patch()) ||
        model_.element == HexElement::kQuadratic ||
        static_cast<int>(body_->elements()) >= options_.max_elements)
      break;
    // Refine where nodes touch if they are too few, else where errors are large, else where faces
    // are too deep; in the last case keep the solution in case the finer mesh has none.
    const bool is_coarse = has_coarse_patch();
    accepted.reset();
    if (!is_coarse && result.force_error <= options_.force_error)
      accepted = Accepted{mesh_, state_, start, result};
    refine(is_coarse  ? touching_cells()
           : accepted ? deep_cells_
                      : cells_with_large_errors(errors),
           start);
  }
  start_ = std::move(start);
  result.elements = body_->elements();
  result.iterations = iterations_;
  result.cuts = failed_pieces_;
  return result;
}

bool PadPress::has_coarse_patch() const {
  const Eigen::Index touching = (state_.normal_force.array() > 0).count();
  if (touching == 0 || static_cast<double>(touching) * options_.force_error >= kMinPatchAccuracy)
    return false;
  const std::vector<int> cells = touching_cells();
  return any_of(cells, [&](int index) { return mesh_.cells()[index].level < kMaxPatchLevel; });
}

std::vector<int> PadPress::touching_cells() const {
  // Mark the nodes with a contact force.
  std::vector<bool> touches(static_cast<std::size_t>(mesh_.nodes()), false);
  for (std::size_t k = 0; k < surface_.nodes.size(); ++k)
    if (state_.normal_force[k] > 0) touches[mesh_node(*body_, surface_, k)] = true;
  // List the cells with such a corner, or with one that hangs on it.
  std::vector<int> out;
  for (const int index : mesh_.active()) {
    const auto& corners = mesh_.cells()[index].corners;
    if (any_of(corners, [&](int node) {
          return any_of(mesh_.support(node),
                        [&](const NodeWeight& each) { return touches[each.node]; });
        }))
      out.push_back(index);
  }
  return out;
}

std::vector<int> PadPress::cells_with_large_errors(const VectorXd& errors) const {
  // Sort the elements by decreasing error.
  std::vector<int> order(static_cast<std::size_t>(errors.size()));
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return errors[a] > errors[b]; });
  // Take elements up to the share that is refined at once. Equal errors go together, so that a
  // symmetric mesh stays symmetric despite rounding.
  std::vector<int> marked;
  double sum = 0, last = 0;
  for (const int e : order) {
    if (sum > options_.refined_share * errors.sum() && errors[e] < (1 - kEqualErrors) * last) break;
    sum += errors[e];
    last = errors[e];
    marked.push_back(mesh_.active()[e]);
  }
  return marked;
}

void PadPress::refine(const std::vector<int>& marked, PressState& start) {
  // Build the new mesh and body, and transfer both states.
  const PressTransfer transfer(mesh_, std::move(body_), std::move(surface_));
  mesh_.refine(marked);
  build_body();
  start = transfer.transfer_state(start, mesh_, *body_, surface_);
  state_ = transfer.transfer_state(state_, mesh_, *body_, surface_);
  // Keep the anchors and the history of the start of the step.
  state_.anchor = start.anchor;
  state_.history = start.history;
}

void PadPress::measure_result(PadPressResult& result) {
  result.push = result.solved.push;
  // Sum the normal force and its share on sticking nodes.
  double total = 0, sticking = 0;
  for (Eigen::Index k = 0; k < state_.normal_force.size(); ++k) {
    total += state_.normal_force[k];
    if (node_sticks(state_, k, object_.friction)) sticking += state_.normal_force[k];
  }
  result.stick = total > 0 ? sticking / total : 0;
  const std::vector<bool> skin = skin_nodes(mesh_);
  result.area = contact_area(mesh_, *body_, model_.tissues, skin, surface_, object_, state_);
  // Find the deepest point of each face on a grid, and the cells where it is too deep.
  const Matrix3Xd u = body_->node_displacements(state_.x, {});
  const Pose<double> X_OP = state_.X_PO.inverse();
  result.penetration = 0;
  deep_cells_.clear();
  for (const HexFace& face : marked_faces(mesh_, skin)) {
    std::array<Vector3d, 4> at;
    double deepest = 0;
    for (std::size_t i = 0; i < 4; ++i) at[i] = mesh_.place(face.nodes[i]) + u.col(face.nodes[i]);
    for (int i = 0; i <= kDepthSamples; ++i)
      for (int j = 0; j <= kDepthSamples; ++j) {
        const double a = static_cast<double>(i) / kDepthSamples,
                     b = static_cast<double>(j) / kDepthSamples;
        const Vector3d p =
            (1 - a) * ((1 - b) * at[0] + b * at[2]) + a * ((1 - b) * at[1] + b * at[3]);
        deepest = std::max(deepest, -object_.shape->distance(X_OP * p));
      }
    result.penetration = std::max(result.penetration, deepest);
    if (deepest > options_.max_penetration) deep_cells_.push_back(face.cell);
  }
}

}  // namespace thenar
