#include "kinematics_fit/kernel/compile.h"

#include <algorithm>
#include <cmath>

namespace thenar::kernel {
namespace {

template <typename Matrix>
void append(const Matrix& values, std::vector<double>& row) {
  for (Eigen::Index i = 0; i < values.rows(); ++i)
    for (Eigen::Index j = 0; j < values.cols(); ++j) row.push_back(values(i, j));
}

/// Returns the numbers of a model in the order of Layout; shifts of hood fractions are zero.
std::vector<double> row_of(const SpecimenModel<double>& model) {
  std::vector<double> row;
  // Append hinges and paths.
  for (const auto& hinge : model.digit.tree) append(hinge.direction, row);
  for (const auto& hinge : model.digit.tree) append(hinge.point, row);
  for (const auto& path : model.digit.paths)
    for (const auto& node : path) append(node.p, row);
  // Append moment arms, friction and hood.
  append(model.digit.constant_arms, row);
  append(model.digit.friction, row);
  for (const auto& share : model.digit.hood_shares) row.insert(row.end(), {0, 0, share.slope});
  // Append the mounting: tip, load cell, angle errors, constraint, gains.
  append(model.digit.tip, row);
  append(model.sensor_tilt, row);
  append(model.angle_error, row);
  append(model.posture_error.transpose(), row);
  row.push_back(model.out_of_plane);
  append(model.gain, row);
  append(model.unexplained.transpose(), row);
  append(model.posture_unexplained.transpose(), row);
  return row;
}

/// Writes a shift of a hood fraction: not the fractions but their logits are linear in their
/// parameters.
void set_hood_shift(const Parameter& p, double value, const Layout& layout,
                    std::vector<double>& row) {
  if (p.kind == ParameterKind::kHoodEntry) row[layout.into(p.item)] = value;
  if (p.kind == ParameterKind::kHoodCentral) row[layout.central(p.item)] = value;
}

/// Returns a digit in which every free number is zero.
SpecimenModel<double> zeros(const TendonDigit& digit, int postures) {
  SpecimenModel<double> model = cast_model<double>(digit.model, postures);
  // Clear the geometry.
  for (auto& hinge : model.digit.tree) {
    hinge.direction.setZero();
    hinge.point.setZero();
  }
  for (auto& path : model.digit.paths)
    for (auto& node : path) node.p.setZero();
  // Clear hood, arms, friction, tip and gains.
  for (auto& share : model.digit.hood_shares) share.slope = 0;
  model.digit.constant_arms.setZero();
  model.digit.friction.setZero();
  model.digit.tip.setZero();
  model.gain.setZero();
  return model;
}

}  // namespace

Layout::Layout(const TendonModel<double>& model, int posture_count)
    : hinges(static_cast<int>(model.tree.size())),
      coordinates(model.coordinates),
      postures(posture_count),
      muscles(static_cast<int>(model.pulls.size())) {
  const int strands = static_cast<int>(model.paths.size());
  // Find the first path point of each strand.
  int count = 0;
  for (const auto& path : model.paths) {
    first_node.push_back(count);
    count += static_cast<int>(path.size());
  }
  // Place the numbers, one kind behind the other.
  directions = 0;
  points = directions + 3 * hinges;
  nodes = points + 3 * hinges;
  arms = nodes + 3 * count;
  frictions = arms + strands * coordinates;
  shares = frictions + strands;
  tip = shares + 3 * static_cast<int>(model.hood_shares.size());
  tilt = tip + 3;
  angle_errors = tilt + 3;
  posture_errors = angle_errors + coordinates;
  out_of_plane = posture_errors + coordinates * postures;
  gains = out_of_plane + 1;
  unexplained = gains + muscles;
  posture_unexplained = unexplained + 3 * muscles;
  size = posture_unexplained + 3 * muscles * postures;
}

std::vector<double> initial_parameters(const TendonDigit& digit, const FitParameters& parameters,
                                       const Layout& layout) {
  // Set all parameters to their prior means.
  SpecimenModel<double> model = cast_model<double>(digit.model, layout.postures);
  for (const Parameter& p : parameters.all) set_parameter(digit.model, p, p.mean, model);
  std::vector<double> row = row_of(model);
  for (const Parameter& p : parameters.all) set_hood_shift(p, p.mean, layout, row);
  return row;
}

std::vector<LinearTerm> parameter_terms(const TendonDigit& digit, const FitParameters& parameters,
                                        const Layout& layout) {
  std::vector<LinearTerm> moves;
  for (std::size_t p = 0; p < parameters.all.size(); ++p) {
    // Set the parameter on a digit of zeros: the numbers that are not zero are those that it moves.
    if (parameters.coordinate[p] < 0) continue;
    SpecimenModel<double> model = zeros(digit, layout.postures);
    set_parameter(digit.model, parameters.all[p], parameters.ratio[p], model);
    std::vector<double> row = row_of(model);
    set_hood_shift(parameters.all[p], parameters.ratio[p], layout, row);
    for (int i = 0; i < layout.size; ++i)
      if (row[i] != 0) moves.push_back({i, parameters.coordinate[p], row[i]});
  }
  return moves;
}

namespace {

AngleStep step_of(const PostureAngle& angle) {
  return {angle.coordinate, angle.ratio, angle.offset};
}

/// Copies a 3 x 3 matrix, column by column.
void copy(const Eigen::Matrix3d& by_columns, double* to) {
  std::copy(by_columns.data(), by_columns.data() + 9, to);
}

/// Compiles the parts of a program in order.
class Compiler {
 public:
  Compiler(const TendonDigit& digit, const FitParameters& parameters, const ExperimentPlan& plan,
           Program& program)
      : model_(digit.model),
        plan_(plan),
        layout_(digit.model, static_cast<int>(parameters.postures.size())),
        moves_(parameter_terms(digit, parameters, layout_)),
        start_(initial_parameters(digit, parameters, layout_)),
        mean_(specimen_model(
            digit, parameters,
            parameter_values<double>(
                parameters, Eigen::VectorXd(Eigen::VectorXd::Zero(parameters.coordinates()))))),
        to_(program) {
    // Sort the numbers that some coordinate moves.
    for (const LinearTerm& move : moves_) moving_.push_back(move.number);
    std::sort(moving_.begin(), moving_.end());

    // Set the sizes, then compile the steps in the order in which they run.
    to_.coordinates = model_.coordinates;
    to_.fit_coordinates = parameters.coordinates();
    to_.trials = static_cast<int>(plan.force.cols());
    set_hinges();
    set_postures();
    set_paths();
    set_sheaths();
    set_hood();
    set_trials();
    set_hold();
    set_load_cell();
    to_.start = start_;
    to_.moves = moves_;
  }

 private:
  /// Returns whether a coordinate moves one of `count` numbers from `place` on.
  [[nodiscard]] bool moves(int place, int count) const {
    const auto first = std::lower_bound(moving_.begin(), moving_.end(), place);
    return first != moving_.end() && *first < place + count;
  }

  /// Returns whether an error moves this angle in this posture.
  [[nodiscard]] bool angle_moves(std::size_t posture, int coordinate) const {
    const int own = plan_.posture_key[posture];
    return moves(layout_.angle_errors + coordinate, 1) ||
           (own >= 0 && moves(layout_.posture_error(own) + coordinate, 1));
  }
  /// Returns whether an error moves any angle.
  [[nodiscard]] bool any_angle_moves() const {
    return moves(layout_.angle_errors, layout_.coordinates * (1 + layout_.postures));
  }

  void set_hinges() {
    std::vector<HingeStep> hinges;
    for (int i = 0; i < layout_.hinges; ++i) {
      // Locate the direction and the point of each hinge.
      const Hinge<double>& h = model_.tree[i];
      // Normalize directions that do not move once and for all.
      const bool tilts = moves(layout_.direction(i), 3);
      hinges.push_back({h.parent, h.coordinate, h.ratio, h.offset, layout_.direction(i),
                        layout_.point(i), tilts, moves(layout_.point(i), 3)});
      if (!tilts)
        for (int k = 0; k < 3; ++k)
          start_[layout_.direction(i) + k] = mean_.digit.tree[i].direction[k];
    }
    to_.hinges = std::move(hinges);
  }

  void set_postures() {
    std::vector<double> q;
    std::vector<StillAngle> angles;
    for (std::size_t k = 0; k < plan_.postures.size(); ++k) {
      // Store stated angles, and sines and cosines of hinges that no error moves.
      const Eigen::VectorXd at = posture_at_start(k);
      for (int j = 0; j < layout_.coordinates; ++j) q.push_back(plan_.postures[k][j]);
      for (const Hinge<double>& h : model_.tree) {
        const double angle = h.ratio * at[h.coordinate] + h.offset;
        angles.push_back({!angle_moves(k, h.coordinate), std::sin(angle), std::cos(angle)});
      }
    }
    to_.q = std::move(q);
    to_.still_angles = std::move(angles);
    to_.angle_error = layout_.angle_errors;
  }

  /// Returns the angles of posture k, with their errors at the prior means [rad].
  [[nodiscard]] Eigen::VectorXd posture_at_start(std::size_t k) const {
    Eigen::VectorXd q = plan_.postures[k] + mean_.angle_error;
    if (plan_.posture_key[k] >= 0) q += mean_.posture_error.col(plan_.posture_key[k]);
    return q;
  }

  void set_paths() {
    std::vector<NodeStep> nodes;
    std::vector<RunStep> runs;
    std::vector<ArmTerm> arm_terms;
    std::vector<int> strands;
    for (int s = 0; s < static_cast<int>(model_.paths.size()); ++s) {
      // List the path points of each strand in order.
      const TendonPath<double>& path = model_.paths[s];
      if (path.empty()) continue;
      strands.push_back(s);
      for (int k = 0; k < static_cast<int>(path.size()); ++k) {
        nodes.push_back({path[k].link, layout_.node(s, k)});
        // Add a run between two links, with the hinges that it crosses.
        if (k == 0 || path[k].link == path[k - 1].link) continue;
        const int to = static_cast<int>(nodes.size()) - 1,
                  first = static_cast<int>(arm_terms.size());
        climb(s, path[k - 1].link, path[k].link, to, arm_terms);
        runs.push_back({to - 1, to, first, static_cast<int>(arm_terms.size())});
      }
    }
    to_.strands = static_cast<int>(model_.paths.size());
    to_.arms = layout_.arms;
    to_.nodes = std::move(nodes);
    to_.runs = std::move(runs);
    to_.arm_terms = std::move(arm_terms);
    to_.path_strands = std::move(strands);
  }

  /// Appends the hinges between two links, in the order of moment_arms().
  void climb(int strand, int a, int b, int to, std::vector<ArmTerm>& arm_terms) const {
    while (a != b) {
      // Step from the distal of the two links over one hinge towards the base.
      const bool climb_b = b > a;
      const int i = climb_b ? b : a;
      const Hinge<double>& h = model_.tree[i];
      arm_terms.push_back({i, climb_b ? to : to - 1, strand * layout_.coordinates + h.coordinate,
                           climb_b ? -h.ratio : h.ratio});
      (climb_b ? b : a) = h.parent;
    }
  }

  void set_sheaths() {
    // List the bends of the finger, in order.
    std::vector<BendStep> bends;
    for (const SheathBend& bend : model_.bends)
      bends.push_back({step_of(bend.angle), bend.first_coordinate_beyond});
    // List strands whose friction is not zero, or may become so.
    std::vector<SheathStep> sheaths;
    for (int s = 0; s < to_.strands; ++s)
      if (moves(layout_.frictions + s, 1) || mean_.digit.friction[s] != 0)
        sheaths.push_back({s, layout_.frictions + s});
    to_.bends = std::move(bends);
    to_.sheaths = std::move(sheaths);
  }

  void set_hood() {
    if (!model_.hood) return;
    // Set the strands of the hood, and the knuckle that shifts the shares.
    const HoodRows& rows = *model_.hood;
    to_.hood = {rows.central_slip, rows.radial_band, rows.ulnar_band, rows.terminal_slip};
    to_.knuckle = step_of(model_.knuckle);
    to_.hood_angle = kHoodAngle;
    // List each muscle's fractions, and the places of their shifts.
    std::vector<ShareStep> shares;
    for (int b = 0; b < static_cast<int>(model_.hood_shares.size()); ++b) {
      const HoodShare<double>& share = model_.hood_shares[b];
      const double radial = share.side == HoodSide::kRadial  ? 1
                            : share.side == HoodSide::kUlnar ? 0
                                                             : 0.5;
      shares.push_back({share.muscle, radial, share.into_hood, share.to_central, layout_.into(b),
                        layout_.central(b), layout_.slope(b)});
    }
    to_.shares = std::move(shares);
  }

  [[nodiscard]] bool arms_move() const {
    // Check paths, bends and constant arms; gains scale the arms.
    const bool kinematics = moves(0, layout_.nodes) || any_angle_moves();
    const bool paths = to_.path_strands.size() > 0 &&
                       (kinematics || moves(layout_.nodes, layout_.arms - layout_.nodes));
    const bool bends = any_angle_moves() && (to_.sheaths.size() > 0 || to_.shares.size() > 0);
    return paths || bends || moves(layout_.arms, layout_.tip - layout_.arms) ||
           moves(layout_.gains, layout_.unexplained - layout_.gains);
  }

  void set_trials() {
    std::vector<PostureStep> postures;
    std::vector<TrialStep> trials;
    std::vector<TensionStep> pulls;
    std::vector<double> torque;
    for (std::size_t k = 0; k < plan_.postures.size(); ++k) {
      // Compute the muscles' moment arms in this posture, at the prior means.
      const int first = static_cast<int>(trials.size()), own = plan_.posture_key[k];
      const Eigen::VectorXd q = posture_at_start(k);
      const Eigen::MatrixXd arms =
          mean_.gain.asDiagonal() * muscle_arms(mean_.digit, pose_tree(mean_.digit.tree, q), q);
      for (int i = 0; i < to_.trials; ++i) {
        // List the trials of the posture: the muscles that pull, and the torque if no arm moves.
        if (plan_.posture_of_trial[i] != static_cast<int>(k)) continue;
        const Eigen::VectorXd& t = plan_.tension[i];
        const int first_pull = static_cast<int>(pulls.size());
        for (int m = 0; m < t.size(); ++m)
          if (t[m] != 0) pulls.push_back({m, t[m], own < 0 ? -1 : layout_.posture_force(own, m)});
        trials.push_back({i, first_pull, static_cast<int>(pulls.size())});
        const Eigen::VectorXd tau = arms.transpose() * t;
        torque.insert(torque.end(), tau.begin(), tau.end());
      }
      postures.push_back(
          {first, static_cast<int>(trials.size()), own < 0 ? -1 : layout_.posture_error(own)});
    }

    // Set what all postures share.
    to_.arms_move = arms_move();
    to_.postures = std::move(postures);
    to_.trial_steps = std::move(trials);
    to_.pulls = std::move(pulls);
    to_.still_torque = std::move(torque);
    to_.pulls_strand = model_.pulls;
    to_.gain = layout_.gains;
    to_.unexplained = layout_.unexplained;
    to_.unexplained_moves = moves(layout_.unexplained, layout_.size - layout_.unexplained) ||
                            !mean_.unexplained.isZero(0) || !mean_.posture_unexplained.isZero(0);
  }

  void set_hold() {
    // Set the loads that the tip constraint carries.
    const bool out_of_plane = mean_.out_of_plane != 0 || moves(layout_.out_of_plane, 1);
    const bool in_plane = plan_.known == DecidedForces::kInPlane;
    to_.tip_forces = in_plane ? 2 : 3;
    const int moments = plan_.hold == TipConstraint::kPinned ? 0
                        : out_of_plane && !in_plane          ? 3
                                                             : 1;
    to_.loads = to_.tip_forces + moments;
    to_.hold_length = kHoldLength;
    to_.out_of_plane = layout_.out_of_plane;
    to_.tip_link = model_.tip_link;
    to_.tip = layout_.tip;
    copy(model_.tip_axes, to_.tip_axes);
    // List the hinges between the tip and the base.
    std::vector<int> hinges;
    for_each_hinge_to_base(model_.tree, model_.tip_link, [&](int i) { hinges.push_back(i); });
    to_.tip_hinges = std::move(hinges);
  }

  void set_load_cell() {
    to_.cell_moves = plan_.force_link != model_.tip_link || moves(layout_.tilt, 3);
    to_.sensor_tilt = layout_.tilt;
    to_.force_link = plan_.force_link;
    copy(plan_.components, to_.components);
    copy(plan_.components * small_rotation<double>(mean_.sensor_tilt), to_.still_cell);
  }

  const TendonModel<double>& model_;
  const ExperimentPlan& plan_;
  Layout layout_;
  std::vector<LinearTerm> moves_;
  std::vector<double> start_;
  SpecimenModel<double> mean_;
  std::vector<int> moving_;  // numbers that move, sorted
  Program& to_;
};

}  // namespace

void compile(const TendonDigit& digit, const FitParameters& parameters, const ExperimentPlan& plan,
             Program& program) {
  Compiler(digit, parameters, plan, program);
}

}  // namespace thenar::kernel
