#pragma once

/// Files broken at random, as a bad disk or a hurried editor leaves them.

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/file_io.h"

namespace thenar {

/// A number in 0..count-1.
inline std::size_t below(std::mt19937& rng, std::size_t count) {
  return count == 0 ? 0 : rng() % count;
}

/// Cut off, with bytes changed, a piece lost or a piece there twice.
inline std::string broken(std::string text, std::mt19937& rng) {
  const std::size_t kind = below(rng, 4), at = below(rng, text.size());
  const std::size_t length = 1 + below(rng, 40);
  if (kind == 0) return text.substr(0, at);
  if (kind == 1) {
    for (std::size_t i = below(rng, 8) + 1; i-- > 0;)
      text[below(rng, text.size())] = static_cast<char>(rng() % 256);
    return text;
  }
  if (kind == 2) return text.erase(at, length);
  return text.insert(at, text.substr(at, length));
}

/// Reads broken copies of a file, each of which must give a result or a DataError.
/// THENAR_BROKEN_FILES sets how many; `usual` otherwise.
/// @param path  where the copies stand, beside what the file names
/// @param read  takes that path
template <typename Read>
void expect_no_harm(const std::string& text, const std::string& path, const Read& read,
                    int usual = 300) {
  const char* wanted = std::getenv("THENAR_BROKEN_FILES");
  const int count = wanted == nullptr ? usual : std::atoi(wanted);
  std::mt19937 rng(1);
  int refused = 0;
  for (int i = 0; i < count; ++i) {
    write_file(path, broken(text, rng));
    try {
      read(path);
    } catch (const DataError&) {
      ++refused;
    } catch (const std::exception& other) {
      const std::string kept = "/tmp/broken_" + std::filesystem::path(path).filename().string();
      std::filesystem::copy_file(path, kept, std::filesystem::copy_options::overwrite_existing);
      FAIL() << "copy " << i << ", kept as " << kept << ": " << other.what();
    }
  }
  EXPECT_GT(refused, 0);      // some were broken indeed,
  EXPECT_LT(refused, count);  // and some were of use
}

}  // namespace thenar
