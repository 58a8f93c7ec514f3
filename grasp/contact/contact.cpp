#include "grasp/contact/contact.h"

namespace thenar {

Contact seen_from(const Pose<double>& X_AB, const Contact& contact_B) {
  Contact contact = contact_B;
  contact.p = X_AB * contact_B.p;
  contact.n = X_AB.R * contact_B.n;
  return contact;
}

}  // namespace thenar
