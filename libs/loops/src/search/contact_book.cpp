#include "ariadne/loops/search/contact_book.h"

#include <algorithm>
#include <iterator>

#include "ariadne/geometry/pose.h"

namespace ariadne::loops {

void ContactBook::extend(const Track& track, const std::vector<ScanHits>& hits) {
  for (; until_ <= track.now(); ++until_)
    for (const Contact& c : findContacts(track, hits, until_, params_)) contacts_.push_back(c);
}

std::vector<Contact> ContactBook::before(std::size_t update) const {
  std::vector<Contact> some = found_;
  std::copy_if(contacts_.begin(), contacts_.end(), std::back_inserter(some),
               [&](const Contact& c) { return c.second < update; });
  return some;
}

std::size_t visitBegin(const Track& track, double least_path_m) {
  constexpr double kNear_m = 8;
  constexpr double kGap_m = 10;
  constexpr double kLongest_m = 200;
  const auto amongOld = [&](std::size_t at) {
    for (std::size_t k = 0; track.travelled_m[at] - track.travelled_m[k] >= least_path_m; ++k)
      if (geometry::distance(track.poses[k], track.poses[at]) < kNear_m) return true;
    return false;
  };
  const double now_m = track.travelled_m.back();
  std::size_t begin = track.now() + 1;
  double begin_m = now_m;
  for (std::size_t at = track.now(); at > 0; --at) {
    if (begin_m - track.travelled_m[at] > kGap_m || now_m - track.travelled_m[at] > kLongest_m)
      break;
    if (!amongOld(at)) continue;
    begin = at;
    begin_m = track.travelled_m[at];
  }
  return begin;
}

void ContactBook::close(const Contact& found, std::size_t update) {
  found_.push_back(found);
  until_ = std::min(until_, update);
  contacts_.erase(std::remove_if(contacts_.begin(), contacts_.end(),
                                 [&](const Contact& c) { return c.second >= until_; }),
                  contacts_.end());
}

}  // namespace ariadne::loops
