#pragma once

/// Pull of muscles on a net: by given tensions, or by tendons that stretch from given ends.

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "tendons/net/net_tendons.h"

namespace thenar {

/// Radius of the exit over which a tendon leaves the net, a choice of ours: a knot that is drawn in
/// rests within it, where the pull of a tendon to a point would have no slope [m].
inline constexpr double kExitRadius = 1e-4;

/// A posture, and what each muscle is given: its tension [N], or the place of the far end of its
/// tendon along its line, up to a constant [m], as a NetPull says.
struct PostureAndLoad {
  Eigen::VectorXd q;     // (coordinates) [rad]
  Eigen::VectorXd load;  // [N] or [m] (muscles)
};

/// Rates of the net's pulls while its bands keep their lengths.
struct PullRates {
  Eigen::MatrixXd by_posture;  // [N/rad] (pulls, coordinates)
  Eigen::MatrixXd by_load;     // [1] or [N/m] (pulls, muscles)
};

/// Potential energy of a net and its load, and what it changes by:  -tau dq + by_load dload.
struct NetPotential {
  double energy = 0;        // [J]
  Eigen::VectorXd tau;      // [N m] (coordinates)
  Eigen::VectorXd by_load;  // lengths of lines [m], or -tension [N] (muscles)
};

/// A torque that no integrator accepts, infinite, and why.
[[nodiscard]] TendonTorque no_torque(Eigen::Index joints, Eigen::Index muscles, std::string why);

/// A way to pull a net.
class NetPull {
 public:
  /// @param tendons  must outlive it
  explicit NetPull(const NetTendons& tendons) : tendons_(tendons) {}
  NetPull(const NetPull&) = delete;
  NetPull& operator=(const NetPull&) = delete;
  virtual ~NetPull() = default;

  [[nodiscard]] const NetTendons& tendons() const { return tendons_; }

  [[nodiscard]] virtual NetDrive drive(const PostureAndLoad& at) const = 0;

  [[nodiscard]] virtual PullRates rates(const PostureAndLoad& at,
                                        const NetEquilibrium& rest) const = 0;

  [[nodiscard]] virtual NetPotential potential(const PostureAndLoad& at,
                                               const NetEquilibrium& rest) const = 0;

  [[nodiscard]] virtual TendonTorque torque(const PostureAndLoad& at,
                                            NetEquilibrium rest) const = 0;

  /// Returns the slopes of torque, tensions and lengths by posture and ends of tendons; without the
  /// net where it is not differentiable; none where loads are tensions.
  [[nodiscard]] virtual EndSlopes slopes(const PostureAndLoad& /*at*/,
                                         const NetEquilibrium& /*rest*/) const {
    return {};
  }

  /// Returns whether a muscle pulls the net, so that its knots have a place.
  [[nodiscard]] virtual bool pulls(const Eigen::VectorXd& load) const = 0;

  /// The least change of loads that counts as a step.
  /// @param share  of the largest tension, where loads are tensions [1]
  [[nodiscard]] virtual double least_change(const Eigen::VectorXd& from, const Eigen::VectorXd& to,
                                            double share) const = 0;

  /// Equilibrium of the net, searched from `start` (3, nodes), or if empty from where links carry
  /// its nodes.
  [[nodiscard]] NetEquilibrium rest(const PostureAndLoad& at, const Eigen::Matrix3Xd& start) const {
    return tendons_.rest(at.q, drive(at), start);
  }

 private:
  const NetTendons& tendons_;
};

/// Loads are tensions [N].
class PullByTension : public NetPull {
 public:
  using NetPull::NetPull;
  [[nodiscard]] NetDrive drive(const PostureAndLoad& at) const override;
  [[nodiscard]] PullRates rates(const PostureAndLoad& at,
                                const NetEquilibrium& rest) const override;

  /// Potential of the net alone:  strain + t L.
  [[nodiscard]] NetPotential potential(const PostureAndLoad& at,
                                       const NetEquilibrium& rest) const override;
  [[nodiscard]] TendonTorque torque(const PostureAndLoad& at, NetEquilibrium rest) const override;
  [[nodiscard]] bool pulls(const Eigen::VectorXd& load) const override;
  [[nodiscard]] double least_change(const Eigen::VectorXd& from, const Eigen::VectorXd& to,
                                    double share) const override;
};

/// Loads are ends p of tendons [m]: each has the tension of its law at the length  L - p,  L that
/// of its line. Net and tendons rest in the least of one energy,  strain + sum U(L - p),  so a net
/// is found, too, where it would not rest under tensions that stay while it moves.
class PullByTendon : public NetPull {
 public:
  /// @param laws   of the tendon of each muscle; one law may serve several (muscles)
  /// @param first  where the net rests at first: lines over exits are measured from there, so that
  ///               they begin as long as DigitTendons::lengths() says
  /// @throws InputError if a muscle does not pull just one band, see pulls_one_band_each().
  PullByTendon(const NetTendons& tendons, std::vector<std::shared_ptr<const TensionLaw>> laws,
               const NetEquilibrium& first);

  [[nodiscard]] NetDrive drive(const PostureAndLoad& at) const override;
  [[nodiscard]] PullRates rates(const PostureAndLoad& at,
                                const NetEquilibrium& rest) const override;

  /// Potential of net and tendons:  strain + sum U(L - p);  infinite where a law is.
  [[nodiscard]] NetPotential potential(const PostureAndLoad& at,
                                       const NetEquilibrium& rest) const override;

  /// Torque without moment arms, with tensions and lengths; infinite, without these, where a law
  /// is.
  [[nodiscard]] TendonTorque torque(const PostureAndLoad& at, NetEquilibrium rest) const override;
  [[nodiscard]] bool pulls(const Eigen::VectorXd& /*load*/) const override { return true; }
  [[nodiscard]] double least_change(const Eigen::VectorXd& from, const Eigen::VectorXd& to,
                                    double share) const override;

  [[nodiscard]] EndSlopes slopes(const PostureAndLoad& at,
                                 const NetEquilibrium& rest) const override;

 private:
  /// Tendons where the net rests.
  struct Stretched {
    Eigen::VectorXd length;      // of lines, up to a constant [m] (muscles)
    Eigen::VectorXd exit_slope;  // of each band's length over its exit by its own [1] (pulls)
    Eigen::VectorXd tension;     // [N] (muscles)
    Eigen::VectorXd stiffness;   // [N/m] (muscles)
    double energy = 0;           // [J]

    /// Returns whether the laws of all tendons say numbers.
    [[nodiscard]] bool finite() const {
      return tension.allFinite() && stiffness.allFinite() && std::isfinite(energy);
    }
  };
  [[nodiscard]] Stretched stretched(const PostureAndLoad& at, const NetEquilibrium& rest) const;

  /// Lengths of lines but for what runs in the net over exits [m] (muscles).
  [[nodiscard]] Eigen::VectorXd line_offsets(const Eigen::VectorXd& q) const;
  [[nodiscard]] Eigen::MatrixXd arms_outside(const Eigen::VectorXd& q) const;

  /// Bands that have drawn their knots so near to their exits that the net misses part of the pull.
  [[nodiscard]] std::vector<int> drawn_bands(const Stretched& now) const;

  /// @param R  arms of what runs outside of the net (muscles, coordinates)
  [[nodiscard]] PullRates rates_of(const Stretched& now, const Eigen::MatrixXd& R) const;

  std::vector<std::shared_ptr<const TensionLaw>> laws_;
  Eigen::VectorXd first_excess_;  // what exits add to lines at the first rest [m] (muscles)
};

/// Returns whether every muscle of a net pulls it by one band, and every muscle of the digit once
/// at most.
[[nodiscard]] bool pulls_one_band_each(const NetTendons& tendons);

}  // namespace thenar
