// The flags for what of a ROS recording is used.
#pragma once
#include <CLI/CLI.hpp>

#include "ariadne/io/ros_options.h"

namespace ariadne {

/// They fill `options`, which must outlive the app. --laser names the topic of the scans.
void addRosOptions(CLI::App& app, io::RosOptions& options);

}  // namespace ariadne
