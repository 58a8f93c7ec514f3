#include "data/io/pad/law_file.h"

#include <cmath>
#include <functional>

#include "base/error.h"
#include "base/file_io.h"
#include "data/io/toml_table.h"
#include "data/io/toml_text.h"

namespace thenar {
namespace {

TomlTable law_table(TomlTable& top, const std::string& key) {
  std::optional<TomlTable> table = top.table(key);
  if (!table) top.fail(fmt::format("wanted a table [{}]", key));
  return *table;
}

/// Runs a check of a law, whose complaints are those of its table.
void checked(const TomlTable& table, const std::function<void()>& check) {
  try {
    check();
  } catch (const InputError& error) {
    table.fail(error.what());
  }
}

RelativeError read_error(TomlTable& table, const std::string& key) {
  const std::vector<double> pair = table.numbers(Dimension::kNumber, key, 2, Range::kNotNegative);
  return {pair[0], pair[1]};
}

LawError read_errors(TomlTable& law, const std::string& key) {
  TomlTable table = law_table(law, key);
  LawError error{read_error(table, "force"), read_error(table, "area"), read_error(table, "radius"),
                 read_error(table, "torsion")};
  table.done();
  return error;
}

int read_count(TomlTable& table, const std::string& key) {
  const double count = table.number(Dimension::kNumber, key, Range::kNotNegative);
  if (count != std::floor(count) || count > 1e6)
    table.fail(fmt::format("wanted '{}' to be a whole number, got {}", key, count), key);
  return static_cast<int>(count);
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

void read_power(TomlTable& top, CalibratedLaws& laws) {
  TomlTable table = law_table(top, "power_law");
  laws.power.force = table.number(Dimension::kForce, "force");
  laws.power.depth_exponent = table.number(Dimension::kNumber, "depth_exponent");
  laws.power.patch = table.number(Dimension::kLength, "patch");
  laws.power.patch_exponent = table.number(Dimension::kNumber, "patch_exponent");
  laws.power.torsion = table.number(Dimension::kNumber, "torsion");
  checked(table, [&] { (void)PowerLaw(laws.power); });
  laws.power_error = read_errors(table, "error");
  table.done();
}

void read_soft_finger(TomlTable& top, CalibratedLaws& laws) {
  TomlTable table = law_table(top, "soft_finger");
  SoftFingerConstants& c = laws.soft_finger;
  c.force = table.number(Dimension::kForce, "force");
  c.depth_exponent = table.number(Dimension::kNumber, "depth_exponent");
  c.radius_exponent = table.number(Dimension::kNumber, "radius_exponent");
  c.patch = table.number(Dimension::kLength, "patch");
  c.patch_exponent = table.number(Dimension::kNumber, "patch_exponent");
  c.patch_radius = table.number(Dimension::kNumber, "patch_radius");
  c.aspect = table.number(Dimension::kNumber, "aspect");
  c.torsion = table.number(Dimension::kNumber, "torsion");
  checked(table, [&] { (void)SoftFinger(c); });
  laws.soft_finger_error = read_errors(table, "error");
  table.done();
}

void read_foundation(TomlTable& top, CalibratedLaws& laws) {
  TomlTable table = law_table(top, "elastic_foundation");
  FoundationConstants& c = laws.foundation;
  c.modulus = table.number(Dimension::kStress, "modulus");
  c.exponent = table.number(Dimension::kNumber, "exponent");
  c.stiffening = table.number(Dimension::kNumber, "stiffening");
  c.surround = table.number(Dimension::kNumber, "surround");
  c.spread = table.number(Dimension::kNumber, "spread");
  c.thickness = table.number(Dimension::kLength, "thickness");
  c.shear = table.number(Dimension::kStress, "shear");
  checked(table, [&] { check_foundation(c); });
  laws.foundation_error = read_errors(table, "error");
  laws.bed_error = read_errors(table, "bed_error");
  table.done();
}

std::string error_text(const std::string& title, const LawError& error) {
  std::string out =
      fmt::format("\n[{}]  # [rms, worst] over the presses that were checked\n", title);
  const auto add = [&](const char* key, const RelativeError& e) {
    out += fmt::format("{} = {}\n", key, toml_list(std::vector{e.rms, e.worst}));
  };
  add("force", error.force);
  add("area", error.area);
  add("radius", error.radius);
  add("torsion", error.torsion);
  return out;
}

/// A number and its key, with its unit.
struct Line {
  const char* key;
  double value;
};
std::string table_text(const std::string& title, const std::vector<Line>& lines) {
  std::string out = fmt::format("\n[{}]\n", title);
  for (const Line& line : lines) out += fmt::format("{} = {}\n", line.key, toml_number(line.value));
  return out;
}

}  // namespace

CalibratedLaws parse_laws(const std::string& text, const std::string& path) {
  const TomlFile file(text, path);
  TomlTable top = file.top();
  CalibratedLaws laws;
  laws.name = top.text("name");
  read_evidence(top, laws.evidence);
  // Relaxation, of all laws.
  for (TomlTable& table : top.tables("relaxation")) {
    laws.relaxation.push_back({table.number(Dimension::kNumber, "share", Range::kFraction),
                               table.number(Dimension::kTime, "time", Range::kPositive)});
    table.done();
  }
  checked(top, [&] { check_exponential_terms(laws.relaxation, "a pad"); });
  read_power(top, laws);
  read_soft_finger(top, laws);
  read_foundation(top, laws);
  top.done();
  return laws;
}

CalibratedLaws read_laws(const std::string& path) { return parse_laws(read_text_file(path), path); }

std::string laws_text(const CalibratedLaws& laws, const std::string& source) {
  check_laws(laws);
  require(!laws.name.empty() && !source.empty(), "laws need a name and a source to be written");
  std::string out = fmt::format("name = {}\nsource = \"Elements\"\n\n[sources]\nElements = {}\n",
                                toml_quoted(laws.name), toml_quoted(source));
  const LawEvidence& e = laws.evidence;
  out += fmt::format(
      "\n[evidence]\nfitted = {}\nchecked = {}\ndepth_m = {}\nforce_N = {}\nforce_error = {}\n",
      e.fitted, e.checked, toml_number(e.depth), toml_number(e.force), toml_number(e.force_error));
  for (const ExponentialTerm& term : laws.relaxation)
    out += fmt::format("\n[[relaxation]]\nshare = {}\ntime_s = {}\n", toml_number(term.share),
                       toml_number(term.time));
  const PowerLawConstants& p = laws.power;
  out += table_text("power_law", {{"force_N", p.force},
                                  {"depth_exponent", p.depth_exponent},
                                  {"patch_m", p.patch},
                                  {"patch_exponent", p.patch_exponent},
                                  {"torsion", p.torsion}});
  out += error_text("power_law.error", laws.power_error);
  const SoftFingerConstants& s = laws.soft_finger;
  out += table_text("soft_finger", {{"force_N", s.force},
                                    {"depth_exponent", s.depth_exponent},
                                    {"radius_exponent", s.radius_exponent},
                                    {"patch_m", s.patch},
                                    {"patch_exponent", s.patch_exponent},
                                    {"patch_radius", s.patch_radius},
                                    {"aspect", s.aspect},
                                    {"torsion", s.torsion}});
  out += error_text("soft_finger.error", laws.soft_finger_error);
  const FoundationConstants& f = laws.foundation;
  out += table_text("elastic_foundation", {{"modulus_Pa", f.modulus},
                                           {"exponent", f.exponent},
                                           {"stiffening", f.stiffening},
                                           {"surround", f.surround},
                                           {"spread", f.spread},
                                           {"thickness_m", f.thickness},
                                           {"shear_Pa", f.shear}});
  out += error_text("elastic_foundation.error", laws.foundation_error);
  out += error_text("elastic_foundation.bed_error", laws.bed_error);
  return out;
}

void write_laws(const std::string& path, const CalibratedLaws& laws, const std::string& source) {
  write_file(path, laws_text(laws, source));
}

}  // namespace thenar
