#pragma once

/// Splitting of chains into halves, and pooling by group.

#include <vector>

#include <Eigen/Core>

namespace thenar {

/// Returns the first and second halves of every chain as separate chains; the middle draw of an odd
/// number is left out (draws / 2, 2 chains).
/// @param x  draws in the unit of the quantity (draws, chains)
/// @throws InputError unless there is a chain, with at least 4 draws.
[[nodiscard]] Eigen::MatrixXd split_chains(const Eigen::Ref<const Eigen::MatrixXd>& x);

/// Interleaves the chains of each group into one longer chain, so that its halves are halves in
/// time (draws * walkers, groups).
/// @param group  group of each chain; all groups have the same number of chains
/// @throws InputError if group sizes differ, or there is not one entry for each chain.
[[nodiscard]] Eigen::MatrixXd pool_groups(const Eigen::Ref<const Eigen::MatrixXd>& x,
                                          const std::vector<int>& group);

/// Returns whether all draws are finite and at least two differ.
/// @param x  in the unit of the quantity (draws, chains)
[[nodiscard]] bool finite_and_varying(const Eigen::Ref<const Eigen::MatrixXd>& x);

}  // namespace thenar
