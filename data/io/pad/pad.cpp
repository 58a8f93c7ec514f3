#include "data/io/pad/pad.h"

#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "base/error.h"
#include "data/io/file_guard.h"
#include "data/io/mesh/shape_toml.h"
#include "data/io/toml_table.h"
#include "geometry/solid.h"

namespace thenar {
namespace {

constexpr int kMaxCellsAlong = 64;     // Largest number of cells along one way, before refinement
constexpr std::size_t kMaxLayers = 8;  // largest number of layers of skin
constexpr std::size_t kMaxTerms = 8;   // largest number of terms of relaxation
constexpr double kLongestPad = 0.2;    // Longest pad; longer ones have a wrong unit [m]
constexpr double kMaxShearModulus = 1e9;   // largest shear modulus [Pa]
constexpr double kMaxExponent = 1e3;       // largest |exponent| of a law [1]
constexpr double kMinPoisson = -0.999;     // smallest Poisson's ratio [1]
constexpr double kMaxPoisson = 0.4999999;  // largest Poisson's ratio [1]

/// Keys whose numbers are assumed. @throws DataError if the table has not one of them
std::vector<std::string> read_assumed(TomlTable& table) {
  if (!table.has("assumed")) return {};
  std::vector<std::string> keys = table.texts("assumed");
  for (const std::string& key : keys)
    if (!table.has(key)) table.fail(fmt::format("there is no '{}' to assume", key), "assumed");
  return keys;
}

double read_length(TomlTable& table, const std::string& key) {
  const double length = table.number(Dimension::kLength, key, Range::kPositive);
  if (length > kLongestPad)
    table.fail(fmt::format("wanted '{}' of at most {:g} m, got {:g} m", key, kLongestPad, length),
               key);
  return length;
}

/// A number of the bone that must be below that of the skin.
double read_below(TomlTable& table, const std::string& key, double skin) {
  const double bone = read_length(table, key);
  if (bone >= skin)
    table.fail(fmt::format("wanted '{}' below that of the skin, {:g} m, got {:g} m: the bone lies "
                           "within its skin",
                           key, skin, bone),
               key);
  return bone;
}

void read_shape(TomlTable& top, PadSpec& pad) {
  TomlTable table =
      needed_table(top, "shape", "wanted [shape], the lengths of skin and bone, got none");
  pad.length = read_length(table, "length");
  pad.width = read_length(table, "width");
  pad.height = read_length(table, "height");
  pad.bone_length = read_below(table, "bone_length", pad.length);
  pad.bone_width = read_below(table, "bone_width", pad.width);
  pad.bone_height = read_below(table, "bone_height", pad.height);
  pad.shape_source = table.source();
  pad.shape_assumed = read_assumed(table);
  table.done();
}

/// A closed skin of its own; what cannot bound a solid is refused where it stands.
void read_skin(TomlTable& top, const std::string& path, PadSpec& pad) {
  std::optional<TomlTable> table = top.table("skin");
  if (!table) return;
  ShapeSpec skin = read_shape_table(*table, path);
  try {
    (void)build_solid({skin});
  } catch (const InputError& error) {
    table->fail(fmt::format("wanted a closed skin: {}", error.what()));
  }
  pad.files.merge(mesh_files({skin}, path));
  pad.skin = std::move(skin);
}

double read_exponent(TomlTable& table, const std::string& law) {
  if (!has_exponent(law)) return 0;
  const double k = table.number(Dimension::kNumber, "exponent");
  const bool fits = law == "ogden" ? k != 0 : k > 0;
  if (!fits || std::abs(k) > kMaxExponent)
    table.fail(fmt::format("wanted 'exponent' {} and at most {:g} for the law '{}', got {:g}",
                           law == "ogden" ? "other than 0" : "above 0", kMaxExponent, law, k),
               "exponent");
  return k;
}

void read_relaxation(TomlTable& table, PadTissueSpec& tissue) {
  const bool shares = table.has("relaxation_share");
  if (!shares && !table.has(Dimension::kTime, "relaxation_time")) return;
  tissue.relaxation_share =
      table.numbers(Dimension::kNumber, "relaxation_share", 0, Range::kNotNegative);
  tissue.relaxation_time = table.numbers(Dimension::kTime, "relaxation_time", 0, Range::kPositive);
  const std::size_t count = tissue.relaxation_share.size();
  if (count != tissue.relaxation_time.size())
    table.fail(fmt::format("wanted as many 'relaxation_time' as 'relaxation_share', {}, got {}",
                           count, tissue.relaxation_time.size()),
               "relaxation_time");
  if (count > kMaxTerms)
    table.fail(fmt::format("wanted at most {} terms of relaxation, got {}", kMaxTerms, count),
               "relaxation_share");
  const double sum =
      std::accumulate(tissue.relaxation_share.begin(), tissue.relaxation_share.end(), 0.0);
  if (sum >= 1)
    table.fail(fmt::format("wanted shares of relaxation that sum to less than 1, got {:g}", sum),
               "relaxation_share");
}

PadTissueSpec read_tissue(TomlTable& table, bool is_layer) {
  PadTissueSpec tissue;
  if (is_layer) tissue.thickness = read_length(table, "thickness");
  tissue.law = table.choice("law", tissue_law_names());
  tissue.shear_modulus = table.number(Dimension::kStress, "shear_modulus", Range::kPositive);
  if (tissue.shear_modulus > kMaxShearModulus)
    table.fail(fmt::format("wanted 'shear_modulus' of at most {:g} Pa, got {:g} Pa",
                           kMaxShearModulus, tissue.shear_modulus),
               "shear_modulus");
  tissue.exponent = read_exponent(table, tissue.law);
  tissue.poisson_ratio = table.number(Dimension::kNumber, "poisson_ratio");
  if (!(tissue.poisson_ratio >= kMinPoisson && tissue.poisson_ratio <= kMaxPoisson))
    table.fail(fmt::format("wanted 'poisson_ratio' in {}..{}, got {}", kMinPoisson, kMaxPoisson,
                           tissue.poisson_ratio),
               "poisson_ratio");
  read_relaxation(table, tissue);
  tissue.source = table.source();
  tissue.assumed = read_assumed(table);
  table.done();
  return tissue;
}

int read_count(TomlTable& table, const std::string& key, int fallback) {
  const double count = table.number_or(Dimension::kNumber, key, fallback);
  if (count != std::floor(count) || count < 1 || count > kMaxCellsAlong)
    table.fail(
        fmt::format("wanted '{}' as a whole number in 1..{}, got {:g}", key, kMaxCellsAlong, count),
        key);
  return static_cast<int>(count);
}

void read_cells(TomlTable& top, PadSpec& pad) {
  std::optional<TomlTable> table = top.table("cells");
  if (!table) return;
  if (table->has("element")) pad.element = table->choice("element", pad_element_names());
  pad.across = read_count(*table, "across", pad.across);
  pad.around = read_count(*table, "around", pad.around);
  pad.through = read_count(*table, "through", pad.through);
  table->done();
}

void add_assumed(const std::string& table, const std::vector<std::string>& keys,
                 std::vector<std::string>& to) {
  for (const std::string& key : keys) to.push_back(fmt::format("{} of {}", key, table));
}

}  // namespace

const std::vector<std::string>& tissue_law_names() {
  static const std::vector<std::string> names{"neo-hookean", "ogden", "veronda-westmann"};
  return names;
}

const std::vector<std::string>& pad_element_names() {
  static const std::vector<std::string> names{"Q1", "Q1P0", "F-bar", "Q2P1"};
  return names;
}

bool has_exponent(const std::string& law) { return law != "neo-hookean"; }

PadSpec read_pad(const std::string& path) {
  PadSpec pad = parse_pad(read_guarded(path, GuardedKind::kToml), path);
  pad.files.merge(digests_of({path}));
  return pad;
}

PadSpec parse_pad(const std::string& text, const std::string& path) {
  const TomlFile file(text, path);
  TomlTable top = file.top();
  PadSpec pad;
  pad.name = top.text("name");
  pad.description = top.text_or("description", "");
  read_shape(top, pad);
  read_skin(top, path, pad);
  // Tissues: the pulp, and layers of skin over it.
  TomlTable pulp =
      needed_table(top, "pulp", "wanted [pulp], the tissue between bone and skin, got none");
  pad.pulp = read_tissue(pulp, false);
  std::vector<TomlTable> layers = top.tables("layer");
  if (layers.size() > kMaxLayers)
    layers[kMaxLayers].fail(
        fmt::format("wanted at most {} layers of skin, got {}", kMaxLayers, layers.size()));
  double thick = 0;
  for (TomlTable& layer : layers) {
    pad.layers.push_back(read_tissue(layer, true));
    thick += pad.layers.back().thickness;
    if (!pad.skin && thick >= pad.height - pad.bone_height)
      layer.fail(fmt::format("wanted layers thinner than all over the bone, {:g} mm, got {:g} mm",
                             1e3 * (pad.height - pad.bone_height), 1e3 * thick),
                 "thickness");
  }
  read_cells(top, pad);
  pad.own_sources = file.own_sources();
  top.done();
  return pad;
}

std::vector<std::string> assumed_words(const PadSpec& pad) {
  std::vector<std::string> words;
  add_assumed("[shape]", pad.shape_assumed, words);
  add_assumed("[pulp]", pad.pulp.assumed, words);
  for (std::size_t i = 0; i < pad.layers.size(); ++i)
    add_assumed(fmt::format("[[layer]] {}", i + 1), pad.layers[i].assumed, words);
  return words;
}

}  // namespace thenar
