#include <iostream>

#include "experiment_app.h"

int main(int argc, char** argv) {
  return ariadne::runExperimentApp({argv + 1, argv + argc}, std::cout, std::cerr);
}
