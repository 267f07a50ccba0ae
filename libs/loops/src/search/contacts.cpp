#include "ariadne/loops/search/contacts.h"

#include <array>
#include <limits>
#include <queue>

#include "agreement.h"
#include "ariadne/geometry/pose.h"

namespace ariadne::loops {

std::vector<Contact> findContacts(const Track& track, const std::vector<ScanHits>& hits,
                                  std::size_t second, const ContactParams& params) {
  struct Nearest {
    double least_path_m;
    double distance_m;
    std::size_t update;
  };
  std::array<Nearest, 3> classes = {
      {{40, params.radius_m, second}, {15, params.radius_m, second}, {5, params.radius_m, second}}};
  for (std::size_t k = 0; k < second; ++k) {
    const double path_m = track.travelled_m[second] - track.travelled_m[k];
    for (Nearest& c : classes) {
      if (path_m < c.least_path_m) continue;
      const double d = geometry::distance(track.poses[k], track.poses[second]);
      if (d < c.distance_m) {
        c.distance_m = d;
        c.update = k;
      }
      break;
    }
  }
  std::vector<Contact> out;
  for (const Nearest& c : classes) {
    if (c.update == second) continue;
    Contact contact{c.update, second, 1e-3 * Eigen::Matrix3d::Identity()};
    const auto first_from_second =
        geometry::relativePose(track.poses[c.update], track.poses[second]);
    if (agreement(hits[c.update], hits[second], first_from_second, params, contact.information) >=
        params.least_share)
      out.push_back(contact);
  }
  return out;
}

std::vector<double> distancesFromNow(const Track& track, const std::vector<Contact>& contacts) {
  const std::size_t n = track.poses.size();
  std::vector<double> distance_m(n, std::numeric_limits<double>::infinity());
  std::vector<std::vector<std::pair<std::size_t, double>>> edges(n);
  const auto join = [&](std::size_t a, std::size_t b, double length) {
    edges[a].emplace_back(b, length);
    edges[b].emplace_back(a, length);
  };
  for (std::size_t k = 1; k < n; ++k)
    join(k - 1, k, track.travelled_m[k] - track.travelled_m[k - 1]);
  for (const Contact& c : contacts)
    if (c.second < n)
      join(c.first, c.second, geometry::distance(track.poses[c.first], track.poses[c.second]));
  using Entry = std::pair<double, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> next;
  distance_m[n - 1] = 0;
  next.emplace(0, n - 1);
  while (!next.empty()) {
    const auto [d, k] = next.top();
    next.pop();
    if (d > distance_m[k]) continue;
    for (const auto& [other, length] : edges[k])
      if (d + length < distance_m[other]) {
        distance_m[other] = d + length;
        next.emplace(distance_m[other], other);
      }
  }
  return distance_m;
}

}  // namespace ariadne::loops
