#pragma once

/// Checksums at the end of binary files, behind the part that other programs read.

#include <string>

namespace thenar {

/// Attribute `program` of files that end with a checksum. Such a file without checksum is damaged.
inline constexpr const char* kCheckedProgram = "thenar+sha256";
/// Name of this attribute in results and posteriors.
inline constexpr const char* kProgram = "program";
/// Value of the attribute in files of older versions, which have no checksum.
inline constexpr const char* kUncheckedProgram = "thenar";

/// Appends their SHA-256 to the bytes of an HDF5 or netCDF-4 file. HDF5 ignores bytes behind the
/// end that its header states, so every program opens the file as before; a program that changes
/// the file invalidates the checksum.
[[nodiscard]] std::string with_checksum(std::string bytes);

/// Result of take_checksum(): the checksum is right, or absent.
enum class Checksum { kHolds, kAbsent };

/// Removes the checksum from the end of bytes, if there is one, and verifies it.
/// @param path  only names the file in messages
/// @throws DataError if the checksum does not hold.
[[nodiscard]] Checksum take_checksum(std::string& bytes, const std::string& path);

/// Throws for a file of another program, or one without its checksum.
/// @param program  value of its attribute `program`; "" if there is none
/// @param format   in messages: "a result file of thenar, got another HDF5 file"
/// @throws DataError
void require_ours(const std::string& program, Checksum checksum, const std::string& path,
                  const std::string& format);

/// Returns true if a regular file begins with the HDF5 signature; false if there is no such file.
[[nodiscard]] bool has_hdf5_start(const std::string& path);

/// Returns true if a file ends with a checksum, which is not verified.
[[nodiscard]] bool has_checksum(const std::string& path);

}  // namespace thenar
