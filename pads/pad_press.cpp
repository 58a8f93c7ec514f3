#include "pads/pad_press.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/error.h"
#include "pads/force_search.h"

namespace thenar {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr int kMaxCuts = 12;       // halvings of a step
constexpr double kFirstWay = 0.1;  // between depths of a search, over distances of nodes [1]
constexpr double kEqual = 1e-6;    // difference of errors that are equal [1]
constexpr double kPatchNodes = 1;  // nodes that touch times the error that is asked, at least
constexpr int kPatchLevels = 3;    // halvings of cells for the sake of it
constexpr double kTouch = 1e-10;   // gap that counts as touching [m]

/// Whether nothing more is to be tried.
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
  surface_ = contact_surface(mesh_, *body_, skin_nodes(mesh_));
}

double PadPress::touch(const Vector3d& along) {
  require(std::abs(along.norm() - 1) < 1e-9, "the direction of a touch is no unit vector");
  require(state_.normal.isZero(0), "the object touches already");
  double way = 0;
  for (int k = 0;; ++k) {
    require(k < 10000, "the object does not come near the pad");
    // No point is nearer than the smallest gap: so far the object may go.
    const double gap = smallest_gap(surface_, *object_.shape, state_.X_PO, state_.x);
    require(k > 0 || gap > -kTouch, "the object begins {:g} mm inside the pad", -gap * 1e3);
    require(gap < 1, "the object passes the pad by");
    if (gap <= kTouch) break;
    state_.X_PO.p += gap * along;
    way += gap;
  }
  begin_at(state_.X_PO);
  return way;
}

void PadPress::begin_at(const Pose<double>& X_PO) {
  state_.X_PO = X_PO;
  const Matrix3Xd places = places_of(surface_, state_.x);
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
  for (bool refined = false;; refined = true) {
    // On a finer mesh from the answer of the coarser; otherwise from the step's beginning.
    if (refined) {
      result.solved = solve_once(from_here(goal), state_);
    }
    if (!refined || !ended(result.solved)) {
      state_ = start;
      pieces_ = 0;
      result.solved = solve(goal, 0);
    }
    if (result.solved.status != Status::kSolved) {
      state_ = start;
      break;
    }
    const Matrix3Xd u = body_->spread(state_.x, {});
    const VectorXd errors = body_->error_energies(u);
    TissueResponse now;
    body_->respond(u, 0, {}, {}, ElementAsk::kEnergy, now);
    result.force_error = now.energy > 0 ? errors.sum() / now.energy : 0;
    measure(result);
    if ((result.force_error <= options_.force_error &&
         result.penetration <= options_.max_penetration && !patch_is_coarse()) ||
        model_.element == HexElement::kQuadratic ||
        static_cast<int>(body_->elements()) >= options_.max_elements)
      break;
    refine(errors, start);
  }
  before_ = std::move(start);
  result.elements = body_->elements();
  result.iterations = iterations_;
  result.cuts = pieces_;
  return result;
}

bool PadPress::patch_is_coarse() const {
  const Eigen::Index touching = (state_.normal.array() > 0).count();
  if (touching == 0 || static_cast<double>(touching) * options_.force_error >= kPatchNodes)
    return false;
  const std::vector<int> cells = touching_cells();
  return std::any_of(cells.begin(), cells.end(), [&](int index) {
    return mesh_.cells()[static_cast<std::size_t>(index)].level < kPatchLevels;
  });
}

std::vector<int> PadPress::touching_cells() const {
  std::vector<bool> touches(static_cast<std::size_t>(mesh_.nodes()), false);
  for (std::size_t k = 0; k < surface_.nodes.size(); ++k)
    if (state_.normal[static_cast<Eigen::Index>(k)] > 0)
      touches[static_cast<std::size_t>(
          body_->free_nodes()[static_cast<std::size_t>(surface_.nodes[k])])] = true;
  std::vector<int> out;
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

/// Cells that touch while they are too few; then the elements with the largest errors, until they
/// hold a share of the whole.
std::vector<int> PadPress::marked_cells(const VectorXd& errors) const {
  if (patch_is_coarse()) return touching_cells();
  std::vector<int> order(static_cast<std::size_t>(errors.size()));
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return errors[a] > errors[b]; });
  // Equal errors go together: what is symmetric stays so, whatever rounding says.
  std::vector<int> marked;
  double sum = 0, least = 0;
  for (const int e : order) {
    if (sum > options_.refined * errors.sum() && errors[e] < (1 - kEqual) * least) break;
    sum += errors[e];
    least = errors[e];
    marked.push_back(mesh_.active()[static_cast<std::size_t>(e)]);
  }
  return marked;
}

void PadPress::refine(const VectorXd& errors, PressState& start) {
  const std::vector<int> marked = marked_cells(errors);
  // Fields of all nodes before.
  const auto fields_of = [&](const PressState& state) {
    struct Fields {
      Matrix3Xd u, anchor;
      std::vector<bool> known;
      VectorXd normal;
      Matrix3Xd shear;
    } f;
    f.u = body_->spread(state.x, {});
    f.anchor = Matrix3Xd::Zero(3, mesh_.nodes());
    f.shear = f.anchor;
    f.normal = VectorXd::Zero(mesh_.nodes());
    f.known.assign(static_cast<std::size_t>(mesh_.nodes()), false);
    for (std::size_t k = 0; k < surface_.nodes.size(); ++k) {
      const int node = body_->free_nodes()[static_cast<std::size_t>(surface_.nodes[k])];
      const auto column = static_cast<Eigen::Index>(k);
      f.anchor.col(node) = state.anchor.col(column);
      f.normal[node] = state.normal[column];
      f.shear.col(node) = state.shear.col(column);
      f.known[static_cast<std::size_t>(node)] = true;
    }
    return f;
  };
  const std::vector<int> old_active = mesh_.active();
  auto before = fields_of(start);
  auto now = fields_of(state_);
  const int old_nodes = mesh_.nodes();
  mesh_.refine(marked);
  build();
  // New nodes have the mean of what they were made from.
  const auto carry = [&](auto& f, PressState& state) {
    f.u.conservativeResize(3, mesh_.nodes());
    for (int node = old_nodes; node < mesh_.nodes(); ++node) {
      f.u.col(node).setZero();
      for (const NodeWeight& each : mesh_.made_from(node))
        f.u.col(node) += each.weight * f.u.col(each.node);
    }
    state.x.resize(body_->unknowns());
    for (std::size_t i = 0; i < body_->free_nodes().size(); ++i)
      state.x.segment<3>(static_cast<Eigen::Index>(3 * i)) = f.u.col(body_->free_nodes()[i]);
    const auto count = static_cast<Eigen::Index>(surface_.nodes.size());
    state.normal = VectorXd::Zero(count);
    state.shear = Matrix3Xd::Zero(3, count);
    state.anchor.resize(3, count);
    for (std::size_t k = 0; k < surface_.nodes.size(); ++k) {
      const int node = body_->free_nodes()[static_cast<std::size_t>(surface_.nodes[k])];
      const auto column = static_cast<Eigen::Index>(k);
      state.anchor.col(column) =
          state.X_PO.inverse() *
          Vector3d(surface_.places.col(column) + state.x.segment<3>(3 * surface_.nodes[k]));
      if (node >= old_nodes || !f.known[static_cast<std::size_t>(node)]) continue;
      state.anchor.col(column) = f.anchor.col(node);
      state.normal[column] = f.normal[node];
      state.shear.col(column) = f.shear.col(node);
    }
  };
  carry(before, start);
  carry(now, state_);
  const std::vector<Origin> origins = origins_among(old_active);
  start.history = carried_history(start.history, origins);
  for (PressState* state : {&start, &state_}) {
    // A carried displacement keeps no volume on new nodes of the curved skin; pressure does.
    const TissuePressure old = std::move(state->pressure);
    state->pressure.clear();
    if (!old.empty())
      for (const Origin& from : origins) state->pressure.push_back(old[from.element]);
  }
  // From the old equilibrium, but with what was at the step's beginning.
  state_.anchor = start.anchor;
  state_.shear = start.shear;
  state_.history = start.history;
}

std::vector<PadPress::Origin> PadPress::origins_among(const std::vector<int>& old_active) const {
  std::vector<Origin> out;
  for (const int index : mesh_.active()) {
    // The element itself, or the one that it was cut from, and its octant in that.
    int cell = index, octant = -1;
    auto from = std::lower_bound(old_active.begin(), old_active.end(), cell);
    while (from == old_active.end() || *from != cell) {
      const HexCell& part = mesh_.cells()[static_cast<std::size_t>(cell)];
      octant = cell - mesh_.cells()[static_cast<std::size_t>(part.parent)].first_child;
      cell = part.parent;
      from = std::lower_bound(old_active.begin(), old_active.end(), cell);
    }
    out.push_back({static_cast<std::size_t>(from - old_active.begin()), octant});
  }
  return out;
}

TissueHistory PadPress::carried_history(const TissueHistory& old,
                                        const std::vector<Origin>& origins) {
  TissueHistory out;
  if (old.empty()) return out;
  for (const Origin& from : origins) {
    ElementHistory history = old[from.element];
    // Gauss points are ordered as corners: all of a child have that of its parent's octant.
    if (from.octant >= 0)
      for (std::vector<Voigt>* list : {&history.elastic, &history.terms})
        for (std::size_t first = 0; first < list->size(); first += 8)
          std::fill_n(list->begin() + static_cast<std::ptrdiff_t>(first), 8,
                      Voigt((*list)[first + static_cast<std::size_t>(from.octant)]));
    out.push_back(std::move(history));
  }
  return out;
}

void PadPress::measure(PadPressResult& result) const {
  result.push = result.solved.push;
  const Matrix3Xd u = body_->spread(state_.x, {});
  const Pose<double> X_OP = state_.X_PO.inverse();
  std::vector<double> normal(static_cast<std::size_t>(mesh_.nodes()), 0);
  double all = 0, stuck = 0;
  for (std::size_t k = 0; k < surface_.nodes.size(); ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    const int node = body_->free_nodes()[static_cast<std::size_t>(surface_.nodes[k])];
    normal[static_cast<std::size_t>(node)] = state_.normal[column];
    all += state_.normal[column];
    if (node_sticks(state_, column, object_.friction)) stuck += state_.normal[column];
  }
  result.stick = all > 0 ? stuck / all : 0;
  // Faces of the skin: a quarter for each node that touches; and points between nodes.
  result.area = result.penetration = 0;
  for (const HexFace& face : marked_faces(mesh_, skin_nodes(mesh_))) {
    std::array<Vector3d, 4> at;
    double touching = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      at[i] = mesh_.place(face.nodes[i]) + u.col(face.nodes[i]);
      double share = 0;
      for (const NodeWeight& each : mesh_.support(face.nodes[i]))
        share += normal[static_cast<std::size_t>(each.node)] > 0 ? each.weight : 0;
      if (share > 0.5) touching += 0.25;
    }
    result.area += touching * 0.5 * (at[3] - at[0]).cross(at[2] - at[1]).norm();
    for (int i = 0; i <= 4; ++i)
      for (int j = 0; j <= 4; ++j) {
        const double a = i / 4.0, b = j / 4.0;
        const Vector3d p =
            (1 - a) * ((1 - b) * at[0] + b * at[2]) + a * ((1 - b) * at[1] + b * at[3]);
        result.penetration = std::max(result.penetration, -object_.shape->distance(X_OP * p));
      }
  }
}

}  // namespace thenar
