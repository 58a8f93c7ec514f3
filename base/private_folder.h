#pragma once

/// Folders of the user's own, which nobody else looks into.

#include <string>

namespace thenar {

/// Treatment of a folder that exists already.
enum class ExistingFolder { kIsClosed, kStays };

/// Makes a folder and its missing parents, of mode 700.
/// @param existing  kIsClosed: one of this user's that others may enter becomes of mode 700, too
/// @throws InputError if it cannot be made, is a link, or belongs to somebody else.
void make_private_folder(const std::string& path, ExistingFolder existing);

}  // namespace thenar
