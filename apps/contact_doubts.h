#pragma once

/// What about contacts looks like a mistake of whoever wrote them.

#include <string>
#include <vector>

namespace thenar {

struct ContactFile;

/// Sentences, none where nothing is odd: normals that were made unit, all normals out of the
/// object, places in millimetres, friction in degrees. The answer is computed all the same.
[[nodiscard]] std::vector<std::string> contact_doubts(const ContactFile& file);

}  // namespace thenar
