#pragma once

/// Topologies fitted to the same records, so that none is fitted twice.

#include <map>
#include <vector>

#include "tendons/topology/fit_bands.h"

namespace thenar {

/// Presence of each candidate band (candidates).
using Topology = std::vector<bool>;

/// One fitted topology.
struct FittedNet {
  Topology bands;
  BandFit fit;           // the best of all starts
  bool settled = false;  // fitted from all starts of settle()
};

/// Every topology tried so far, by its bands. Keeps a pointer: the fitter must outlive it.
class FittedNets {
 public:
  explicit FittedNets(BandFitter& fitter) : fitter_(&fitter) {}

  /// Fits a topology, or returns it if it was fitted before. Where the net does not hold, typical,
  /// least and most EA are tried as starts too.
  /// @param start  s to start from; bands that it lacks start with their least EA, nearest to the
  ///               net without them [1] (candidates)
  const BandFit& fit(const Topology& bands, const Eigen::VectorXd& start);

  /// Fits a topology again from typical, least and most EA, and from `start`; the best is kept.
  void settle(const Topology& bands, const Eigen::VectorXd& start);

  /// The one of least  misfit + price * bands  that holds, or null.
  [[nodiscard]] const FittedNet* best(double price = 0) const;

  /// The one of least misfit that holds and has (or lacks) a band, or null.
  [[nodiscard]] const FittedNet* best_where(int band, bool present) const;

  /// Its misfit; infinite if there is none.
  [[nodiscard]] double min_misfit(int band, bool present) const;

  /// Returns the nets that carry the loads with misfits within `doubt` of the least, best first.
  [[nodiscard]] std::vector<FittedNet> alike(double doubt) const;

  [[nodiscard]] bool knows(const Topology& bands) const { return tried_.count(bands) > 0; }
  [[nodiscard]] std::size_t size() const { return tried_.size(); }
  [[nodiscard]] BandFitter& fitter() { return *fitter_; }

 private:
  [[nodiscard]] std::vector<Eigen::VectorXd> usual_starts() const;
  BandFitter* fitter_;
  std::map<Topology, FittedNet> tried_;
};

/// Returns whether noise alone could leave such a misfit: within 6 sd of its chi^2.
[[nodiscard]] bool noise_explains(const BandFit& fit);

/// misfit + price * number of bands; infinite if the net does not hold.
[[nodiscard]] double score(const FittedNet& net, double price);

/// The topology with one band changed.
[[nodiscard]] Topology flipped(Topology bands, int band);

/// Changes one band as long as the score falls; two at once where no single change helps and the
/// misfit is more than noise could leave.
/// @param from   topology to start at; if it does not hold, it is returned
/// @param start  its s (candidates)
/// @return the topology where no change helps
Topology descend(FittedNets& tried, const Topology& from, const Eigen::VectorXd& start,
                 double price);

}  // namespace thenar
