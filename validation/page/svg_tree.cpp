#include "validation/page/svg_tree.h"

#include <algorithm>
#include <stdexcept>

namespace furrow::validation {
namespace {

constexpr std::string_view blanks = " \t\r\n";

class Parser {
 public:
  explicit Parser(std::string_view file) : text_(file) {}

  // What stands before the next element's beginning is skipped.
  SvgNode element() {
    SvgNode node{.name = word(" \t\r\n/>")};
    while (skip_blanks(), peek() != '/' && peek() != '>') {
      std::string key = word("= \t\r\n/>");
      at_ = text_.find_first_of("'\"", at_);
      require_more();
      const char quote = text_[at_++];
      node.attributes.emplace_back(std::move(key), until(quote));
      ++at_;
    }
    if (text_[at_++] == '/') {
      ++at_;
      return node;
    }
    children_of(node);
    return node;
  }

  void go_to(std::string_view what) {
    at_ = text_.find(what);
    require_more();
    ++at_;
  }

 private:
  void children_of(SvgNode& node) {
    for (;;) {
      std::string text = until('<');
      if (text.find_first_not_of(blanks) != std::string::npos) node.children.push_back({"", {}, {}, std::move(text)});
      ++at_;
      if (peek() == '/') {
        until('>');
        ++at_;
        return;
      }
      if (peek() == '!' || peek() == '?') {
        at_ = text_.find(text_.substr(at_, 3) == "!--" ? "-->" : ">", at_);
        require_more();
        at_ = text_.find('>', at_) + 1;
      } else {
        node.children.push_back(element());
      }
    }
  }

  void require_more() const {
    if (at_ >= text_.size()) throw std::runtime_error("an SVG file is cut short");
  }
  char peek() const {
    require_more();
    return text_[at_];
  }
  void skip_blanks() { at_ = std::min(text_.find_first_not_of(blanks, at_), text_.size()); }
  std::string until(char end) { return word(std::string_view(&end, 1)); }
  std::string word(std::string_view ends) {
    const std::size_t begin = at_;
    at_ = text_.find_first_of(ends, at_);
    require_more();
    return std::string(text_.substr(begin, at_ - begin));
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace

std::string SvgNode::attribute(std::string_view key) const {
  const auto found = std::find_if(attributes.begin(), attributes.end(), [&](const auto& a) { return a.first == key; });
  return found == attributes.end() ? "" : found->second;
}

void SvgNode::set(const std::string& key, std::string value) {
  drop(key);
  attributes.emplace_back(key, std::move(value));
}

void SvgNode::drop(std::string_view key) {
  std::erase_if(attributes, [&](const auto& a) { return a.first == key; });
}

SvgNode parsed_svg(std::string_view file) {
  Parser parser(file);
  parser.go_to("<svg");
  return parser.element();
}

std::string text_of(const SvgNode& node) {
  if (node.name.empty()) return node.text;
  std::string text = "<" + node.name;
  for (const auto& [key, value] : node.attributes) {
    const char quote = value.find('"') == std::string::npos ? '"' : '\'';
    text += " " + key + "=" + quote + value + quote;
  }
  if (node.children.empty()) return text + "/>";
  text += ">";
  for (const SvgNode& child : node.children) text += text_of(child);
  return text + "</" + node.name + ">";
}

std::string words_of(const SvgNode& text) {
  std::string words;
  for (const SvgNode& child : text.children) {
    if (child.name.empty()) {
      words += child.text;
      continue;
    }
    std::string attributes;
    for (const auto& [key, value] : child.attributes) {
      if (key != "font-family" && !value.empty() && value != "normal") attributes += " " + key + "=\"" + value + "\"";
    }
    const std::string inner = words_of(child);
    if (attributes.empty())
      words += inner;
    else if (!inner.empty() || (child.attribute("dy") != "" && &child != &text.children.back()))
      words += "<tspan" + attributes + ">" + inner + "</tspan>";
  }
  return words;
}

}  // namespace furrow::validation
