#pragma once

/// Cache of topologies fitted to the same records, so that none is fitted twice.

#include <map>
#include <vector>

#include "tendons/topology/fit_bands.h"

namespace thenar {

/// Presence of each candidate band (candidates).
using Topology = std::vector<bool>;

/// Topology with its fit.
struct FittedNet {
  Topology bands;
  BandFit fit;           // best fit of all starts
  bool settled = false;  // true: fitted from all starts of settle()
};

/// Cache of all topologies tried so far. Keeps a pointer: the fitter must outlive it.
class FittedNets {
 public:
  explicit FittedNets(BandFitter& fitter) : fitter_(&fitter) {}

  /// Fits a topology, or returns its fit if it is known. Where the net does not hold, typical,
  /// smallest and largest EA are tried as starts too.
  /// @param start  initial s; bands that it lacks start with their smallest EA, nearest to the net
  /// without them [1] (candidates)
  const BandFit& fit(const Topology& bands, const Eigen::VectorXd& start);

  /// Fits a topology again from typical, smallest and largest EA, and from `start`; keeps the best.
  void settle(const Topology& bands, const Eigen::VectorXd& start);

  /// Returns the topology of minimal  misfit + price * bands  that holds, or null.
  [[nodiscard]] const FittedNet* best(double price = 0) const;

  /// Returns the topology of minimal misfit that holds and has (or lacks) a band, or null.
  [[nodiscard]] const FittedNet* best_where(int band, bool present) const;

  /// Returns the misfit of best_where(); infinite if there is none.
  [[nodiscard]] double min_misfit(int band, bool present) const;

  /// Returns the nets that carry the loads with misfits within `doubt` of the smallest, best first.
  [[nodiscard]] std::vector<FittedNet> nets_within(double doubt) const;

  [[nodiscard]] bool contains(const Topology& bands) const { return tried_.count(bands) > 0; }
  [[nodiscard]] std::size_t size() const { return tried_.size(); }
  [[nodiscard]] BandFitter& fitter() { return *fitter_; }

 private:
  [[nodiscard]] std::vector<Eigen::VectorXd> usual_starts() const;
  BandFitter* fitter_;
  std::map<Topology, FittedNet> tried_;
};

/// Returns whether noise alone explains such a misfit: it is within 6 sd of its chi^2.
[[nodiscard]] bool noise_explains(const BandFit& fit);

/// Computes misfit + price * number of bands; infinite if the net does not hold.
[[nodiscard]] double score(const FittedNet& net, double price);

/// Returns at most `most` of the nets, those with the smallest scores, best first.
[[nodiscard]] std::vector<FittedNet> best_by_score(std::vector<FittedNet> nets, double price,
                                                   std::size_t most);

/// Returns the topology with one band added or removed.
[[nodiscard]] Topology flipped(Topology bands, int band);

/// Changes one band at a time as long as the score falls; two at once where no single change helps
/// and noise does not explain the misfit.
/// @param from   initial topology; returned if it does not hold
/// @param start  its s (candidates)
/// @return the topology where no change helps
Topology descend(FittedNets& tried, const Topology& from, const Eigen::VectorXd& start,
                 double price);

}  // namespace thenar
