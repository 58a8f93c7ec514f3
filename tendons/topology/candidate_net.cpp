#include "tendons/topology/candidate_net.h"

#include <cmath>

#include "base/error.h"
#include "base/lists.h"

namespace thenar {

std::vector<CandidateBand> passive_candidates(const Net& net, double least, double most) {
  std::vector<CandidateBand> candidates;
  for (std::size_t b = 0; b < net.bands.size(); ++b)
    if (net.bands[b].muscle < 0)
      candidates.push_back({static_cast<int>(b), least * net.bands[b].EA, most * net.bands[b].EA});
  return candidates;
}

Net net_with_stiffness(const CandidateNet& candidate, const Eigen::VectorXd& EA) {
  Net net = candidate.net;
  std::vector<bool> absent(net.bands.size(), false);
  // Set the stiffnesses of the candidates.
  for (std::size_t c = 0; c < candidate.candidates.size(); ++c) {
    const double stiffness = EA(static_cast<Eigen::Index>(c));
    net.bands[candidate.candidates[c].band].EA = stiffness;
    absent[candidate.candidates[c].band] = stiffness <= 0;
  }
  // Remove bands of zero stiffness.
  std::vector<NetBand> kept;
  for (std::size_t b = 0; b < net.bands.size(); ++b)
    if (!absent[b]) kept.push_back(net.bands[b]);
  net.bands = std::move(kept);
  return net;
}

std::vector<std::string> candidate_names(const CandidateNet& candidate) {
  return transformed(candidate.candidates,
                     [&](const CandidateBand& c) { return candidate.net.bands[c.band].name; });
}

void check_candidates(const CandidateNet& candidate) {
  const Net& net = candidate.net;
  require(!candidate.candidates.empty(), "net {} has no candidate bands", net.name);
  // Check that each candidate is a passive band, named once, with bounds about its stiffness.
  std::vector<bool> seen(net.bands.size(), false);
  for (const CandidateBand& c : candidate.candidates) {
    require(c.band >= 0 && c.band < static_cast<int>(net.bands.size()),
            "net {} has no candidate band {}", net.name, c.band);
    const NetBand& band = net.bands[c.band];
    require(band.muscle < 0, "candidate {} is the band of a muscle", band.name);
    require(!seen[c.band], "candidate {} appears twice", band.name);
    seen[c.band] = true;
    require(c.min_EA > 0 && c.min_EA <= band.EA && band.EA <= c.max_EA && std::isfinite(c.max_EA),
            "candidate {}: wanted 0 < least <= EA <= most, got {} {} {} N", band.name, c.min_EA,
            band.EA, c.max_EA);
  }
}

void check_test(const CandidateNet& candidate, const TendonTest& test) {
  const Eigen::Index n = candidate.coordinates;
  // Check posture, tensions and own torques.
  const auto muscles = static_cast<Eigen::Index>(candidate.net.muscles.size());
  require(test.q.size() == n && test.q.allFinite(), "test {}: wanted {} finite angles, got {}",
          test.name, n, test.q.size());
  require(test.tension.size() == muscles && test.tension.allFinite() &&
              (test.tension.array() >= 0).all(),
          "test {}: wanted {} tensions >= 0, got {}", test.name, muscles, test.tension.size());
  require(test.tau_own.size() == 0 || (test.tau_own.size() == n && test.tau_own.allFinite()),
          "test {}: wanted {} torques, got {}", test.name, n, test.tau_own.size());
  // Check the map to readings.
  require(test.map.cols() == n && test.map.rows() > 0 && test.map.allFinite(),
          "test {}: wanted a finite map of {} torques, got {} x {}", test.name, n, test.map.rows(),
          test.map.cols());
}

void check_record(const CandidateNet& candidate, const TendonRecord& record) {
  check_test(candidate, record.test);
  const Eigen::Index rows = record.test.map.rows();
  require(record.measured.size() == rows && record.measured.allFinite(),
          "record {}: wanted {} finite readings, got {}", record.test.name, rows,
          record.measured.size());
  require(record.sd.size() == rows && record.sd.allFinite() && (record.sd.array() > 0).all(),
          "record {}: wanted {} standard deviations > 0, got {}", record.test.name, rows,
          record.sd.size());
}

}  // namespace thenar
