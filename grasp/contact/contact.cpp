#include "grasp/contact/contact.h"

namespace thenar {

std::vector<Contact> plain(const std::vector<HandContact>& contacts) {
  std::vector<Contact> plain;
  for (const HandContact& contact : contacts) plain.push_back(contact.contact);
  return plain;
}

Contact seen_from(const Pose<double>& X_AB, const Contact& contact_B) {
  Contact contact = contact_B;
  contact.p = X_AB * contact_B.p;
  contact.n = X_AB.R * contact_B.n;
  return contact;
}

}  // namespace thenar
