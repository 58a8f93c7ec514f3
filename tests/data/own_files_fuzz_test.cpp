// Files of our own kinds, damaged at random: a message or the same content, never a crash. How
// many: THENAR_MUTATIONS.

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <random>

#include <gtest/gtest.h>
#include <hdf5.h>

#include "base/error.h"
#include "base/file_io.h"
#include "data/io/anthropometry.h"
#include "data/io/experiment.h"
#include "data/io/fit_settings.h"
#include "data/io/inference_file.h"
#include "data/io/net_description.h"
#include "data/io/result_file.h"
#include "data/io/subject.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

namespace fs = std::filesystem;

int mutations(int usual) {
  const char* wanted = std::getenv("THENAR_MUTATIONS");
  return wanted ? std::atoi(wanted) : usual;
}

std::size_t below(std::mt19937& rng, std::size_t most) {
  return std::uniform_int_distribution<std::size_t>(0, most - 1)(rng);
}

void flip_bits(std::string& bytes, int count, std::mt19937& rng) {
  for (int i = 0; i < count; ++i) {
    const std::size_t bit = below(rng, 8 * bytes.size());
    bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ (1 << (bit % 8)));
  }
}

/// One of: flipped bits, a run cut out, written twice, overwritten, the end cut off, a number
/// that is out of all proportion, a bracket too many.
void damage(std::string& bytes, std::mt19937& rng) {
  if (bytes.empty()) return;
  const std::size_t at = below(rng, bytes.size());
  const std::size_t run = 1 + below(rng, std::min<std::size_t>(200, bytes.size() - at));
  static const std::vector<std::string> odd{"1e308", "-1",      "0",        "[",
                                            "{",     "nan",     "\"",       "\n",
                                            "[[",    ".",       "=",        "99999999999999999999",
                                            "''''",  "\\u0000", "\xff\xfe", "true"};
  switch (below(rng, 7)) {
    case 0:
      return flip_bits(bytes, 1 + static_cast<int>(below(rng, 8)), rng);
    case 1:
      bytes.erase(at, run);
      return;
    case 2:
      bytes.insert(at, bytes.substr(at, run));
      return;
    case 3:
      bytes.replace(at, run, run, static_cast<char>(below(rng, 256)));
      return;
    case 4:
      bytes.resize(at);
      return;
    default:
      bytes.insert(at, odd[below(rng, odd.size())]);
  }
}

/// Reads it, if it can be read.
template <typename Read>
bool readable(const Read& read) {
  try {
    (void)read();
    return true;
  } catch (const Error&) {
    return false;  // in words: what a crash or another exception is not
  }
}

class OwnFilesFuzz : public TemporaryFolder {
 protected:
  void put(const std::string& bytes) {
    std::ofstream(path("a"), std::ios::binary | std::ios::trunc) << bytes;
  }

  std::string result_bytes() {
    ResultFile file;
    file.add("fit/matrix", Eigen::MatrixXd::Random(20, 30), "N", {"trial", "component"});
    file.add("number", 1.0 / 3, "1");
    file.add("inputs/text", std::string(3000, 'x'));
    file.add("list", std::vector<std::string>{"a", "", "c"});
    write_result(file, path("a"));
    return read_file(path("a"), 1'000'000);
  }

  std::string inference_bytes() {
    InferenceFile file;
    file.attributes = {{"seed", "7"}, {"inputs", std::string(6000, 'x')}};
    InferenceGroup& group = file.groups["posterior"];
    group.lengths = {{"chain", 2}, {"draw", 50}, {"parameter", 3}};
    group.coordinates["parameter"] = {"a", "b", "c"};
    group.arrays["x"] = {std::vector<double>(300, 0.1), {"chain", "draw", "parameter"}, "N", ""};
    write_inference(file, path("a"));
    return read_file(path("a"), 1'000'000);
  }

  /// The same as older versions wrote it: without checksum.
  std::string unchecked(const std::string& bytes, bool text_of_any_length) {
    put(bytes);
    const hid_t h5 = H5Fopen(path("a").c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    H5Adelete(h5, "program");
    if (text_of_any_length) {
      const hid_t type = H5Tcopy(H5T_C_S1), space = H5Screate(H5S_SCALAR);
      H5Tset_size(type, H5T_VARIABLE);
      H5Tset_cset(type, H5T_CSET_UTF8);
      const hid_t program = H5Acreate2(h5, "program", type, space, H5P_DEFAULT, H5P_DEFAULT);
      const char* name = "thenar";
      H5Awrite(program, type, &name);
      H5Aclose(program);
      H5Sclose(space);
      H5Tclose(type);
    } else {
      const hid_t type = H5Tcopy(H5T_C_S1), space = H5Screate(H5S_SCALAR);
      H5Tset_size(type, 6);
      const hid_t program = H5Acreate2(h5, "program", type, space, H5P_DEFAULT, H5P_DEFAULT);
      H5Awrite(program, type, "thenar");
      H5Aclose(program);
      H5Sclose(space);
      H5Tclose(type);
    }
    H5Fclose(h5);
    return read_file(path("a"), 1'000'000);
  }

  std::mt19937 rng_{12};
};

// From one bit to two hundred, wherever they are: header, tree of names, values, checksum.
TEST_F(OwnFilesFuzz, NoFlippedBitOfAResultIsRead) {
  const std::string good = result_bytes();
  for (int i = 0; i < mutations(400); ++i) {
    std::string bytes = good;
    flip_bits(bytes, i % 2 == 0 ? 1 : 200, rng_);
    if (bytes == good) continue;
    put(bytes);
    ASSERT_FALSE(readable([&] { return read_result(path("a")); })) << "mutation " << i;
  }
}

TEST_F(OwnFilesFuzz, NoFlippedBitOfAPosteriorIsRead) {
  const std::string good = inference_bytes();
  for (int i = 0; i < mutations(400); ++i) {
    std::string bytes = good;
    flip_bits(bytes, i % 2 == 0 ? 1 : 200, rng_);
    if (bytes == good) continue;
    put(bytes);
    ASSERT_FALSE(readable([&] { return read_inference(path("a")); })) << "mutation " << i;
  }
}

// A checksum that is cut off must be missed: each file says inside that it has one.
TEST_F(OwnFilesFuzz, FilesWithTheirChecksumCutOffAreRefused) {
  for (const bool result : {true, false}) {
    std::string bytes = result ? result_bytes() : inference_bytes();
    put(bytes.substr(0, bytes.size() - 80));
    std::string said;
    try {
      if (result)
        (void)read_result(path("a"));
      else
        (void)read_inference(path("a"));
    } catch (const DataError& e) {
      said = e.what();
    }
    EXPECT_NE(said.find("its checksum (SHA-256) is missing"), std::string::npos) << said;
  }
}

// What the library makes of damaged files without checksum, as older versions wrote them.
TEST_F(OwnFilesFuzz, DamagedFilesWithoutChecksumDoNotCrash) {
  const std::string result = unchecked(result_bytes(), true);
  const std::string posterior = unchecked(inference_bytes(), false);
  put(result);
  ASSERT_TRUE(readable([&] { return read_result(path("a")); }));
  put(posterior);
  ASSERT_TRUE(readable([&] { return read_inference(path("a")); }));
  for (int i = 0; i < mutations(40); ++i) {
    std::string bytes = i % 2 == 0 ? result : posterior;
    damage(bytes, rng_);
    put(bytes);
    if (i % 2 == 0)
      (void)readable([&] { return read_result(path("a")); });
    else
      (void)readable([&] { return read_inference(path("a")); });
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1) << "nothing was written";
}

TEST_F(OwnFilesFuzz, DamagedTextsDoNotCrash) {
  struct Kind {
    const char* file;
    std::function<void(const std::string&, const std::string&)> parse;
  };
  const auto parsed = [](auto parse) {
    return [parse](const std::string& text, const std::string& path) { (void)parse(text, path); };
  };
  const std::vector<Kind> kinds{{"subjects/an_chao_index.toml", parsed(parse_subject)},
                                {"subjects/graspit_skewed_thumb.toml", parsed(parse_subject)},
                                {"experiments/synek2019_H01.toml", parsed(parse_experiment)},
                                {"fits/finger.toml", parsed(parse_fit_settings)},
                                {"anthropometry/buchholz1992.toml", parsed(parse_proportions)},
                                {"nets/chao_an.toml", parsed(parse_net)}};
  std::vector<std::string> texts;
  for (const Kind& kind : kinds)
    texts.push_back(read_file(THENAR_DATA_DIR + ("/" + std::string(kind.file)), 1'000'000));
  for (int i = 0; i < mutations(1500); ++i) {
    const std::size_t k = static_cast<std::size_t>(i) % kinds.size();
    std::string text = texts[k];
    for (int times = 0; times <= i % 3; ++times) damage(text, rng_);
    (void)readable([&] {
      kinds[k].parse(text, "a.toml");
      return true;
    });
  }
}

}  // namespace
}  // namespace thenar
