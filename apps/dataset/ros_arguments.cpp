#include "ros_arguments.h"

namespace ariadne {

void addRosOptions(CLI::App& app, io::RosOptions& options) {
  const char* group = "ROS recordings, where they hold more than one of a thing";
  app.add_option("--odom-topic", options.odom_topic,
                 "topic of the odometry, nav_msgs/Odometry or transforms as /tf")
      ->group(group);
  app.add_option("--odom-frame", options.odom_frame,
                 "of transforms: the frame that the odometry starts in")
      ->group(group);
  app.add_option("--base-frame", options.base_frame, "the robot's frame")->group(group);
  app.add_option_function<std::string>(
         "--laser-pose",
         [&options](const std::string& text) {
           options.laser_pose = io::parseLaserPose(text, "--laser-pose");
         },
         "the laser on the robot: 'x y yaw_deg', 'x y yaw_deg upside_down' for one that hangs")
      ->group(group);
}

}  // namespace ariadne
