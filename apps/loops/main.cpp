#include <iostream>

#include "loops_app.h"

int main(int argc, char** argv) {
  return ariadne::runLoopsApp({argv + 1, argv + argc}, std::cout, std::cerr);
}
