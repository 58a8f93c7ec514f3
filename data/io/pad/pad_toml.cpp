#include <array>
#include <set>
#include <sstream>

#include <fmt/format.h>

#include "base/lists.h"
#include "data/io/mesh/shape_toml.h"
#include "data/io/pad/pad.h"
#include "data/io/toml_text.h"

namespace thenar {
namespace {

/// Quantities and the keys that this text has for them.
constexpr std::array kQuantityKeys{"length_mm",      "width_mm",          "height_mm",
                                   "bone_length_mm", "bone_width_mm",     "bone_height_mm",
                                   "thickness_mm",   "shear_modulus_kPa", "relaxation_time_s"};

/// A key that is assumed may have had another unit: the key of this text.
std::string our_key(const std::string& key) {
  for (const std::string ours : kQuantityKeys) {
    const std::string base = ours.substr(0, ours.rfind('_') + 1);
    if (key.rfind(base, 0) == 0 && key.find('_', base.size()) == std::string::npos) return ours;
  }
  return key;
}

void add(std::string& text, const std::string& key, const std::string& value) {
  text += key + " = " + value + "\n";
}
void add(std::string& text, const std::string& key, double value) {
  add(text, key, fmt::format("{:.15g}", value));
}

void add_sources(std::string& text, const std::string& source,
                 const std::vector<std::string>& assumed) {
  if (!source.empty()) add(text, "source", toml_keys(source));
  if (!assumed.empty()) add(text, "assumed", toml_list(transformed(assumed, our_key)));
}

void add_tissue(std::string& text, const PadTissueSpec& tissue) {
  if (tissue.thickness > 0) add(text, "thickness_mm", tissue.thickness * 1e3);
  add(text, "law", toml_quoted(tissue.law));
  add(text, "shear_modulus_kPa", tissue.shear_modulus * 1e-3);
  if (has_exponent(tissue.law)) add(text, "exponent", tissue.exponent);
  add(text, "poisson_ratio", tissue.poisson_ratio);
  if (!tissue.relaxation_share.empty()) {
    add(text, "relaxation_share", toml_list(tissue.relaxation_share));
    add(text, "relaxation_time_s", toml_list(tissue.relaxation_time));
  }
  add_sources(text, tissue.source, tissue.assumed);
}

/// [sources] of the keys that data/sources.bib has not.
void add_own_sources(std::string& text, const PadSpec& pad) {
  std::set<std::string> keys;
  const auto note = [&](const std::string& cited) {
    for (const std::string& key : keys_in(cited)) keys.insert(key);
  };
  note(pad.shape_source);
  note(pad.pulp.source);
  for (const PadTissueSpec& layer : pad.layers) note(layer.source);
  const std::vector<std::string>& known = known_sources();
  std::string lines;
  for (const std::string& key : keys) {
    if (contains(known, key)) continue;
    const auto own = pad.own_sources.find(key);
    add(lines, key, toml_quoted(own == pad.own_sources.end() ? "Unstated" : own->second));
  }
  if (!lines.empty()) text += "\n[sources]\n" + lines;
}

}  // namespace

std::string pad_toml(const PadSpec& pad, const std::string& comment) {
  std::string text;
  std::istringstream lines(comment);
  for (std::string line; std::getline(lines, line);)
    text += line.empty() ? "#\n" : "# " + line + "\n";
  if (!text.empty()) text += "\n";
  add(text, "name", toml_quoted(pad.name));
  if (!pad.description.empty()) add(text, "description", toml_quoted(pad.description));
  add_own_sources(text, pad);
  text += "\n[shape]\n";
  add(text, "length_mm", pad.length * 1e3);
  add(text, "width_mm", pad.width * 1e3);
  add(text, "height_mm", pad.height * 1e3);
  add(text, "bone_length_mm", pad.bone_length * 1e3);
  add(text, "bone_width_mm", pad.bone_width * 1e3);
  add(text, "bone_height_mm", pad.bone_height * 1e3);
  add_sources(text, pad.shape_source, pad.shape_assumed);
  if (pad.skin) {
    text += "\n[skin]\n";
    for (const std::string& line : toml_of(*pad.skin)) text += line + "\n";
    add_sources(text, pad.shape_source, {});
  }
  text += "\n[pulp]\n";
  add_tissue(text, pad.pulp);
  for (const PadTissueSpec& layer : pad.layers) {
    text += "\n[[layer]]\n";
    add_tissue(text, layer);
  }
  text += "\n[cells]\n";
  add(text, "element", toml_quoted(pad.element));
  add(text, "across", pad.across);
  add(text, "around", pad.around);
  add(text, "through", pad.through);
  add_sources(text, pad.shape_source, {});
  return text;
}

}  // namespace thenar
