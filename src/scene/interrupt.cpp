#include "scene/interrupt.h"

#include <csignal>

namespace furrow {

std::string interrupt_words() {
  switch (interrupt_request.signal) {
    case SIGINT:
      return "interrupted by SIGINT";
    case SIGTERM:
      return "interrupted by SIGTERM";
    case SIGHUP:
      return "interrupted by SIGHUP";
    default:
      return "interrupted";
  }
}

}  // namespace furrow
