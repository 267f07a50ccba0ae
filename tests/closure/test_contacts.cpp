#include <gtest/gtest.h>

#include "ariadne/closure/contacts.h"
#include "corridor.h"

using namespace ariadne;
using closure::Contact;
using closure::Track;

namespace {

struct Seen {
  Track track;
  std::vector<closure::ScanHits> hits;
};

/// Once round the corridor and 10 m on.
Seen roundAndOn() {
  Seen seen;
  auto poses = test::corridorDrive(0.5);
  for (std::size_t k = 0; k < 20; ++k) poses.push_back(poses[k]);
  const test::CorridorWorld world;
  core::RandomStream rng(1, 0, 0, core::Purpose::test);
  for (std::size_t k = 0; k < poses.size(); ++k) {
    const double way =
        k == 0 ? 0 : seen.track.travelled_m.back() + closure::distance(poses[k], poses[k - 1]);
    seen.track.poses.push_back(poses[k]);
    seen.track.travelled_m.push_back(way);
    seen.hits.push_back(grid::scanPoints(world.scan(poses[k], rng), 20));
  }
  return seen;
}

}  // namespace

TEST(Contacts, AreFoundWhereTheRobotComesByAgain) {
  const Seen seen = roundAndOn();
  const auto contacts = closure::findContacts(seen.track, seen.hits, seen.track.now(), {});
  ASSERT_FALSE(contacts.empty());
  EXPECT_EQ(contacts[0].first, 19u);  // the same place one lap before
  const Eigen::Vector3d known = contacts[0].information.diagonal();
  EXPECT_GT(known.minCoeff(), 0);
}

TEST(Contacts, AreNotBelievedWhereTheScansDisagree) {
  Seen seen = roundAndOn();
  // Half a metre aside and turned: as a filter has it that has not closed the loop.
  seen.track.poses.back().y += 0.6;
  seen.track.poses.back().phi += 0.3;
  for (const Contact& c : closure::findContacts(seen.track, seen.hits, seen.track.now(), {}))
    EXPECT_GT(c.first, 150u);
}

TEST(Contacts, ShortenTheWayBack) {
  const Seen seen = roundAndOn();
  const std::size_t now = seen.track.now();
  const auto alone = closure::distancesFromNow(seen.track, {});
  EXPECT_NEAR(alone[19], seen.track.travelled_m[now] - seen.track.travelled_m[19], 1e-9);
  const auto with = closure::distancesFromNow(seen.track, {{19, now, Eigen::Matrix3d::Identity()}});
  EXPECT_LT(with[19], 0.5);
  EXPECT_NEAR(with[39], seen.track.travelled_m[39] - seen.track.travelled_m[19] + with[19], 1e-9);
}
