#pragma once

/// Chains cut in halves and pooled by group.

#include <vector>

#include <Eigen/Core>

namespace thenar {

/// First and second halves of every chain as chains of their own; of an odd number of draws the
/// middle one is left out (draws / 2, 2 chains).
/// @throws InputError unless there is a chain, with at least 4 draws.
[[nodiscard]] Eigen::MatrixXd split_chains(const Eigen::Ref<const Eigen::MatrixXd>& x);

/// Chains of one group as one longer chain in which the walkers take turns, so that its halves are
/// halves in time (draws * walkers, groups).
/// @param group  of each chain; groups are of one size
/// @throws InputError if they are not, or there is not one for each chain.
[[nodiscard]] Eigen::MatrixXd pool_groups(const Eigen::Ref<const Eigen::MatrixXd>& x,
                                          const std::vector<int>& group);

/// Every draw finite, and not all of them alike.
[[nodiscard]] bool finite_and_varying(const Eigen::Ref<const Eigen::MatrixXd>& x);

}  // namespace thenar
