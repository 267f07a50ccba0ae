#include <iostream>

#include "slam_app.h"

int main(int argc, char** argv) {
  return ariadne::runSlamApp({argv + 1, argv + argc}, std::cout, std::cerr);
}
