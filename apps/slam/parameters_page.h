// doc/reference/parameters.md, made from the parameters' own tables.
#pragma once
#include <string>

namespace ariadne::slam_app {

std::string parametersPage();

}  // namespace ariadne::slam_app
