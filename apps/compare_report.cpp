#include "apps/compare_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "report/page.h"
#include "report/pages/comparison.h"

namespace thenar {

bool write_compare_report(const Comparison& comparison, const std::vector<BodySpec>& objects,
                          const std::vector<NamedHand>& hands, const nlohmann::json& provenance,
                          const std::string& path, const Progress& progress) {
  std::vector<ComparePicture> pictures;
  for (const NamedHand& hand : hands) pictures.push_back({hand.name, hand.hand, hand.patches});
  MeshTable meshes;
  const Json sections = compare_page(comparison, objects, pictures, meshes, progress);
  if (progress.stop()) return false;
  write_report({{"title", "Hands compared"},
                {"subtitle", fmt::format("{}", fmt::join(comparison.hands, ", "))},
                {"provenance", provenance},
                {"meshes", meshes.json()},
                {"sections", sections}},
               path);
  return true;
}

}  // namespace thenar
