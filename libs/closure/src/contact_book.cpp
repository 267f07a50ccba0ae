#include "ariadne/closure/contact_book.h"

#include <algorithm>
#include <iterator>

namespace ariadne::closure {

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

std::size_t ContactBook::visitBegin(const Track& track, double least_way_m) const {
  constexpr double kGap_m = 10;
  constexpr double kLongest_m = 50;
  const double now_m = track.travelled_m.back();
  double at_m = now_m;
  std::size_t begin = track.now() + 1;
  for (auto c = contacts_.rbegin(); c != contacts_.rend(); ++c) {
    const double second_m = track.travelled_m[c->second];
    if (second_m - track.travelled_m[c->first] < least_way_m) continue;
    if (at_m - second_m > kGap_m || now_m - second_m > kLongest_m) break;
    at_m = second_m;
    begin = c->second;
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

}  // namespace ariadne::closure
