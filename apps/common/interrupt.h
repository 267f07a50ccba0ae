// Ctrl-C and SIGTERM as something to ask for instead of an end.
#pragma once
#include <csignal>

namespace ariadne::app {

/// While one lives, the first SIGINT or SIGTERM is only remembered; the second acts as usual.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;
  /// The signal that came, 0 when none did.
  int signal() const;

 private:
  struct sigaction before_int_ {};
  struct sigaction before_term_ {};
};

}  // namespace ariadne::app
