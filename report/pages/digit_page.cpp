#include "report/pages/digit_page.h"

#include <algorithm>

#include <fmt/format.h>

#include "report/answers/digit_words.h"
#include "report/answers/passive_words.h"
#include "report/picture/digit_layers.h"
#include "report/picture/skin_layer.h"
#include "report/provenance.h"

namespace thenar {
Json digit_page(const DigitResult& about, const std::string& what, Json sections,
                const MeshTable& meshes, const std::string& learnt) {
  // State the built model in the provenance, which may be simpler than requested.
  const Fidelity fidelity = about.tendons ? about.tendons->digit().fidelity : Fidelity{};
  Json provenance = provenance_json(about.sources, fidelity);
  provenance["fidelity"] = about.built;
  return {{"title", fmt::format("thenar: {} of {}, {}", what, about.subject, about.digit)},
          {"subtitle", about.built},
          {"opening",
           opening_json(
               fmt::format("What are the {} of the {} of {}?", what, about.digit, about.subject),
               fmt::format("{} computed. Model: {}.",
                           about.single() ? "One posture was"
                                          : fmt::format("{} postures were", about.outcome.done),
                           about.built),
               learnt)},
          {"provenance", provenance},
          {"meshes", meshes.json()},
          {"sections", std::move(sections)}};
}

std::string range_words(const std::vector<double>& values, const std::string& unit) {
  if (values.empty()) return "";
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  const std::string low = fmt::format("{:.3g}", *least), high = fmt::format("{:.3g}", *most);
  return (low == high ? low : low + " to " + high) + " " + unit;
}

std::string digit_introduction(const DigitResult& about, const std::string& words) {
  std::string text = text_header(about);
  text = text.substr(0, text.find('\n')) + ".\n\n" + words;
  if (!passive_line(about).empty()) text += "\n\nPassive moments of the joints are counted.";
  for (const std::string& warning : about.outcome.warnings) text += "\n\nWarning: " + warning + ".";
  return text;
}

Json digit_scene(const DigitResult& about, const std::string& caption, MeshTable& meshes,
                 const AddLayers& add) {
  if (!about.tendons) return nullptr;
  // Draw some postures of a sweep in different tints.
  const TendonDigit& digit = about.tendons->digit();
  const SweepAxes axes = axes_of(about);
  Json layers = Json::array();
  std::size_t tint = 0;
  for (const std::size_t i : drawn_rows(about.outcome.done, kDrawnPostures)) {
    const Eigen::VectorXd& q = about.grid.postures[i];
    const std::string color = kPostureTints[tint++];
    Json bones = bone_layer(digit, q, color);
    if (!about.single()) bones["name"] = title_of(axes, i);
    layers.push_back(bones);
    // Wrapped and fitted tendons do not run from point to point.
    Json tendons = tendon_layer(digit, q, "tendons", "#cc79a7", about.single());
    if (tint == 1 && digit.fidelity.path == Path::kViaPoint && !tendons["items"].empty())
      layers.push_back(tendons);
    add(i, color, layers);
    // Skin is drawn once, in the first posture.
    if (tint > 1 || about.sources.empty()) continue;
    const SourceText& source = about.sources.front();
    const Subject subject = parse_subject(source.text, source.path);
    add_skin({subject, digit, pose_tree(digit.model.tree, q)}, meshes, layers);
  }
  // Look from the radial side and a little from the back.
  const Eigen::Matrix3d& tip = digit.model.tip_axes;
  return with(digit_scene_block(caption, tip, layers),
              {{"view", numbers3(tip.col(2) + 0.35 * tip.col(1))}});
}

double arrow_scale(double largest) { return largest > 0 ? 40 / largest : 1; }

Json arrow_layer(const std::string& name, const std::string& color, const Eigen::Vector3d& from,
                 const Eigen::Vector3d& vector) {
  return layer(
      name, color,
      Json::array({{{"kind", "arrow"}, {"from", in_mm(from)}, {"vector", numbers3(vector)}}}));
}

Json paired(const Json& charts) {
  Json rows = Json::array(), pair = Json::array();
  for (const Json& chart : charts) {
    pair.push_back(chart);
    if (pair.size() < 2) continue;
    rows.push_back(row_block(pair));
    pair = Json::array();
  }
  if (!pair.empty()) rows.push_back(pair.front());
  return rows;
}

}  // namespace thenar
