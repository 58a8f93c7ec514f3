#pragma once

/// Warnings about probable mistakes in a contact set.

#include <string>
#include <vector>

#include "data/io/contact_file.h"
#include "grasp/contact/contact.h"

namespace thenar {

/// Returns a sentence for each probable mistake: normals whose length differs from 1 by 1e-3 or
/// more, places beyond 5 m or 20 torque scales (millimetres?), all normals pointing out of the
/// object, a repeated place, friction above 5 (degrees?). Qualities are computed anyway.
[[nodiscard]] std::vector<std::string> contact_warnings(const ContactFile& file);

/// Returns the contacts of a file as grasp/ defines them, in the order of the file.
[[nodiscard]] std::vector<Contact> contacts_of(const ContactFile& file);

}  // namespace thenar
