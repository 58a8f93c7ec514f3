#pragma once

/// Draws told apart by gaps between them, knowing nothing of their density.

#include <vector>

#include <Eigen/Core>

namespace thenar {

struct ClumpOptions {
  double least_mass = 0.01;  // of a clump, as a share of all draws [1]
  double depth = 0.5;        // deepest valley that is none: density over that of the lower peak [1]
  double contrast = 5;       // least, in standard errors of the density [1]
  long draws = 10000;        // that are looked at, evenly spread; all are sorted in the end [1]
};

/// Cuts the draws by a plane across the deepest valley of any of split_directions(), and the parts
/// again, until no valley is deep and certain enough.
///
/// It cannot see: clumps lighter than least_mass; clumps whose shadows overlap along every straight
/// line (a ring around a core, two interlocked bows); clumps nearer than about 3.3 sds of a normal;
/// and what no chain has visited.
/// @param x  of each chain (n, draws)
/// @return   clump of each draw, 0 .. clumps - 1, heaviest first (draws, chains)
/// @throws InputError if a draw is not finite.
[[nodiscard]] Eigen::MatrixXi find_clumps(const std::vector<Eigen::MatrixXd>& x,
                                          const ClumpOptions& options = {});

/// Numbers from 0 by falling frequency in place of whatever labels there are (shape of labels).
[[nodiscard]] Eigen::MatrixXi by_falling_mass(const Eigen::MatrixXi& labels);

}  // namespace thenar
