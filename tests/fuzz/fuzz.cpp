// libFuzzer on the reader that ARIADNE_READER names; anything but core::Error ends it.
#include <unistd.h>

#include <cstdlib>
#include <iostream>

#include "readers.h"

using namespace ariadne::fuzz;

namespace {

const Reader& chosen() {
  const char* name = std::getenv("ARIADNE_READER");
  for (const Reader& reader : readers())
    if (name && std::string_view(name) == reader.name) return reader;
  std::cerr << "ARIADNE_READER takes one of:";
  for (const Reader& reader : readers()) std::cerr << ' ' << reader.name;
  std::cerr << '\n';
  std::_Exit(2);  // std::exit is a finding to libFuzzer
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const char* bytes, std::size_t size) {
  static const Reader& reader = chosen();
  static const auto folder = [] {
    const auto made =
        std::filesystem::path("/dev/shm") / ("ariadne-fuzz-" + std::to_string(::getpid()));
    std::filesystem::create_directories(made);
    return made;
  }();
  tryReader(reader, folder, {bytes, size});
  return 0;
}
