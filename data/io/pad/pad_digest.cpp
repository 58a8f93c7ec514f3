#include "data/io/pad/pad_digest.h"

#include <vector>

#include <fmt/format.h>

#include "base/provenance.h"

namespace thenar {
namespace {

/// A number as the digest sees it; -0 is 0.
std::string digits(double value) { return fmt::format(" {:.12g}", value + 0.0); }

template <typename Numbers>
std::string line_of(const char* name, const Numbers& numbers) {
  std::string line = name;
  for (const double number : numbers) line += digits(number);
  return line + "\n";
}

std::string words_of(const PadTissueSpec& tissue) {
  return fmt::format("law {}\n", tissue.law) +
         line_of("tissue", std::vector{tissue.thickness, tissue.shear_modulus, tissue.exponent,
                                       tissue.poisson_ratio}) +
         line_of("shares", tissue.relaxation_share) + line_of("times", tissue.relaxation_time);
}

/// A skin of the pad's own. Meshes are what they are, wherever their file is.
std::string words_of(const ShapeSpec& skin) {
  std::string words = fmt::format("skin {}\n", name_of(skin.kind));
  words += line_of("size", skin.size.reshaped());
  words += line_of("exponents", skin.exponents.reshaped());
  words += line_of("place", skin.X_BS.p.reshaped());
  // Zeros of turns are round-off.
  const Eigen::Matrix3d turn = (1e12 * skin.X_BS.R.array()).round() / 1e12;
  words += line_of("turn", turn.reshaped());
  words += line_of("vertices", skin.mesh.vertices.reshaped());
  words += line_of("triangles", skin.mesh.triangles.cast<double>().eval().reshaped());
  return words;
}

}  // namespace

std::string pad_digest(const PadSpec& pad) {
  std::string words =
      line_of("shape", std::vector{pad.length, pad.width, pad.height, pad.bone_length,
                                   pad.bone_width, pad.bone_height});
  if (pad.skin) words += words_of(*pad.skin);
  words += words_of(pad.pulp);
  for (const PadTissueSpec& layer : pad.layers) words += words_of(layer);
  return sha256(words);
}

}  // namespace thenar
