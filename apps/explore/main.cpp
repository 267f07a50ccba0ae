#include <iostream>

#include "explore_app.h"

int main(int argc, char** argv) {
  return ariadne::runExploreApp({argv + 1, argv + argc}, std::cout, std::cerr);
}
