#include <iostream>

#include "dataset_app.h"

int main(int argc, char** argv) {
  return ariadne::runDatasetApp({argv + 1, argv + argc}, std::cout, std::cerr);
}
