#include <iostream>

#include "compare_app.h"

int main(int argc, char** argv) {
  return ariadne::runCompareApp({argv + 1, argv + argc}, std::cout, std::cerr);
}
