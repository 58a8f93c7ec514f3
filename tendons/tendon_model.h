#pragma once

/// Model of one digit with its tendons, on any scalar: everything that static fingertip forces
/// depend on.

#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "base/fidelity.h"
#include "hand/skeleton.h"
#include "tendons/hood.h"
#include "tendons/path.h"
#include "tendons/tip_statics.h"

namespace thenar {

/// Angle as a function of posture:  ratio q[coordinate] + offset,  or the offset alone if frozen.
struct PostureAngle {
  int coordinate = -1;  // entry of q; -1: frozen
  double ratio = 0;     // [rad/rad]
  double offset = 0;    // [rad]
};

template <typename T>
/// Evaluates an angle at posture q [rad].
[[nodiscard]] T angle_at(const PostureAngle& angle, const VectorX<T>& q) {
  if (angle.coordinate < 0) return T(angle.offset);
  return T(angle.ratio) * q[angle.coordinate] + T(angle.offset);
}

/// Flexion joint, free, coupled or frozen, about which tendons bend in their sheaths.
struct SheathBend {
  PostureAngle angle;
  int first_coordinate_beyond = 0;  // first coordinate whose joint lies beyond the bend;
                                    // `coordinates` if there is none
};

/// Numerical model of a digit; its names are in TendonNames.
template <typename T>
struct TendonModel {
  Tree<T> tree;         // hinges from the wrist to the tip
  int coordinates = 0;  // number of entries of q
  int tip_link = 0;     // link that carries the tip
  Vec3<T> tip;          // position of the tip in the reference posture [m] (3)
  Mat3<T> tip_axes;  // tip axes in the reference posture: columns proximal, dorsal, radial (3, 3)
  std::vector<TendonPath<T>> paths;  // path of each strand; empty: constant arms
  MatrixX<T> constant_arms;  // moment arms of strands without a path [m/rad] (strands, coordinates)
  std::vector<SheathBend> bends;  // sheath bends, from the wrist to the tip
  VectorX<T> friction;     // friction coefficient of each strand in its sheath [1/rad] (strands)
  std::vector<int> pulls;  // strand that each muscle pulls with its whole tension (muscles)
  std::optional<HoodRows> hood;  // hood rows of the strand matrix; absent: separate tendons
  std::vector<HoodShare<T>> hood_shares;
  PostureAngle
      knuckle;  // metacarpophalangeal angle that the hood's shares depend on, flexion positive
};

/// Names of the rows of a TendonModel.
struct TendonNames {
  std::vector<std::string> coordinates;
  std::vector<std::string> hinges;
  std::vector<std::string> strands;
  std::vector<std::string> muscles;
};

struct BuiltNet;  // tendons/net/build_net.h

/// Digit with its model, names and limits.
struct TendonDigit {
  TendonModel<double> model;
  TendonNames names;
  Skeleton skeleton;            // skeleton of this digit alone
  Eigen::VectorXd max_tension;  // F0, the upper bound of tendon tension without pennation; infinite
                                // where the subject does not state it [N] (muscles)
  Fidelity fidelity;            // level of detail that was built
  std::vector<CalibratedOn> calibrated_on{};  // force measurements to which the subject was fitted
  std::shared_ptr<const BuiltNet> net{};  // floating net in place of a hood; null: none. Constant,
                                          // shared by copies of the digit
  /// Action of each muscle at each joint, by the sign of the subject's arms_mm or by its name: 1
  /// positive arm, -1 negative, 0 unknown (muscles, coordinates).
  Eigen::MatrixXi actions{};
};

/// Treatment of joints that digits share: the wrist.
enum class WristMode {
  kWelded,  // fixed at the reference posture or at the angle in `frozen`; for one fingertip alone
  kFree     // free to move; every tendon that crosses them counts
};

/// Returns the default path model: wrapped where a tendon bends over a surface or originates from
/// another tendon, straight between via points elsewhere.
[[nodiscard]] Path default_path(const Subject& subject);

/// Options of the tendons to build. Where the user leaves `path` open, default_path() applies.
struct TendonOptions {
  Path path = Path::kViaPoint;   // path model; kConstant: only the subject's constant arms
  Hood hood = Hood::kFractions;  // hood model; kSeparate: every muscle pulls its own strand only
  std::map<std::string, double> frozen{};  // joint -> the angle it is frozen at [rad]
  WristMode wrist_mode = WristMode::kWelded;
  /// Muscles to keep even if they cross no joint of the digit: those that pull a net.
  std::vector<std::string> kept{};
};

/// Returns every path point whose segment is kept, at the reference posture, from insertion to
/// origin.
[[nodiscard]] TendonPath<double> carried_points(const Skeleton& skeleton, const Strand& strand);

/// Builds one digit of a subject with every muscle that crosses one of its joints. Its own paths
/// are always straight: build_linear_tendons() adds wrapping.
/// @throws InputError if the digit, or an arm or path of a crossing strand, is missing.
[[nodiscard]] TendonDigit build_tendon_digit(const Subject& subject, const std::string& digit,
                                             const TendonOptions& options = {});

/// Checks a posture. @throws InputError unless it has an angle for each coordinate, each finite.
void check_posture(const TendonDigit& digit, const Eigen::VectorXd& q);

/// Computes the statics of the digit's tip at posture q (coordinates) [rad].
[[nodiscard]] TipStatics tip_statics(const TendonDigit& digit, const Eigen::VectorXd& q);

/// Computes the proximal, dorsal and radial directions of the tip at posture q as columns, world
/// frame (3, 3).
[[nodiscard]] Eigen::Matrix3d tip_axes(const TendonDigit& digit, const Eigen::VectorXd& q);

/// Computes the flexion of the metacarpophalangeal joint of a finger: the flexion joint next to the
/// wrist from the one that the hood's central slip crosses, be it free, coupled or frozen. It is 0
/// without a hood and in a digit without such a joint [rad].
template <typename T>
[[nodiscard]] T mcp_angle(const TendonModel<T>& model, const VectorX<T>& q) {
  return angle_at(model.knuckle, q);
}

/// Computes strand tension per muscle tension at posture q, without friction (strands, muscles)
/// [1].
template <typename T>
[[nodiscard]] MatrixX<T> strand_matrix(const TendonModel<T>& model, const VectorX<T>& q) {
  MatrixX<T> S(model.paths.size(), model.pulls.size());
  S.setZero();
  for (std::size_t m = 0; m < model.pulls.size(); ++m) S(model.pulls[m], m) = T(1);
  if (model.hood) add_hood(*model.hood, model.hood_shares, mcp_angle(model, q), S);
  return S;
}

/// Computes the angle by which a tendon bends: |angle|, smoothed within 0.01 rad where a coordinate
/// drives it, so that derivatives exist in the straight finger [rad].
template <typename T>
[[nodiscard]] T bend_size(const PostureAngle& angle, const VectorX<T>& q) {
  using std::sqrt;
  if (angle.coordinate < 0) return T(std::abs(angle.offset));
  const T bent = angle_at(angle, q);
  return sqrt(bent * bent + T(1e-4));
}

/// Computes the share of a strand's tension that remains at each joint after friction in the
/// sheath,
///   exp(-mu sum |angle_k|)  over the flexion joints k nearer the muscle (Euler's belt formula).
/// Frozen joints bend the sheath as well. An abduction joint has the share of the flexion joint
/// before it, so that a universal joint counts once. (coordinates) [1]
template <typename T>
[[nodiscard]] VectorX<T> remaining_tension(const TendonModel<T>& model, const VectorX<T>& q,
                                           const T& mu) {
  using std::exp;
  VectorX<T> left = VectorX<T>::Ones(model.coordinates);
  T bent(0);
  auto bend = model.bends.begin();
  for (int j = 0; j < model.coordinates; ++j) {
    if (j > 0) left[j] = left[j - 1];
    for (; bend != model.bends.end() && bend->first_coordinate_beyond <= j; ++bend) {
      bent += bend_size(bend->angle, q);
      left[j] = exp(-mu * bent);
    }
  }
  return left;
}

/// Computes the moment arms of every strand, times its remaining tension (strands, coordinates)
/// [m/rad].
template <typename T>
[[nodiscard]] MatrixX<T> strand_arms(const TendonModel<T>& model, const TreeState<T>& state,
                                     const VectorX<T>& q) {
  MatrixX<T> R = model.constant_arms;
  for (std::size_t s = 0; s < model.paths.size(); ++s) {
    if (!model.paths[s].empty())
      R.row(s) = moment_arms(model.tree, state, model.paths[s], model.coordinates);
    // Apply friction; on autodiff scalars also at zero, to keep its derivative.
    if (!std::is_same_v<T, double> || model.friction[s] != T(0))
      R.row(s) = R.row(s).cwiseProduct(remaining_tension(model, q, model.friction[s]).transpose());
  }
  return R;
}

/// Computes the moment arms of every muscle through the hood,  R = S' R_strands  [m/rad] (muscles,
/// coordinates).
template <typename T>
[[nodiscard]] MatrixX<T> muscle_arms(const TendonModel<T>& model, const TreeState<T>& state,
                                     const VectorX<T>& q) {
  return strand_matrix(model, q).transpose() * strand_arms(model, state, q);
}

}  // namespace thenar
