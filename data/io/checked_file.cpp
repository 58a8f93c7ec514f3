#include "data/io/checked_file.h"

#include <fstream>

#include "base/error.h"
#include "base/file_io.h"
#include "base/provenance.h"

namespace thenar {
namespace {

constexpr const char* kMark = "\nthenar sha256 ";
// Lengths of the mark, of the digest in hexadecimal, and of both with the end of the line [bytes]
constexpr std::size_t kMarkSize = 15, kDigestSize = 64, kTailSize = kMarkSize + kDigestSize + 1;

bool ends_with_checksum(const std::string& tail) {
  return tail.size() == kTailSize && tail.compare(0, kMarkSize, kMark) == 0 && tail.back() == '\n';
}

}  // namespace

std::string with_checksum(std::string bytes) {
  const std::string digest = sha256(bytes);
  bytes.append(kMark).append(digest).append("\n");
  return bytes;
}

Checksum take_checksum(std::string& bytes, const std::string& path) {
  if (bytes.size() < kTailSize) return Checksum::kAbsent;
  // The tail of the file: mark, digest, end of line.
  const std::string tail = bytes.substr(bytes.size() - kTailSize);
  if (!ends_with_checksum(tail)) return Checksum::kAbsent;
  // The digest covers all bytes before it.
  bytes.resize(bytes.size() - kTailSize);
  if (sha256(bytes) != tail.substr(kMarkSize, kDigestSize))
    throw DataError(path, 1, "its checksum (SHA-256) does not hold: it was damaged or changed");
  return Checksum::kHolds;
}

void require_ours(const std::string& program, Checksum checksum, const std::string& path,
                  const std::string& format) {
  const bool must = program == kCheckedProgram;
  if (must && checksum == Checksum::kAbsent)
    throw DataError(path, 1,
                    "its checksum (SHA-256) is missing: it was cut short, damaged or changed by "
                    "another program");
  if (!must && program != kUncheckedProgram) throw DataError(path, 1, "wanted " + format);
}

bool has_hdf5_start(const std::string& path) {
  const std::string start = "\x89HDF\r\n\x1a\n";
  try {
    return read_start(path, start.size()) == start;
  } catch (const DataError&) {
    return false;
  }
}

bool has_checksum(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string tail(kTailSize, '\0');
  file.seekg(-static_cast<std::streamoff>(kTailSize), std::ios::end);
  file.read(tail.data(), static_cast<std::streamsize>(tail.size()));
  return file.good() && ends_with_checksum(tail);
}

}  // namespace thenar
