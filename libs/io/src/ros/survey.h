// A first look through a whole recording: its topics, its frames, its odometry. Only then is it
// known which laser, which odometry and which transforms are to be used.
#pragma once
#include <mrpt/math/TPose2D.h>

#include <functional>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "bag_files.h"
#include "frames.h"

namespace ariadne::io::ros {

/// Orders the messages of all topics as they were recorded, also in a file that holds one topic
/// after the other. Where a topic's own record time goes back, a clock was set: the key goes on.
class RecordClock {
 public:
  double key(std::int64_t time_ns);

 private:
  double last_ = -std::numeric_limits<double>::infinity();
  double shift_ = 0;
};

struct TopicInfo {
  std::string type, encoding;
  std::size_t messages = 0;
  std::size_t malformed = 0;
  std::string why_malformed;  ///< of the first one
};

struct OdometryPose {
  double key = 0;  ///< RecordClock's
  double time_s = 0;
  mrpt::math::TPose2D odom_from_robot;
};

struct OdometrySource {
  std::string topic;
  std::string parent, child;  ///< frames; the child's may be empty in nav_msgs/Odometry
  std::vector<OdometryPose> poses;
};

struct Survey {
  using LaserKey = std::pair<std::string, std::string>;  ///< topic, frame
  std::map<std::string, TopicInfo> topics;
  std::map<LaserKey, std::size_t> scans;
  std::map<std::string, OdometrySource> odometry;    ///< nav_msgs/Odometry by topic
  std::map<Frames::Key, OdometrySource> transforms;  ///< on /tf: those that move, or of odometry
  Frames frames;
  std::vector<std::string> remarks;
  std::string damage;  ///< as BagFiles::damage()
};

/// s, of a stamp or, where there is none, of the time at which the message was recorded.
double secondsOf(const Header& header, std::int64_t recorded_ns);

/// Whether this topic's messages can be decoded here.
bool isReadable(const BagTopic& topic);

/// Whether a frame is called so that what moves in it is odometry: odom (REP 105), odom_combined,
/// robot1/odom.
bool isOdometryFrame(const std::string& frame);

/// Reads all files once. `goes_on`, called with the share that was read, may end it: the survey is
/// then of what was read so far. Memory: 40 bytes a pose of the odometry, 20 million of them.
Survey surveyOf(BagFiles& files, const std::function<bool(double)>& goes_on);

}  // namespace ariadne::io::ros
