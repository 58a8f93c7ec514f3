#pragma once

/// Pull of muscles on a net: by given tensions, or by elastic tendons with given far ends.

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "tendons/net/net_tendons.h"

namespace thenar {

/// Radius of the exit through which a tendon leaves the net [m]. Our choice: a node that is drawn
/// in rests within it, where the pull of a tendon towards a point would have no gradient.
inline constexpr double kExitRadius = 1e-4;

/// Posture with the load of each muscle: its tension [N], or the position of the far end of its
/// tendon along its line, up to a constant [m]. The NetPull in use defines which.
struct PostureAndLoad {
  Eigen::VectorXd q;     // (coordinates) [rad]
  Eigen::VectorXd load;  // tensions [N] or far ends [m] (muscles)
};

/// Derivatives of the net's pulls at constant band lengths.
struct PullRates {
  Eigen::MatrixXd by_posture;  // [N/rad] (pulls, coordinates)
  Eigen::MatrixXd by_load;     // [1] or [N/m] (pulls, muscles)
};

/// Potential energy of a net and its load, with its gradient:  dE = -tau dq + by_load dload.
struct NetPotential {
  double energy = 0;        // [J]
  Eigen::VectorXd tau;      // [N m] (coordinates)
  Eigen::VectorXd by_load;  // lengths of lines [m], or -tension [N] (muscles)
};

/// Returns an infinite torque, which no integrator accepts, with a warning.
[[nodiscard]] TendonTorque infinite_torque(Eigen::Index joints, Eigen::Index muscles,
                                           std::string why);

/// Load model: how muscles pull a net.
class NetPull {
 public:
  /// Refers to the tendons. @param tendons  must outlive this object
  explicit NetPull(const NetTendons& tendons) : tendons_(tendons) {}
  NetPull(const NetPull&) = delete;
  NetPull& operator=(const NetPull&) = delete;
  virtual ~NetPull() = default;

  [[nodiscard]] const NetTendons& tendons() const { return tendons_; }

  /// Computes the drive of the net.
  [[nodiscard]] virtual NetDrive drive(const PostureAndLoad& at) const = 0;

  /// Computes the derivatives of the pulls at constant band lengths.
  [[nodiscard]] virtual PullRates rates(const PostureAndLoad& at,
                                        const NetEquilibrium& rest) const = 0;

  /// Computes the potential energy of net and load.
  [[nodiscard]] virtual NetPotential potential(const PostureAndLoad& at,
                                               const NetEquilibrium& rest) const = 0;

  /// Computes the torque of all tendons with the net at this equilibrium.
  [[nodiscard]] virtual TendonTorque torque(const PostureAndLoad& at,
                                            NetEquilibrium rest) const = 0;

  /// Computes the derivatives of torque, tensions and lengths by posture and far ends of tendons;
  /// without the net's part where it is not differentiable; empty where loads are tensions.
  [[nodiscard]] virtual EndSlopes slopes(const PostureAndLoad& /*at*/,
                                         const NetEquilibrium& /*rest*/) const {
    return {};
  }

  /// Returns whether a muscle pulls the net, so that its nodes are determined.
  [[nodiscard]] virtual bool pulls(const Eigen::VectorXd& load) const = 0;

  /// Returns the smallest change of loads that counts as a step.
  /// @param share  fraction of the largest tension, where loads are tensions [1]
  [[nodiscard]] virtual double min_change(const Eigen::VectorXd& from, const Eigen::VectorXd& to,
                                          double share) const = 0;

  /// Solves for the equilibrium of the net from the initial nodes `start` (3, nodes); empty: where
  /// links carry them.
  [[nodiscard]] NetEquilibrium rest(const PostureAndLoad& at, const Eigen::Matrix3Xd& start) const {
    return tendons_.rest(at.q, drive(at), start);
  }

 private:
  const NetTendons& tendons_;
};

/// Load model whose loads are tensions [N].
class PullByTension : public NetPull {
 public:
  using NetPull::NetPull;
  [[nodiscard]] NetDrive drive(const PostureAndLoad& at) const override;
  [[nodiscard]] PullRates rates(const PostureAndLoad& at,
                                const NetEquilibrium& rest) const override;

  /// Computes the potential of the net alone:  strain energy + t L.
  [[nodiscard]] NetPotential potential(const PostureAndLoad& at,
                                       const NetEquilibrium& rest) const override;
  [[nodiscard]] TendonTorque torque(const PostureAndLoad& at, NetEquilibrium rest) const override;
  [[nodiscard]] bool pulls(const Eigen::VectorXd& load) const override;
  [[nodiscard]] double min_change(const Eigen::VectorXd& from, const Eigen::VectorXd& to,
                                  double share) const override;
};

/// Load model whose loads are far ends p of elastic tendons [m]: each tendon has the tension of its
/// law at the length  L - p,  L that of its line. Net and tendons minimise one energy,  strain
/// energy + sum U(L - p).  The equilibrium can therefore be found even where the net would be
/// unstable under constant tensions.
class PullByTendon : public NetPull {
 public:
  /// Builds the load model.
  /// @param laws   tension law of each muscle's tendon; one law may serve several (muscles)
  /// @param first  initial equilibrium: line lengths at exits are measured from it, so that lines
  /// start with the length of DigitTendons::lengths()
  /// @throws InputError if a muscle does not pull exactly one band, see pulls_one_band_each().
  PullByTendon(const NetTendons& tendons, std::vector<std::shared_ptr<const TensionLaw>> laws,
               const NetEquilibrium& first);

  [[nodiscard]] NetDrive drive(const PostureAndLoad& at) const override;
  [[nodiscard]] PullRates rates(const PostureAndLoad& at,
                                const NetEquilibrium& rest) const override;

  /// Computes the potential of net and tendons:  strain energy + sum U(L - p);  infinite where a
  /// law is.
  [[nodiscard]] NetPotential potential(const PostureAndLoad& at,
                                       const NetEquilibrium& rest) const override;

  /// Computes the torque without moment arms, with tensions and lengths; infinite, without these,
  /// where a law is.
  [[nodiscard]] TendonTorque torque(const PostureAndLoad& at, NetEquilibrium rest) const override;
  [[nodiscard]] bool pulls(const Eigen::VectorXd& /*load*/) const override { return true; }
  [[nodiscard]] double min_change(const Eigen::VectorXd& from, const Eigen::VectorXd& to,
                                  double share) const override;

  [[nodiscard]] EndSlopes slopes(const PostureAndLoad& at,
                                 const NetEquilibrium& rest) const override;

 private:
  /// Tendons at an equilibrium of the net.
  struct Stretched {
    Eigen::VectorXd length;      // lengths of lines, up to a constant [m] (muscles)
    Eigen::VectorXd exit_slope;  // derivative of each band's length through its exit by its
                                 // straight length [1] (pulls)
    Eigen::VectorXd tension;     // tensions of the tendons [N] (muscles)
    Eigen::VectorXd stiffness;   // stiffnesses of the tendons [N/m] (muscles)
    double energy = 0;           // [J]

    /// Returns whether the laws of all tendons gave finite values.
    [[nodiscard]] bool finite() const {
      return tension.allFinite() && stiffness.allFinite() && std::isfinite(energy);
    }
  };
  [[nodiscard]] Stretched stretched(const PostureAndLoad& at, const NetEquilibrium& rest) const;

  /// Computes the lengths of lines without the parts in the net [m] (muscles).
  [[nodiscard]] Eigen::VectorXd line_offsets(const Eigen::VectorXd& q) const;
  [[nodiscard]] Eigen::MatrixXd arms_outside(const Eigen::VectorXd& q) const;

  /// Returns the bands that have drawn their nodes so near to their exits that the net misses part
  /// of the pull.
  [[nodiscard]] std::vector<int> drawn_bands(const Stretched& now) const;

  /// Computes the derivatives of the pulls. @param R  moment arms outside the net (muscles,
  /// coordinates)
  [[nodiscard]] PullRates rates_of(const Stretched& now, const Eigen::MatrixXd& R) const;

  std::vector<std::shared_ptr<const TensionLaw>> laws_;
  /// Excess length of lines at exits in the initial equilibrium [m] (muscles).
  Eigen::VectorXd first_excess_;
};

/// Returns whether every muscle of a net pulls it by one band, and every muscle of the digit pulls
/// it at most once.
[[nodiscard]] bool pulls_one_band_each(const NetTendons& tendons);

}  // namespace thenar
