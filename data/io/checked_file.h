#pragma once

/// A checksum at the end of binary files, behind what other programs read.

#include <string>

namespace thenar {

/// The attribute `program` of files that end with a checksum. One that lacks it was damaged.
inline constexpr const char* kCheckedProgram = "thenar+sha256";
/// The attribute that holds it in a result or posterior.
inline constexpr const char* kProgram = "program";
/// The same of files of older versions, which have none.
inline constexpr const char* kUncheckedProgram = "thenar";

/// The bytes of an HDF5 or netCDF-4 file, followed by their SHA-256. HDF5 does not look behind the
/// end that its header states, so every program opens the file as before; one that changes the
/// file makes the checksum wrong.
[[nodiscard]] std::string with_checksum(std::string bytes);

/// Whether a checksum was found and held.
enum class Checksum { kHolds, kAbsent };

/// Takes the checksum off the end of bytes, if there is one.
/// @param path  only names the file in messages
/// @throws DataError if the bytes are not those that it was made of.
[[nodiscard]] Checksum take_checksum(std::string& bytes, const std::string& path);

/// Refuses a file that is not ours, or whose checksum was lost.
/// @param program  its attribute of that name; "" if there is none
/// @param format   in messages: "a result file of thenar, got another HDF5 file"
/// @throws DataError
void require_ours(const std::string& program, Checksum checksum, const std::string& path,
                  const std::string& format);

/// Whether a regular file begins as HDF5 does; false where there is none.
[[nodiscard]] bool has_hdf5_start(const std::string& path);

/// Whether a file ends with a checksum; nothing is said about whether it holds.
[[nodiscard]] bool has_checksum(const std::string& path);

}  // namespace thenar
