#include "data/io/pad/law_file.h"

#include <array>
#include <cmath>
#include <utility>

#include "base/error.h"
#include "data/io/pad/pad_digest.h"
#include "data/io/toml_table.h"
#include "data/io/toml_text.h"

namespace thenar {
namespace {

TomlTable law_table(TomlTable& top, const std::string& key) {
  return needed_table(top, key, fmt::format("wanted a table [{}]", key));
}

/// A constant of a law: its key without unit, which the file has in SI.
template <typename Constants>
struct Key {
  const char* base;
  Dimension dimension;
  double Constants::*value;
};
constexpr std::array<Key<PowerLawConstants>, 6> kPowerKeys{
    {{"force", Dimension::kForce, &PowerLawConstants::force},
     {"depth_exponent", Dimension::kNumber, &PowerLawConstants::depth_exponent},
     {"patch", Dimension::kLength, &PowerLawConstants::patch},
     {"patch_exponent", Dimension::kNumber, &PowerLawConstants::patch_exponent},
     {"torsion", Dimension::kNumber, &PowerLawConstants::torsion},
     {"shear", Dimension::kStress, &PowerLawConstants::shear}}};
constexpr std::array<Key<SoftFingerConstants>, 9> kSoftFingerKeys{
    {{"force", Dimension::kForce, &SoftFingerConstants::force},
     {"depth_exponent", Dimension::kNumber, &SoftFingerConstants::depth_exponent},
     {"radius_exponent", Dimension::kNumber, &SoftFingerConstants::radius_exponent},
     {"patch", Dimension::kLength, &SoftFingerConstants::patch},
     {"patch_exponent", Dimension::kNumber, &SoftFingerConstants::patch_exponent},
     {"patch_radius", Dimension::kNumber, &SoftFingerConstants::patch_radius},
     {"aspect", Dimension::kNumber, &SoftFingerConstants::aspect},
     {"torsion", Dimension::kNumber, &SoftFingerConstants::torsion},
     {"shear", Dimension::kStress, &SoftFingerConstants::shear}}};
constexpr std::array<Key<FoundationConstants>, 7> kFoundationKeys{
    {{"modulus", Dimension::kStress, &FoundationConstants::modulus},
     {"exponent", Dimension::kNumber, &FoundationConstants::exponent},
     {"stiffening", Dimension::kNumber, &FoundationConstants::stiffening},
     {"surround", Dimension::kNumber, &FoundationConstants::surround},
     {"spread", Dimension::kNumber, &FoundationConstants::spread},
     {"thickness", Dimension::kLength, &FoundationConstants::thickness},
     {"shear", Dimension::kStress, &FoundationConstants::shear}}};
constexpr std::array<std::pair<const char*, RelativeError LawError::*>, 5> kErrorKeys{
    {{"force", &LawError::force},
     {"area", &LawError::area},
     {"radius", &LawError::radius},
     {"torsion", &LawError::torsion},
     {"shear", &LawError::shear}}};

template <typename Constants, std::size_t N>
std::string constants_text(const std::string& title, const std::array<Key<Constants>, N>& keys,
                           const Constants& values) {
  std::string out = fmt::format("\n[{}]\n", title);
  for (const Key<Constants>& key : keys)
    out +=
        fmt::format("{} = {}\n", si_key(key.base, key.dimension), toml_number(values.*key.value));
  return out;
}

LawError read_errors(TomlTable& law, const std::string& key) {
  TomlTable table = law_table(law, key);
  LawError error;
  for (const auto& [base, value] : kErrorKeys) {
    const std::vector<double> pair =
        table.numbers(Dimension::kNumber, base, 2, Range::kNotNegative);
    error.*value = {pair[0], pair[1]};
  }
  table.done();
  return error;
}

int read_count(TomlTable& table, const std::string& key) {
  const double count = table.number(Dimension::kNumber, key, Range::kNotNegative);
  if (count != std::floor(count) || count > 1e6)
    table.fail(fmt::format("wanted '{}' to be a whole number, got {}", key, count), key);
  return static_cast<int>(count);
}

/// The pad's version; files from before there were digests have none.
std::string read_digest(TomlTable& top) {
  const std::string digest = top.text_or("pad_digest", "");
  const bool hex = digest.find_first_not_of("0123456789abcdef") == std::string::npos;
  if (top.has("pad_digest") && !(hex && digest.size() == 64))
    top.fail(fmt::format("wanted 'pad_digest' of 64 hexadecimal digits, got '{}'", digest),
             "pad_digest");
  return digest;
}

void read_evidence(TomlTable& top, LawEvidence& evidence) {
  TomlTable table = law_table(top, "evidence");
  evidence.fitted = read_count(table, "fitted");
  evidence.checked = read_count(table, "checked");
  evidence.depth = table.number(Dimension::kLength, "depth", Range::kNotNegative);
  evidence.force = table.number(Dimension::kForce, "force", Range::kNotNegative);
  evidence.force_error = table.number(Dimension::kNumber, "force_error", Range::kNotNegative);
  table.done();
}

/// Reads the constants and the error of a law; the table may hold more.
template <typename Constants, std::size_t N, typename Check>
TomlTable read_law(TomlTable& top, const std::string& title,
                   const std::array<Key<Constants>, N>& keys, const Check& check, Constants& out,
                   LawError& error) {
  TomlTable table = law_table(top, title);
  for (const Key<Constants>& key : keys) out.*key.value = table.number(key.dimension, key.base);
  internal::check_here(table, [&] { check(out); });
  error = read_errors(table, "error");
  return table;
}

void read_law_tables(TomlTable& top, CalibratedLaws& laws) {
  const auto power = [](const PowerLawConstants& c) { (void)PowerLaw(c); };
  read_law(top, "power_law", kPowerKeys, power, laws.power, laws.power_error).done();
  const auto finger = [](const SoftFingerConstants& c) { (void)SoftFinger(c); };
  read_law(top, "soft_finger", kSoftFingerKeys, finger, laws.soft_finger, laws.soft_finger_error)
      .done();
  TomlTable foundation = read_law(top, "elastic_foundation", kFoundationKeys, check_foundation,
                                  laws.foundation, laws.foundation_error);
  laws.bed_error = read_errors(foundation, "bed_error");
  foundation.done();
}

std::string error_text(const std::string& title, const LawError& error) {
  std::string out =
      fmt::format("\n[{}]  # [rms, worst] over the presses that were checked\n", title);
  for (const auto& [base, value] : kErrorKeys) {
    const RelativeError& each = error.*value;
    out += fmt::format("{} = {}\n", base, toml_list(std::vector{each.rms, each.worst}));
  }
  return out;
}

}  // namespace

CalibratedLaws parse_laws(const std::string& text, const std::string& path) {
  const TomlFile file(text, path);
  TomlTable top = file.top();
  CalibratedLaws laws;
  laws.name = top.text("name");
  laws.pad_digest = read_digest(top);
  read_evidence(top, laws.evidence);
  // Relaxation, of all laws.
  for (TomlTable& table : top.tables("relaxation")) {
    laws.relaxation.push_back({table.number(Dimension::kNumber, "share", Range::kFraction),
                               table.number(Dimension::kTime, "time", Range::kPositive)});
    table.done();
  }
  internal::check_here(top, [&] { check_exponential_terms(laws.relaxation, "a pad"); });
  read_law_tables(top, laws);
  top.done();
  return laws;
}

CalibratedLaws read_laws(const std::string& path) { return parse_laws(read_text_file(path), path); }

std::string laws_text(const CalibratedLaws& laws, const std::string& source) {
  check_laws(laws);
  require(!laws.name.empty() && !source.empty(), "laws need a name and a source to be written");
  std::string out = fmt::format("name = {}\n", toml_quoted(laws.name));
  if (!laws.pad_digest.empty())
    out += fmt::format("pad_digest = {}\n", toml_quoted(laws.pad_digest));
  out += fmt::format("source = \"Elements\"\n\n[sources]\nElements = {}\n", toml_quoted(source));
  const LawEvidence& e = laws.evidence;
  out += fmt::format(
      "\n[evidence]\nfitted = {}\nchecked = {}\ndepth_m = {}\nforce_N = {}\nforce_error = {}\n",
      e.fitted, e.checked, toml_number(e.depth), toml_number(e.force), toml_number(e.force_error));
  for (const ExponentialTerm& term : laws.relaxation)
    out += fmt::format("\n[[relaxation]]\nshare = {}\ntime_s = {}\n", toml_number(term.share),
                       toml_number(term.time));
  out += constants_text("power_law", kPowerKeys, laws.power);
  out += error_text("power_law.error", laws.power_error);
  out += constants_text("soft_finger", kSoftFingerKeys, laws.soft_finger);
  out += error_text("soft_finger.error", laws.soft_finger_error);
  out += constants_text("elastic_foundation", kFoundationKeys, laws.foundation);
  out += error_text("elastic_foundation.error", laws.foundation_error);
  out += error_text("elastic_foundation.bed_error", laws.bed_error);
  return out;
}

std::string version_doubt(const CalibratedLaws& laws, const PadSpec& pad) {
  if (laws.pad_digest.empty() || laws.pad_digest == pad_digest(pad)) return "";
  return fmt::format(
      "laws were fitted to another version of pad '{}': its shape or tissue has changed since; "
      "`thenar pad laws` fits them again",
      pad.name);
}

}  // namespace thenar
