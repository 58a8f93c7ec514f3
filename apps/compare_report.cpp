#include "apps/compare_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "apps/data_folder.h"
#include "apps/hand_by_name.h"
#include "viewer/compare_page.h"
#include "viewer/report_page.h"

namespace thenar {
namespace {

constexpr int kFine = 2500;  // triangles of each link of a human hand: many hands share a page

}  // namespace

bool write_compare_report(const Comparison& comparison, const std::vector<BodySpec>& objects,
                          const std::string& data, const nlohmann::json& provenance,
                          const std::string& path, const Progress& progress) {
  HumanHandOptions human;
  human.skin.drawn = kFine;
  std::vector<ComparePicture> pictures;
  for (const std::string& name : comparison.hands) {
    if (progress.stop()) return false;
    progress(0, "builds " + name + " to be drawn");
    const NamedHand hand = hand_by_name(name, data_folders(data), human);
    pictures.push_back({name, hand.hand, hand.patches});
  }
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
