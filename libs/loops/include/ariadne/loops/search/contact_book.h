// The contacts of the path of s*, and the closures that were found from afar: what ties the path to
// itself.
#pragma once
#include <cstddef>
#include <vector>

#include "ariadne/loops/search/contacts.h"

namespace ariadne::loops {

/// Update at which the path, as it is thought to go, came among places over `least_path_m` back
/// this time (up to 200 m ago). From there on its contacts say that the robot is where it is
/// thought to be: what a closure found elsewhere disputes. One past the last update when the robot
/// is not among such places.
std::size_t visitBegin(const Track& track, double least_path_m);

/// The contacts of a path with earlier parts of itself, extended update by update.
class ContactBook {
 public:
  /// Looks at the updates that were not looked at yet.
  void extend(const Track& track, const std::vector<ScanHits>& hits);
  /// Every contact of the updates that were added.
  std::vector<Contact> all() const { return before(until_); }
  /// Found closures, and the contacts of updates before this one.
  std::vector<Contact> before(std::size_t update) const;
  /// A closure ties the last update. Contacts from `update` on are to be looked at anew, since the
  /// path will lie elsewhere.
  void close(const Contact& found, std::size_t update);

 private:
  ContactParams params_;
  std::vector<Contact> contacts_;  // by rising second
  std::vector<Contact> found_;
  std::size_t until_ = 0;  // updates before this were looked at
};

}  // namespace ariadne::loops
