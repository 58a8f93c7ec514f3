#include "kinematics_fit/bands/band_problems.h"

#include <map>
#include <memory>
#include <utility>

#include "base/error.h"
#include "base/lists.h"
#include "tendons/net/build_net.h"

namespace thenar {

std::vector<std::string> bands_matching(const Net& net, const std::vector<std::string>& globs) {
  std::vector<std::string> names;
  std::vector<bool> met(globs.size(), false);
  // Match the names of passive bands.
  for (const NetBand& band : net.bands) {
    if (band.muscle >= 0) continue;
    bool wanted = globs.empty();
    for (std::size_t g = 0; g < globs.size(); ++g)
      if (matches_glob(globs[g], band.name)) wanted = met[g] = true;
    if (wanted) names.push_back(band.name);
  }
  // Reject patterns without a match.
  for (std::size_t g = 0; g < globs.size(); ++g)
    require(met[g], "net {} has no passive band that matches '{}'", net.name, globs[g]);
  return names;
}

BandProblems::BandProblems(FitProblem all, FitSettings settings, std::vector<std::string> also_free,
                           std::vector<std::string> bands)
    : all_(std::move(all)),
      settings_(std::move(settings)),
      also_free_(std::move(also_free)),
      bands_(std::move(bands)) {
  require(all_.digit().net != nullptr, "bands are in question of a digit without a net");
  require(all_.specimens().size() == 1, "bands are inferred for one specimen, got {}",
          all_.specimens().size());
  require(!bands_.empty(), "no band is in question");
  for (const std::string& band : bands_) (void)cut(*all_.digit().net, band);
  // Make rules optional: a rule about an absent band matches nothing.
  for (ParameterRule& rule : settings_.rules) rule.optional = true;
}

FitProblem BandProblems::problem_with(const Topology& present) const {
  require(present.size() == bands_.size(), "{} bands are in question, got {}", bands_.size(),
          present.size());
  // Cut the absent bands from the digit.
  TendonDigit digit = all_.digit();
  BuiltNet net = *digit.net;
  for (std::size_t b = 0; b < bands_.size(); ++b)
    if (!present[b]) net = cut(net, bands_[b]);
  digit.net = std::make_shared<const BuiltNet>(std::move(net));

  // Choose parameters by the rules that still match one.
  const std::vector<std::string>& postures = all_.parameters().postures;
  const std::vector<Parameter> there = list_parameters(digit, postures);
  std::vector<std::string> also_free;
  for (const std::string& glob : also_free_)
    if (any_of(there, [&](const Parameter& p) { return matches_glob(glob, p.name); }))
      also_free.push_back(glob);
  FitParameters parameters = choose_parameters(digit, postures, settings_, also_free);
  return {std::move(digit),    std::move(parameters), all_.experiments(),
          all_.robust_scale(), all_.axis_distances(), all_.scaling()};
}

Eigen::VectorXd transfer_point(const std::vector<std::string>& names, const Eigen::VectorXd& z,
                               const FitProblem& to) {
  std::map<std::string, double> known;
  for (std::size_t i = 0; i < names.size(); ++i) known[names[i]] = z[i];
  // Copy entries by name, then clamp them to the bounds.
  Eigen::VectorXd out = Eigen::VectorXd::Zero(to.size());
  const std::vector<std::string> wanted = to.coordinates().names();
  for (std::size_t i = 0; i < wanted.size(); ++i)
    if (const auto at = known.find(wanted[i]); at != known.end()) out[i] = at->second;
  return out.cwiseMax(to.coordinates().lower()).cwiseMin(to.coordinates().upper());
}

}  // namespace thenar
