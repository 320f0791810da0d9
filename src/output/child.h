// Another program, run to its end.
#pragma once

#include <string>
#include <vector>

namespace furrow {

struct ChildRequest {
  std::vector<std::string> words;  // the program, looked for in PATH, and its arguments; "{input}" is a file of `input`
  std::string input;
  double limit = 60;  // s
  // Bytes that it may print: they are held in memory.
  static constexpr long long most_output = 1LL << 28;
};

struct ChildEnd {
  int code = 0;  // exit code; 127: no such program; 128 + n: ended by signal n
  std::string output, errors;
};

// Neither the program nor what it has started outlives this call, also what has left its group: all of it is known by a
// variable in its environment. If this process is killed, the program ends with it. Throws Interrupted at once when that is
// asked for, and std::runtime_error after a limit.
ChildEnd run_child(const ChildRequest& request);

}  // namespace furrow
