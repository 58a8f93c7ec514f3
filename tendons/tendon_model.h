#pragma once

/// One digit with its tendons, on any scalar: all that static fingertip forces depend on.

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

/// An angle of the posture:  ratio q[coordinate] + offset,  or the offset alone where it is frozen.
struct PostureAngle {
  int coordinate = -1;  // entry of q; -1: frozen
  double ratio = 0;     // [rad/rad]
  double offset = 0;    // [rad]
};

template <typename T>
[[nodiscard]] T angle_at(const PostureAngle& angle, const VectorX<T>& q) {
  if (angle.coordinate < 0) return T(angle.offset);
  return T(angle.ratio) * q[angle.coordinate] + T(angle.offset);
}

/// A flexion joint, free, coupled or frozen, about which tendons bend in their sheaths.
struct SheathBend {
  PostureAngle angle;
  int first_coordinate_beyond;  // first coordinate whose joint lies beyond the bend; `coordinates`
                                // if none does
};

/// Numbers of a digit; names are in TendonNames.
template <typename T>
struct TendonModel {
  Tree<T> tree;                      // hinges from the wrist to the tip
  int coordinates;                   // entries of q
  int tip_link;                      // link that carries the tip
  Vec3<T> tip;                       // reference posture [m] (3)
  Mat3<T> tip_axes;                  // columns proximal, dorsal, radial (3, 3)
  std::vector<TendonPath<T>> paths;  // of each strand; empty: constant arms
  MatrixX<T> constant_arms;          // of strands without a path [m/rad] (strands, coordinates)
  std::vector<SheathBend> bends;     // from the wrist to the tip
  VectorX<T> friction;               // of each strand in its sheath [1/rad] (strands)
  std::vector<int> pulls;            // strand that each muscle pulls whole
  std::optional<HoodRows> hood;      // absent: separate tendons
  std::vector<HoodShare<T>> hood_shares;
  PostureAngle knuckle;  // on which the hood's shares depend, flexion positive
};

/// Names that go with the rows of a TendonModel.
struct TendonNames {
  std::vector<std::string> coordinates;
  std::vector<std::string> hinges;
  std::vector<std::string> strands;
  std::vector<std::string> muscles;
};

struct BuiltNet;  // tendons/net/build_net.h

/// A digit ready for questions: model, names, limits.
struct TendonDigit {
  TendonModel<double> model;
  TendonNames names;
  Skeleton skeleton;            // the digit alone
  Eigen::VectorXd max_tension;  // F0 as the upper bound of tendon tension, pennation neglected;
                                // infinite where the subject does not say [N] (muscles)
  Fidelity fidelity;            // what was built
  std::vector<CalibratedOn> calibrated_on{};  // forces that the subject was fitted to before
  std::shared_ptr<const BuiltNet> net{};      // a floating net in place of a hood; null: none. It
                                              // is shared by copies of the digit, and constant
  Eigen::MatrixXi actions{};  // of each muscle at each joint, by the sign of the subject's arms_mm
                              // or by its name: 1 positive arm, -1 negative, 0 unknown (muscles,
                              // coordinates)
};

/// Treatment of joints that digits share: the wrist.
enum class WristMode {
  kWelded,  // at the reference posture, or where `frozen` says: a question of one fingertip
  kFree     // they move, and every tendon across them counts
};

/// The rung of paths where none is asked for: wrapped where a tendon bends over a surface or
/// originates from another tendon; straight between via points elsewhere.
[[nodiscard]] Path default_path(const Subject& subject);

/// Options of the tendons to build. A question that leaves `path` open takes default_path().
struct TendonOptions {
  Path path = Path::kViaPoint;             // kConstant: only the subject's constant arms
  Hood hood = Hood::kFractions;            // kSeparate: every muscle pulls its own strand only
  std::map<std::string, double> frozen{};  // joint -> the angle it is frozen at [rad]
  WristMode wrist_mode = WristMode::kWelded;
  std::vector<std::string> kept{};  // muscles that count even where the digit has none of their
                                    // joints: those that pull a net
};

/// Builds one digit of a subject with every muscle that crosses one of its joints. Its own paths
/// are straight, whatever the rung: build_linear_tendons() wraps them.
/// @throws InputError if the digit, or an arm or path of a crossing strand, is missing.
[[nodiscard]] TendonDigit build_tendon_digit(const Subject& subject, const std::string& digit,
                                             const TendonOptions& options = {});

/// Everything at the digit's tip at posture q (coordinates) [rad].
[[nodiscard]] TipStatics tip_statics(const TendonDigit& digit, const Eigen::VectorXd& q);

/// Proximal, dorsal and radial of the tip at posture q as columns, world frame (3, 3).
[[nodiscard]] Eigen::Matrix3d tip_axes(const TendonDigit& digit, const Eigen::VectorXd& q);

/// Flexion of the knuckle, the metacarpophalangeal joint of a finger: the flexion joint next to the
/// wrist from the one that the hood's central slip crosses, be it free, coupled or frozen. It is 0
/// without a hood and in a digit without such a joint [rad].
template <typename T>
[[nodiscard]] T mcp_angle(const TendonModel<T>& model, const VectorX<T>& q) {
  return angle_at(model.knuckle, q);
}

/// Strand tension per muscle tension at posture q, before friction (strands, muscles) [1].
template <typename T>
[[nodiscard]] MatrixX<T> strand_matrix(const TendonModel<T>& model, const VectorX<T>& q) {
  MatrixX<T> S(model.paths.size(), model.pulls.size());
  S.setZero();
  for (std::size_t m = 0; m < model.pulls.size(); ++m) S(model.pulls[m], m) = T(1);
  if (model.hood) add_hood(*model.hood, model.hood_shares, mcp_angle(model, q), S);
  return S;
}

/// Returns the angle by which a tendon bends: |angle|, smoothed within 0.01 rad where a coordinate
/// moves it, so that derivatives exist in the straight finger [rad].
template <typename T>
[[nodiscard]] T bend_size(const PostureAngle& angle, const VectorX<T>& q) {
  using std::sqrt;
  if (angle.coordinate < 0) return T(std::abs(angle.offset));
  const T bent = angle_at(angle, q);
  return sqrt(bent * bent + T(1e-4));
}

/// Share of a strand's tension that is left at each joint after the sheath's friction,
///   exp(-mu sum |angle_k|)  over the flexion joints k nearer the muscle (Euler's belt formula).
/// Frozen joints bend the sheath like others. A joint that abducts feels as much as the flexion
/// joint before it, so that a universal joint counts as one.
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

/// Moment arms of every strand at a pose, times the tension left (strands, coordinates) [m/rad].
template <typename T>
[[nodiscard]] MatrixX<T> strand_arms(const TendonModel<T>& model, const TreeState<T>& state,
                                     const VectorX<T>& q) {
  MatrixX<T> R = model.constant_arms;
  for (std::size_t s = 0; s < model.paths.size(); ++s) {
    if (!model.paths[s].empty())
      R.row(s) = moment_arms(model.tree, state, model.paths[s], model.coordinates);
    // Where derivatives are carried, they must not be lost at zero.
    if (!std::is_same_v<T, double> || model.friction[s] != T(0))
      R.row(s) = R.row(s).cwiseProduct(remaining_tension(model, q, model.friction[s]).transpose());
  }
  return R;
}

/// Moment arms of every muscle through the hood,  R = S' R_strands  [m/rad] (muscles, coordinates).
template <typename T>
[[nodiscard]] MatrixX<T> muscle_arms(const TendonModel<T>& model, const TreeState<T>& state,
                                     const VectorX<T>& q) {
  return strand_matrix(model, q).transpose() * strand_arms(model, state, q);
}

}  // namespace thenar
