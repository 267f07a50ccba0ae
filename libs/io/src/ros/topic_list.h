// What a recording holds, for the messages that ask the user to choose.
#pragma once
#include <functional>

#include "survey.h"

namespace ariadne::io::ros {

/// "/scan sensor_msgs/LaserScan (663), ..." of the topics that `wanted` takes, 20 at most;
/// "nothing" where there are none.
std::string listOfTopics(const Survey& survey,
                         const std::function<bool(MessageKind)>& wanted = nullptr);

/// "/scan" for "scan".
std::string topicName(const std::string& given);
/// "odom" for "/odom".
std::string frameName(const std::string& given);

/// The texts with commas between them, `most` at most.
std::string listOf(const std::vector<std::string>& texts, std::size_t most = 20);

}  // namespace ariadne::io::ros
