#include "scene/toml_text.h"

#include <algorithm>

#include "scene/utf8.h"

namespace furrow {
namespace {

constexpr char placeholder = '\t';
constexpr int most_dots = 16;  // in one key; a scene needs two

// Reads the text once and knows whether it is in a string or in a comment.
class Guard {
 public:
  Guard(std::string_view text, const std::function<void(TextPosition, const char*)>& fault)
      : rest_(text), fault_(fault) {}

  SafeText run() {
    if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);  // byte order mark
    while (!rest_.empty()) {
      if (static_cast<unsigned char>(rest_[0]) >= 0x80)
        take_letter();
      else if (rest_[0] == '\n')
        end_line();
      else if (comment_)
        copy(1);
      else if (!quote_.empty())
        take_in_string();
      else
        take_outside();
    }
    return std::move(safe_);
  }

 private:
  TextPosition here() const { return {line_, static_cast<std::uint32_t>(safe_.text.size() - start_ + 1)}; }

  void copy(std::size_t count) {
    safe_.text += rest_.substr(0, count);
    rest_.remove_prefix(std::min(count, rest_.size()));
  }

  void fault(const char* message) {  // one a line
    if (!reported_) fault_(here(), message);
    reported_ = true;
  }

  void take_letter() {
    const CodePoint c = first_code_point(rest_);
    const std::size_t bytes = std::max<std::size_t>(1, c.bytes);
    if (!comment_ && c.bytes == 0) fault("not UTF-8");
    if (!comment_ && quote_.empty()) fault("only ASCII is accepted outside strings and comments");
    if (!comment_ && !quote_.empty()) safe_.letters[string_].emplace_back(rest_.substr(0, bytes));
    safe_.text += comment_ || quote_.empty() ? '?' : placeholder;
    rest_.remove_prefix(bytes);
  }

  void end_line() {
    copy(1);
    ++line_;
    start_ = safe_.text.size();
    dots_ = 0;
    comment_ = reported_ = false;
    if (quote_.size() == 1) quote_ = {};
  }

  void take_in_string() {
    if (rest_.starts_with(quote_)) {
      const char mark = rest_[0];
      const bool triple = quote_.size() == 3;
      copy(quote_.size());
      while (triple && !rest_.empty() && rest_[0] == mark) copy(1);  // of """"" two belong to the string
      quote_ = {};
    } else {
      copy(quote_[0] == '"' && (rest_.starts_with("\\\\") || rest_.starts_with("\\\"")) ? 2 : 1);
    }
  }

  void take_outside() {
    const char c = rest_[0];
    if (c == '"' || c == '\'') {
      const std::string_view triple = c == '"' ? "\"\"\"" : "'''";
      quote_ = rest_.starts_with(triple) ? triple : triple.substr(0, 1);
      string_ = here();
      return copy(quote_.size());
    }
    if (c == '#') comment_ = true;
    if (c == '=' || c == ',') dots_ = 0;
    if (c == '.' && ++dots_ > most_dots) fault("a key of too many parts");
    copy(1);
  }

  std::string_view rest_;
  const std::function<void(TextPosition, const char*)>& fault_;
  SafeText safe_{};
  std::string_view quote_{};  // what ends the string that we are in; empty outside strings
  TextPosition string_{};     // where it began
  bool comment_ = false, reported_ = false;
  int dots_ = 0;
  std::uint32_t line_ = 1;
  std::size_t start_ = 0;  // of the line, in the safe text
};

}  // namespace

SafeText safe_text(std::string_view text, const std::function<void(TextPosition, const char*)>& fault) {
  return Guard(text, fault).run();
}

bool restore(const SafeText& safe, TextPosition begin, std::string& text) {
  const auto found = safe.letters.find(begin);
  if (found == safe.letters.end()) return true;
  const std::vector<std::string>& letters = found->second;
  if (std::count(text.begin(), text.end(), placeholder) != static_cast<std::ptrdiff_t>(letters.size())) return false;
  std::string whole;
  std::size_t next = 0;
  for (const char c : text) whole += c == placeholder ? letters[next++] : std::string(1, c);
  text = std::move(whole);
  return true;
}

}  // namespace furrow
