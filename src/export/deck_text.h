// The lines of a deck as they are written, and what several parts of it need.
#pragma once

#include <algorithm>
#include <initializer_list>
#include <string>

#include "export/kinds.h"
#include "scene/wording.h"

namespace furrow {

inline std::string words(double a, double b) { return shortest(a) + " " + shortest(b); }

class DeckText {
 protected:
  void say(std::initializer_list<std::string> words) { input_ += joined(words, " ") + "\n"; }

  static std::string one_line(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '&'; }, ' ');
    return text;
  }

  static std::string group(std::size_t kind) { return "t" + std::to_string(kind + 1); }

  // Of all kinds of which something holds, as one group; empty if there is none.
  std::string together(const std::string& name, const auto& holds) {
    std::string types;
    for (std::size_t k = 0; k < kinds_.kind.size(); ++k) {
      if (holds(kinds_.kind[k])) types += " " + std::to_string(k + 1);
    }
    if (!types.empty()) say({"group", name, "type" + types});
    return types.empty() ? "" : name;
  }

  // Displacement and speed along one axis of what moves with a ramp; equal-style variables.
  void moving(const std::string& name, double speed, double ramp) {
    const std::string t = "(step*v_h)", v = shortest(speed), r = shortest(ramp);
    if (ramp > 0) {
      say({"variable", name, "equal",
           v + "*((" + t + "<" + r + ")*" + t + "^2/(2*" + r + ")+(" + t + ">=" + r + ")*(" + t + "-" + r + "/2))"});
      say({"variable", name + "_speed equal",
           v + "*((" + t + "<" + r + ")*" + t + "/" + r + "+(" + t + ">=" + r + "))"});
    } else {
      say({"variable", name, "equal", v + "*" + t});
      say({"variable", name + "_speed equal", v});
    }
  }

  AtomKinds kinds_;
  std::string input_;
};

}  // namespace furrow
