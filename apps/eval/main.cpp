#include <iostream>

#include "eval_app.h"

int main(int argc, char** argv) {
  return ariadne::runEvalApp({argv + 1, argv + argc}, std::cout, std::cerr);
}
