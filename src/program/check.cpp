#include <cstdio>
#include <iostream>

#include "methods/method.h"
#include "program/commands.h"
#include "scene/read.h"

namespace furrow {

int check_command(const std::vector<std::string>& scenes) {
  int code = good;
  for (const std::string& file : scenes) {
    try {
      make_method(read_scene(file).time.method);
      std::cout << file << ": ok\n";
    } catch (const SceneError& error) {
      for (const std::string& message : error.messages()) std::cerr << message << "\n";
      code = bad_input;
    } catch (const std::exception& error) {  // cannot be read, or names an unknown method; the others are still checked
      std::cerr << file << ": error: " << error.what() << "\n";
      code = bad_input;
    }
  }
  return code;
}

int methods_command() {
  std::cout << "name           order  f a step  step        what\n";
  for (const MethodInfo& m : method_catalogue()) {
    std::printf("%-14s %5d  %8d  %-10s  %s\n", m.name.c_str(), m.order, m.evaluations,
                m.controlled ? "controlled" : "fixed", m.title.c_str());
  }
  return good;
}

}  // namespace furrow
