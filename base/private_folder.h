#pragma once

/// Private folders of the user.

#include <string>

namespace thenar {

/// Treatment of a folder that exists already.
enum class ExistingFolder { kIsClosed, kStays };

/// Makes a folder and its missing parents, of mode 700.
/// @param existing  kIsClosed: an existing folder of this user is set to mode 700, too
/// @throws InputError if it cannot be made, is a link, or belongs to somebody else.
void make_private_folder(const std::string& path, ExistingFolder existing);

}  // namespace thenar
