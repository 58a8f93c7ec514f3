#include "base/provenance.h"

#include <cstddef>
#include <filesystem>

#include <fmt/format.h>
#include <openssl/evp.h>
#include <Eigen/Core>

#include "base/error.h"
#include "base/file_io.h"
#include "base/library_versions.h"  // written by CMake

namespace thenar {

std::string sha256(const std::string& text) {
  unsigned char digest[EVP_MAX_MD_SIZE];
  unsigned int length = 0;
  require(EVP_Digest(text.data(), text.size(), digest, &length, EVP_sha256(), nullptr) == 1,
          "SHA-256 failed on a text of {} bytes", text.size());
  std::string hex;
  for (unsigned int i = 0; i < length; ++i) hex += fmt::format("{:02x}", digest[i]);
  return hex;
}

FileDigests digests_of(const std::vector<std::string>& paths) {
  // Largest file; the readers of our files allow less [bytes]
  constexpr std::size_t kMaxDigestedBytes = std::size_t{1} << 32;
  FileDigests files;
  for (const std::string& path : paths)
    files[std::filesystem::path(path).lexically_normal().string()] =
        sha256(read_file(path, kMaxDigestedBytes));
  return files;
}

FileDigests source_digests(const std::vector<SourceText>& sources) {
  FileDigests digests;
  for (const SourceText& source : sources) digests[source.path] = sha256(source.text);
  return digests;
}

std::map<std::string, std::string> versions() {
  std::map<std::string, std::string> all(kLibraryVersions.begin(), kLibraryVersions.end());
  all["thenar"] = THENAR_VERSION;
  all["compiler"] = __VERSION__;
  all["Eigen"] =
      fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION);
  return all;
}

}  // namespace thenar
