#pragma once

/// Warnings about probable mistakes in a contact set.

#include <string>
#include <vector>

#include "data/io/contact_file.h"
#include "grasp/contact/contact.h"

namespace thenar {

/// Returns sentences, none where nothing is odd: normals that were made unit with a length off by
/// 1e-3 or more, places beyond 5 m or 20 torque scales (millimetres?), all normals out of the
/// object, one place twice, friction above 5 (degrees?). Qualities are computed all the same.
[[nodiscard]] std::vector<std::string> contact_warnings(const ContactFile& file);

/// Returns contacts of a file as grasp/ has them, in the order of the file.
[[nodiscard]] std::vector<Contact> contacts_of(const ContactFile& file);

}  // namespace thenar
