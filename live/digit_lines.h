#pragma once

/// Tendons and net bands of one digit as lines of a live view.

#include <memory>
#include <string>
#include <vector>

#include "data/io/subject.h"
#include "live/live_picture.h"
#include "tendons/net/net_tendons.h"
#include "tendons/wrapping/path_solver.h"

namespace thenar {

/// Lines of a digit, each with a fixed number of points. A tendon is drawn from its insertion to
/// its first point on the digit's base; tendons with constant moment arms have no line. Tendons
/// that run over surfaces are drawn along their wrapped paths, even if their lengths come from
/// fitted polynomials.
class DigitLines {
 public:
  /// @param name     name of the digit
  /// @param tendons  tendons of that digit; ownership is shared
  DigitLines(const Subject& subject, const std::string& name,
             std::shared_ptr<const DigitTendons> tendons);

  [[nodiscard]] const std::vector<LiveLine>& lines() const { return lines_; }

  /// Returns the points of all lines, line after line, in the subject's frame [m] (3 each).
  /// @param state  poses of the digit's links
  /// @param rest   equilibrium of the net at that posture; ignored without a net
  [[nodiscard]] std::vector<Eigen::Vector3d> points(const TreeState<double>& state,
                                                    const NetEquilibrium& rest) const;

  /// Returns the tension of every line: of its strand (before sheath friction), of its band, or the
  /// pull of its muscle on the net. Bands of a net without equilibrium get NaN [N] (lines).
  /// @param q  posture [rad] (coordinates)
  /// @param t  tensions of the muscles [N] (muscles)
  [[nodiscard]] std::vector<double> tensions(const Eigen::VectorXd& q, const Eigen::VectorXd& t,
                                             const NetEquilibrium& rest) const;

 private:
  /// Source of a line: exactly one of these indices is not -1.
  struct Source {
    int strand = -1;  // entry of TendonModel::paths
    int muscle = -1;  // entry of BuiltNet::muscles, drawn along its own path
    int band = -1;    // band of the net
  };
  void add_line(const std::string& name, const std::string& digit, const Source& source,
                int points);
  void add_strand(int strand, const std::string& digit);
  void add_net(const std::string& digit);
  [[nodiscard]] const TendonModel<double>& model() const { return tendons_->digit().model; }
  [[nodiscard]] std::vector<Eigen::Vector3d> wrapped_points(const PathShape& shape,
                                                            const TreeState<double>& state) const;
  /// Returns the points of one line. @param shapes  wrapped shapes of paths_ in that posture
  [[nodiscard]] std::vector<Eigen::Vector3d> line_course(
      std::size_t line, const TreeState<double>& state, const NetEquilibrium& rest,
      const std::vector<PathShape>& shapes) const;

  std::shared_ptr<const DigitTendons> tendons_;  // shared with the caller
  const NetTendons* net_;                        // tendons_ if they have a net, else null
  std::vector<LiveLine> lines_;
  std::vector<Source> sources_;         // source of each line (lines)
  std::unique_ptr<PathSet> paths_;      // paths over surfaces; null: tendons run straight
  std::vector<int> path_of_strand_;     // entry of paths_; -1: none (strands)
  std::unique_ptr<PathSolver> solver_;  // solver of paths_; its workspace affects no result
};

}  // namespace thenar
