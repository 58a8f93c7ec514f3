#include "report/provenance.h"

#include "base/provenance.h"

namespace thenar {

nlohmann::json provenance_json(const std::vector<SourceText>& sources) {
  nlohmann::json out = nlohmann::json::object();
  for (const auto& [path, digest] : source_digests(sources)) out[path] = "sha256 " + digest;
  for (const auto& [name, version] : versions()) out[name] = version;
  return out;
}

nlohmann::json provenance_json(const std::vector<SourceText>& sources, const Fidelity& fidelity) {
  nlohmann::json out = provenance_json(sources);
  out["fidelity"] = describe(fidelity);
  return out;
}

}  // namespace thenar
