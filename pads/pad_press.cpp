#include "pads/pad_press.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/error.h"
#include "pads/carry_press.h"
#include "pads/contact_area.h"
#include "pads/force_search.h"

namespace thenar {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr int kMaxCuts = 12;  // Most halvings of a step
// First step in depth of a search, over the distance of nodes [1]
constexpr double kFirstWay = 0.1;
// Relative difference up to which error estimates are equal [1]
constexpr double kEqualErrors = 1e-6;
// A patch is fine enough if touching nodes times the requested error reach this [1]
constexpr double kPatchNodes = 1;
constexpr int kPatchLevels = 3;  // Most halvings of cells to reach that number of touching nodes
constexpr double kTouchGap = 1e-10;  // Gap up to which the object touches [m]

/// Returns whether a step needs no further trial: it is solved or was stopped.
bool ended(const PressOutcome& out) {
  return out.status == Status::kSolved || out.status == Status::kStopped;
}

/// Part of the way between two poses.
Pose<double> between(const Pose<double>& a, const Pose<double>& b, double part) {
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
  build();
  state_ = before_ = rest_state(*body_, surface_, X_PO);
}

void PadPress::build() {
  body_ = std::make_unique<TissueBody>(mesh_, model_.element, model_.tissues, held_by_bone(mesh_));
  factors_ = std::make_unique<PressFactors>(*body_);
  surface_ = build_contact_surface(mesh_, *body_, skin_nodes(mesh_));
}

double PadPress::touch(const Vector3d& along) {
  require(std::abs(along.norm() - 1) < 1e-9, "the direction of a touch is no unit vector");
  require(state_.normal_force.isZero(0), "the object touches already");
  double way = 0;
  for (int k = 0;; ++k) {
    require(k < 10000, "the object does not come near the pad");
    // No point is nearer than the smallest gap: so far the object may go.
    const double gap = min_gap(surface_, *object_.shape, state_.X_PO, state_.x);
    require(k > 0 || gap > -kTouchGap, "the object begins {:g} mm inside the pad", -gap * 1e3);
    require(gap < 1, "the object passes the pad by");
    if (gap <= kTouchGap) break;
    state_.X_PO.p += gap * along;
    way += gap;
  }
  begin_at(state_.X_PO);
  return way;
}

void PadPress::begin_at(const Pose<double>& X_PO) {
  state_.X_PO = X_PO;
  const Matrix3Xd places = deformed_positions(surface_, state_.x);
  for (Eigen::Index i = 0; i < places.cols(); ++i)
    state_.anchor.col(i) = X_PO.inverse() * Vector3d(places.col(i));
  before_ = state_;
}

Eigen::Matrix<double, 6, 6> PadPress::stiffness(std::optional<double> friction) {
  const RigidObject object{object_.shape, friction.value_or(object_.friction)};
  return press_stiffness(*body_, surface_, object, options_.step, *factors_, state_);
}

PressGoal PadPress::from_here(const PressGoal& goal) const {
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
  // Whole step, or a search by depths for a force.
  PressOutcome out = solve_once(goal, state_);
  if (ended(out)) return out;
  if (goal.force && options_.pieces > 1)
    return seek_force([this](const PressGoal& to, PressState& at) { return solve_once(to, at); },
                      goal, kFirstWay * std::sqrt(surface_.area.mean()), state_);
  if (cuts >= kMaxCuts || ++pieces_ >= options_.pieces) return out;
  // Half of the way first.
  PressGoal half = goal;
  half.time /= 2;
  half.X_PO = between(state_.X_PO, goal.X_PO, 0.5);
  out = solve(half, cuts + 1);
  if (out.status != Status::kSolved) return out;
  PressGoal rest = goal;
  rest.time /= 2;
  return solve(rest, cuts + 1);
}

PadPressResult PadPress::step(const PressGoal& goal) {
  PadPressResult result;
  PressState start = state_;
  std::optional<Kept> kept;
  for (bool refined = false;; refined = true) {
    // Solve on a refined mesh, first from the answer of the coarser one.
    if (refined) {
      result.solved = solve_once(from_here(goal), state_);
    }
    // A mesh refined for depth alone that has no answer is given up for the one before.
    if (kept && !ended(result.solved)) {
      mesh_ = std::move(kept->mesh);
      build();
      state_ = std::move(kept->state);
      start = std::move(kept->start);
      result = std::move(kept->result);
      break;
    }
    // First mesh, or no answer from there: solve from the step's beginning, in pieces.
    if (!refined || !ended(result.solved)) {
      state_ = start;
      pieces_ = 0;
      result.solved = solve(goal, 0);
    }
    if (result.solved.status != Status::kSolved) {
      state_ = start;
      break;
    }
    // Error of the force by the energy of the error, which tells when the mesh is good enough.
    const Matrix3Xd u = body_->node_displacements(state_.x, {});
    const VectorXd errors = body_->error_energies(u);
    TissueResponse now;
    body_->evaluate(u, 0, {}, {}, ElementRequest::kEnergy, now);
    result.force_error = now.energy > 0 ? errors.sum() / now.energy : 0;
    measure(result);
    if ((result.force_error <= options_.force_error &&
         result.penetration <= options_.max_penetration && !patch_is_coarse()) ||
        model_.element == HexElement::kQuadratic ||
        static_cast<int>(body_->elements()) >= options_.max_elements)
      break;
    // Refine where nodes touch while they are too few, else where errors are large, else where
    // faces are too deep, and then keep the answer in case the finer mesh has none.
    const bool is_coarse = patch_is_coarse();
    kept.reset();
    if (!is_coarse && result.force_error <= options_.force_error)
      kept = Kept{mesh_, state_, start, result};
    refine(is_coarse ? touching_cells() : kept ? deep_cells_ : cells_of_errors(errors), start);
  }
  before_ = std::move(start);
  result.elements = body_->elements();
  result.iterations = iterations_;
  result.cuts = pieces_;
  return result;
}

bool PadPress::patch_is_coarse() const {
  const Eigen::Index touching = (state_.normal_force.array() > 0).count();
  if (touching == 0 || static_cast<double>(touching) * options_.force_error >= kPatchNodes)
    return false;
  const std::vector<int> cells = touching_cells();
  return std::any_of(cells.begin(), cells.end(), [&](int index) {
    return mesh_.cells()[static_cast<std::size_t>(index)].level < kPatchLevels;
  });
}

std::vector<int> PadPress::touching_cells() const {
  // Nodes that bear force.
  std::vector<bool> touches(static_cast<std::size_t>(mesh_.nodes()), false);
  for (std::size_t k = 0; k < surface_.nodes.size(); ++k)
    if (state_.normal_force[static_cast<Eigen::Index>(k)] > 0)
      touches[static_cast<std::size_t>(mesh_node(*body_, surface_, k))] = true;
  std::vector<int> out;
  // Cells with such a corner, or with one that hangs on it.
  for (const int index : mesh_.active()) {
    const auto& corners = mesh_.cells()[static_cast<std::size_t>(index)].corners;
    if (std::any_of(corners.begin(), corners.end(), [&](int node) {
          const std::vector<NodeWeight> support = mesh_.support(node);
          return std::any_of(support.begin(), support.end(), [&](const NodeWeight& each) {
            return touches[static_cast<std::size_t>(each.node)];
          });
        }))
      out.push_back(index);
  }
  return out;
}

std::vector<int> PadPress::cells_of_errors(const VectorXd& errors) const {
  // Elements by falling error, until they hold the share that is refined at once.
  std::vector<int> order(static_cast<std::size_t>(errors.size()));
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return errors[a] > errors[b]; });
  // Equal errors go together: what is symmetric stays so, whatever rounding says.
  std::vector<int> marked;
  double sum = 0, least = 0;
  for (const int e : order) {
    if (sum > options_.refined * errors.sum() && errors[e] < (1 - kEqualErrors) * least) break;
    sum += errors[e];
    least = errors[e];
    marked.push_back(mesh_.active()[static_cast<std::size_t>(e)]);
  }
  return marked;
}

void PadPress::refine(const std::vector<int>& marked, PressState& start) {
  // New mesh and body, with the states at the beginning and now carried over.
  const PressCarrier carrier(mesh_, std::move(body_), std::move(surface_));
  mesh_.refine(marked);
  build();
  start = carrier.carry(start, mesh_, *body_, surface_);
  state_ = carrier.carry(state_, mesh_, *body_, surface_);
  // From the old equilibrium, but with what was at the step's beginning.
  state_.anchor = start.anchor;
  state_.history = start.history;
}

void PadPress::measure(PadPressResult& result) {
  result.push = result.solved.push;
  // Share of the normal force on nodes that stick.
  double all = 0, stuck = 0;
  for (Eigen::Index k = 0; k < state_.normal_force.size(); ++k) {
    all += state_.normal_force[k];
    if (node_sticks(state_, k, object_.friction)) stuck += state_.normal_force[k];
  }
  result.stick = all > 0 ? stuck / all : 0;
  const std::vector<bool> skin = skin_nodes(mesh_);
  result.area = contact_area(mesh_, *body_, model_.tissues, skin, surface_, object_, state_);
  // Deepest point within each face on a grid, and the cells where it is too deep.
  const Matrix3Xd u = body_->node_displacements(state_.x, {});
  const Pose<double> X_OP = state_.X_PO.inverse();
  result.penetration = 0;
  deep_cells_.clear();
  for (const HexFace& face : marked_faces(mesh_, skin)) {
    std::array<Vector3d, 4> at;
    double deepest = 0;
    for (std::size_t i = 0; i < 4; ++i) at[i] = mesh_.place(face.nodes[i]) + u.col(face.nodes[i]);
    for (int i = 0; i <= 4; ++i)
      for (int j = 0; j <= 4; ++j) {
        const double a = i / 4.0, b = j / 4.0;
        const Vector3d p =
            (1 - a) * ((1 - b) * at[0] + b * at[2]) + a * ((1 - b) * at[1] + b * at[3]);
        deepest = std::max(deepest, -object_.shape->distance(X_OP * p));
      }
    result.penetration = std::max(result.penetration, deepest);
    if (deepest > options_.max_penetration) deep_cells_.push_back(face.cell);
  }
}

}  // namespace thenar
