#pragma once

/// Tendons and bands of one digit as lines of a live view, each with as many points in every
/// posture.

#include <memory>
#include <string>
#include <vector>

#include "data/io/subject.h"
#include "live/live_picture.h"
#include "tendons/net/net_tendons.h"
#include "tendons/wrapping/path_solver.h"

namespace thenar {

/// The lines of a digit. Tendons are drawn from their insertion to where they leave the digit's
/// base; those whose arms are constants have no line. Paths over surfaces are drawn as they wrap,
/// also where their lengths come from fitted polynomials.
class DigitLines {
 public:
  /// @param tendons  of that digit of the subject; it is shared
  DigitLines(const Subject& subject, const std::string& name,
             std::shared_ptr<const DigitTendons> tendons);

  [[nodiscard]] const std::vector<LiveLine>& lines() const { return lines_; }

  /// Points of all lines, one after the other, subject's frame [m] (3 each).
  /// @param state  links of the digit
  /// @param rest   of the net at that posture; of tendons without a net it is not read
  [[nodiscard]] std::vector<Eigen::Vector3d> points(const TreeState<double>& state,
                                                    const NetEquilibrium& rest) const;

  /// Tension of every line: that of its strand before friction in sheaths, of its band, or what its
  /// muscle gives the net; NaN of bands of a net without balance [N] (lines).
  /// @param q  [rad] (coordinates);  @param t  of each muscle [N] (muscles)
  [[nodiscard]] std::vector<double> tensions(const Eigen::VectorXd& q, const Eigen::VectorXd& t,
                                             const NetEquilibrium& rest) const;

 private:
  /// Source of a line: exactly one of these indices is not -1.
  struct Source {
    int strand = -1;  // of the model's paths
    int muscle = -1;  // entry of BuiltNet::muscles, its own path
    int band = -1;    // of the net
  };
  void add(const std::string& name, const std::string& digit, const Source& source, int points);
  void add_strand(int strand, const std::string& digit);
  void add_net(const std::string& digit);
  [[nodiscard]] const TendonModel<double>& model() const { return tendons_->digit().model; }
  [[nodiscard]] std::vector<Eigen::Vector3d> wrapped(const PathShape& shape,
                                                     const TreeState<double>& state) const;
  /// @param shapes  of paths_ at that posture
  [[nodiscard]] std::vector<Eigen::Vector3d> course(std::size_t line,
                                                    const TreeState<double>& state,
                                                    const NetEquilibrium& rest,
                                                    const std::vector<PathShape>& shapes) const;

  std::shared_ptr<const DigitTendons> tendons_;  // shared with whoever asks them for torques
  const NetTendons* net_;                        // the same with a net; null: none
  std::vector<LiveLine> lines_;
  std::vector<Source> sources_;         // (lines)
  std::unique_ptr<PathSet> paths_;      // over surfaces; null: tendons run straight
  std::vector<int> path_of_strand_;     // entry of paths_; -1: none (strands)
  std::unique_ptr<PathSolver> solver_;  // of paths_; its room changes no answer
};

}  // namespace thenar
