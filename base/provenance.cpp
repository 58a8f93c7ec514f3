#include "base/provenance.h"

#include <fmt/format.h>
#include <openssl/evp.h>
#include <Eigen/Core>

#include "base/error.h"
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

std::map<std::string, std::string> versions() {
  std::map<std::string, std::string> all(kLibraryVersions.begin(), kLibraryVersions.end());
  all["thenar"] = THENAR_VERSION;
  all["compiler"] = __VERSION__;
  all["Eigen"] =
      fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION);
  return all;
}

}  // namespace thenar
