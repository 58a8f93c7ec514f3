// Files that readers once took quadratic time over. Ours is one of twice the size; the rival reads
// one of half of that three times, which is as long if time grows as the size to the power 1.6.

#include <cmath>
#include <filesystem>
#include <random>
#include <string>

#include <unistd.h>

#include "base/error.h"
#include "base/file_io.h"
#include "bench/ratios.h"
#include "data/io/file_guard.h"
#include "data/io/mesh/triangle_soup.h"
#include "data/io/robot/import_robot.h"
#include "data/io/toml_table.h"

namespace thenar::bench {
namespace {

constexpr int kTimes = 3;  // that half of the file is read

/// A task of some size, done once.
using SizedTask = std::function<void()>;

Row growth(const std::string& name, const SizedTask& whole, const SizedTask& half) {
  Duel duel{name, whole, {}, 1, 0, 0};
  duel.rival = [half] {
    for (int i = 0; i < kTimes; ++i) half();
  };
  return measure(duel, {15, 0.005});
}

std::string times(const std::string& text, int n) {
  std::string all;
  for (int i = 0; i < n; ++i) all += text;
  return all;
}

std::string lines(const char* before, int n, const char* behind) {
  std::string all;
  for (int i = 0; i < n; ++i) all += before + std::to_string(i) + behind;
  return all;
}

/// Calls what may refuse what it reads.
template <typename Call>
void refused(const Call& call) {
  try {
    call();
  } catch (const Error&) {
  }
}

}  // namespace

Row ratio_growth_of_guard() {
  const auto task = [](int n) {
    return [text = times(times("<a b='c'>", 50) + times("</a>", 50), n)] {
      refused([&] { guard_text(text, "a", GuardedKind::kXml); });
    };
  };
  return growth("guard of XML, 6.5 MB: 3 x half of it", task(10'000), task(5'000));
}

Row ratio_growth_of_keys() {
  const auto task = [](int n) {
    return [text = "source = \"An1983\"\n" + lines("key", n, "_mm = 1\n")] {
      const TomlFile file(text, "a.toml");
      TomlTable top = file.top();
      keep(top.all(Dimension::kLength));
    };
  };
  return growth("60,000 keys of TOML: 3 x half of them", task(60'000), task(30'000));
}

Row ratio_growth_of_errors() {
  const auto task = [](int n) {
    return [text = lines("key", n, " = 1\n") + "a = \x01["] {
      refused([&] { const TomlFile file(text, "a.toml"); });
    };
  };
  return growth("late error in TOML: 3 x half as late", task(20'000), task(10'000));
}

Row ratio_growth_of_unknowns() {
  const std::string file =
      (std::filesystem::temp_directory_path() / ("thenar_bench_" + std::to_string(getpid())))
          .string();
  const auto task = [&](int n) {
    write_file(file + std::to_string(n) + ".urdf",
               "<robot name='a'><link name='b'/>\n" + lines("<x", n, "/>\n") + "</robot>");
    return [path = file + std::to_string(n) + ".urdf"] { keep(import_robot(path)); };
  };
  const Row row = growth("20,000 unknown elements of URDF: 3 x half", task(20'000), task(10'000));
  for (const char* end : {"20000.urdf", "10000.urdf"}) std::filesystem::remove(file + end);
  return row;
}

Row ratio_growth_of_soup() {
  // All corners but three lie within 64e-6 of the box from each other, equally dense.
  const auto task = [](int n) {
    std::mt19937 rng(7);
    std::uniform_real_distribution<double> along(0, 64e-6 * std::cbrt(n / 80e3));
    TriangleSoup soup;
    for (int i = 0; i < 3 * n; ++i) soup.corners.emplace_back(along(rng), along(rng), along(rng));
    soup.corners.insert(soup.corners.end(), {{0.5, 0, 0}, {0.5, 0.2, 0}, {0.5, 0, 0.2}});
    return [soup] { keep(weld_vertices(soup, 1, "loose.obj")); };
  };
  return growth("20,000 loose triangles: 3 x half of them", task(20'000), task(10'000));
}

}  // namespace thenar::bench
