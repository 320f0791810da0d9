#include "program/signals.h"

#include <fcntl.h>
#include <sys/time.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <string_view>

#include "output/files.h"
#include "program/commands.h"
#include "scene/interrupt.h"

namespace furrow {
namespace {

constexpr timeval patience{0, 250'000};  // s, us; after two of these the program ends

// What a handler may do: no memory is taken, no lock.
void say_in_handler(std::string_view text) {
  if (write(STDERR_FILENO, text.data(), text.size()) < 0) return;
}

std::string_view last_words(int signal_number) {
  switch (signal_number) {
    case SIGTERM:
      return "furrow: interrupted by SIGTERM\n";
    case SIGHUP:
      return "furrow: interrupted by SIGHUP\n";
    default:
      return "furrow: interrupted by SIGINT\n";
  }
}

void note(int signal_number) {
  const int error = errno;
  int nobody = 0;
  if (!interrupt_request.signal.compare_exchange_strong(nobody, signal_number)) {
    std::signal(signal_number, SIG_DFL);
    raise(signal_number);
  } else {
    const itimerval timer{patience, patience};
    setitimer(ITIMER_REAL, &timer, nullptr);
  }
  errno = error;
}

void lose_patience(int /*signal_number*/) {
  const int error = errno;
  const bool was_urgent = interrupt_request.is_urgent.exchange(true);
  if (was_urgent && files_being_written() == 0) {
    say_in_handler(last_words(interrupt_request.signal));
    _exit(interrupted);
  }
  errno = error;
}

void handle(int signal_number, void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  sigaction(signal_number, &action, nullptr);
}

bool is_ignored(int signal_number) {
  struct sigaction now {};
  return sigaction(signal_number, nullptr, &now) == 0 && now.sa_handler == SIG_IGN;
}

}  // namespace

void watch_signals() {
  handle(SIGINT, note);
  handle(SIGTERM, note);
  if (!is_ignored(SIGHUP)) handle(SIGHUP, note);
  handle(SIGALRM, lose_patience);
  handle(SIGXFSZ, SIG_IGN);
  handle(SIGPIPE, SIG_IGN);
}

void guard_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(stream, F_GETFD) >= 0 || errno != EBADF) continue;
    // It takes the lowest number that is free, which is this one.
    if (open("/dev/null", stream == STDERR_FILENO ? O_WRONLY : O_RDONLY) != stream) _exit(io_failed);
  }
}

void flush_standard_output() {
  errno = 0;
  std::cout.flush();
  const bool failed = std::fflush(stdout) != 0 || std::ferror(stdout) != 0 || !std::cout;
  if (!failed) return;
  const int error = errno;
  throw FileError(std::string("cannot write to standard output") +
                  (error != 0 ? std::string(": ") + std::strerror(error) : ""));
}

}  // namespace furrow
