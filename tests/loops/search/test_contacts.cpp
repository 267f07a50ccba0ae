#include <gtest/gtest.h>

#include <algorithm>

#include "ariadne/geometry/pose.h"
#include "ariadne/loops/search/contact_book.h"
#include "corridor.h"

using namespace ariadne;
using loops::Contact;
using loops::Track;

namespace {

struct Seen {
  Track track;
  std::vector<loops::ScanHits> hits;
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
        k == 0 ? 0 : seen.track.travelled_m.back() + geometry::distance(poses[k], poses[k - 1]);
    seen.track.poses.push_back(poses[k]);
    seen.track.travelled_m.push_back(way);
    seen.hits.push_back(grid::scanPoints(world.scan(poses[k], rng), 20));
  }
  return seen;
}

/// What a laser in the middle of a corridor 2.4 m wide sees of its walls, with door frames of 0.5 m
/// that stand out across it at these places, m from the robot.
loops::ScanHits corridorEnds(const std::vector<double>& frames, std::uint32_t seed) {
  core::RandomStream rng(seed, 0, 0, core::Purpose::test);
  loops::ScanHits hits;
  for (int i = 0; i < 120; ++i) {
    const double angle = (i - 59.5) * M_PI / 120;
    double range = 1.2 / std::abs(std::sin(angle));
    for (const double x : frames) {
      const double to_frame = x / std::cos(angle);
      if (std::abs(to_frame * std::sin(angle)) > 0.7) range = std::min(range, to_frame);
    }
    if (range > 15) continue;
    range += 0.02 * rng.gaussian();
    hits.emplace_back(range * std::cos(angle), range * std::sin(angle));
  }
  return hits;
}

/// A robot that was at the origin, drove away, and believes to be there again.
Contact contactOf(const loops::ScanHits& first, const loops::ScanHits& second) {
  Track track;
  track.poses = {{0, 0, 0}, {60, 0, 0}, {0, 0, 0}};
  track.travelled_m = {0, 60, 120};
  const auto found = loops::findContacts(track, {first, {}, second}, 2, {});
  return found.empty() ? Contact() : found[0];
}

}  // namespace

TEST(Contacts, ABareCorridorHoldsAcrossAndNotAlong) {
  const Contact c = contactOf(corridorEnds({}, 1), corridorEnds({}, 2));
  EXPECT_GT(c.information(1, 1), 1000);
  EXPECT_LT(c.information(0, 0), 0.005 * c.information(1, 1));
}

TEST(Contacts, DoorsThatAgreeByChanceDoNotHoldAlongACorridor) {
  const std::vector<double> doors = {2, 3.5, 5.1, 7.2};
  const Contact same = contactOf(corridorEnds(doors, 1), corridorEnds(doors, 2));
  EXPECT_GT(same.information(0, 0), 200);
  const Contact other = contactOf(corridorEnds(doors, 1), corridorEnds({2.7, 4.2, 5.2, 6.3}, 2));
  EXPECT_GT(other.information(1, 1), 500);
  EXPECT_LT(other.information(0, 0), 10);
}

TEST(Contacts, AreFoundWhereTheRobotComesByAgain) {
  const Seen seen = roundAndOn();
  const auto contacts = loops::findContacts(seen.track, seen.hits, seen.track.now(), {});
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
  for (const Contact& c : loops::findContacts(seen.track, seen.hits, seen.track.now(), {}))
    EXPECT_GT(c.first, 150u);
}

TEST(Contacts, ShortenTheWayBack) {
  const Seen seen = roundAndOn();
  const std::size_t now = seen.track.now();
  const auto alone = loops::distancesFromNow(seen.track, {});
  EXPECT_NEAR(alone[19], seen.track.travelled_m[now] - seen.track.travelled_m[19], 1e-9);
  const auto with = loops::distancesFromNow(seen.track, {{19, now, Eigen::Matrix3d::Identity()}});
  EXPECT_LT(with[19], 0.5);
  EXPECT_NEAR(with[39], seen.track.travelled_m[39] - seen.track.travelled_m[19] + with[19], 1e-9);
}

TEST(Contacts, AVisitBeginsWhereThePathCameAmongOldPlaces) {
  Track track;  // 60 m out, 20 m aside, 60 m back, 20 m home and 20 m on
  const auto add = [&](double x, double y) {
    const double way = track.poses.empty()
                           ? 0
                           : track.travelled_m.back() +
                                 std::hypot(x - track.poses.back().x, y - track.poses.back().y);
    track.poses.emplace_back(x, y, 0);
    track.travelled_m.push_back(way);
  };
  for (int x = 0; x <= 60; x += 2) add(x, 0);
  for (int y = 2; y <= 20; y += 2) add(60, y);
  for (int x = 58; x >= 0; x -= 2) add(x, 20);
  EXPECT_EQ(loops::visitBegin(track, 25), track.poses.size());  // among no old place yet
  for (int y = 18; y >= 0; y -= 2) add(0, y);
  for (int x = 2; x <= 20; x += 2) add(x, 0);
  const std::size_t begin = loops::visitBegin(track, 25);
  EXPECT_LT(track.poses[begin].y, 8);
  EXPECT_GE(track.poses[begin - 1].y, 8);
}
