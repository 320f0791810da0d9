#include "validation/page/terms.h"

#include <array>
#include <cctype>
#include <map>
#include <set>
#include <string_view>

#include "methods/method.h"
#include "validation/page/gnuplot.h"

namespace furrow::validation {
namespace {

struct Term {
  std::string id, meaning;
};

const std::map<std::string, Term>& terms() {
  static const std::map<std::string, Term> all = [] {
    const Term located{"term_located", "steps end at tears (+t), or at touches, slips and tears (+e)"},
        mass{"term_reading", "a reading of the mass of a particle: discs 1 m deep, or spheres"},
        reading{"term_literal", "one choice for everything that the paper leaves open"};
    std::map<std::string, Term> some{{"+t", located},      {"+e", located},      {"discs", mass},
                                     {"spheres", mass},    {"literal", reading}, {"reading", reading},
                                     {"readings", reading}};
    for (const MethodInfo& m : method_catalogue()) some[m.name] = {id_of_method(m.name), m.title};
    return some;
  }();
  return all;
}

bool in_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

// Elements whose text stays as it is.
bool is_left_alone(const std::string& tag) {
  static const std::set<std::string> some{"a",  "svg", "button", "script", "style", "summary", "thead",
                                          "h1", "h2",  "h3",     "h4",     "pre",   "title"};
  return some.contains(tag);
}

constexpr std::string_view may_break = "<wbr>";

class Linker {
 public:
  explicit Linker(const std::string& html) : html_(html) {}

  std::string linked() {
    while (at_ < html_.size()) {
      if (html_[at_] == '<')
        tag();
      else if (const std::size_t end = end_of_word(); depth_ == 0 && end > at_)
        word(end);
      else
        out_ += html_[at_++];
    }
    return out_;
  }

 private:
  void tag() {
    const std::size_t end = std::min(html_.find('>', at_), html_.size() - 1);
    const bool closes = html_.compare(at_, 2, "</") == 0;
    std::string name;
    for (std::size_t k = at_ + (closes ? 2 : 1); k < end && in_word(html_[k]); ++k) name += html_[k];
    if (is_left_alone(name)) depth_ += closes ? -1 : 1;
    out_ += html_.substr(at_, end + 1 - at_);
    at_ = end + 1;
  }

  // Of a word that begins here, or of "+t"; long names may break at their underscores.
  std::size_t end_of_word() const {
    if (at_ > 0 && in_word(html_[at_ - 1])) return at_;
    std::size_t end = at_ + (html_[at_] == '+' ? 1 : 0);
    while (end < html_.size()) {
      if (in_word(html_[end]))
        ++end;
      else if (html_.compare(end, may_break.size(), may_break) == 0)
        end += may_break.size();
      else
        break;
    }
    return end;
  }

  void word(std::size_t end) {
    const std::string raw = html_.substr(at_, end - at_);
    std::string name = raw;
    for (std::size_t k = 0; (k = name.find(may_break, k)) != std::string::npos;) name.erase(k, may_break.size());
    const auto term = terms().find(name);
    if (term != terms().end() && stands_for_itself(name) && used_.insert(name).second)
      out_ += "<a class=\"term\" href=\"#" + term->second.id + "\" title=\"" + escaped(term->second.meaning) + "\">" +
              raw + "</a>";
    else
      out_ += raw;
    at_ = end;
  }

  // "scene 2, discs" is a reading of the mass, "settled discs" and "glass spheres" are not.
  bool stands_for_itself(const std::string& name) const {
    return (name != "discs" && name != "spheres") || (at_ >= 2 && html_.compare(at_ - 2, 2, ", ") == 0);
  }

  const std::string& html_;
  std::string out_;
  std::size_t at_ = 0;
  int depth_ = 0;
  std::set<std::string> used_;
};

}  // namespace

std::string id_of_method(const std::string& name) { return "method_" + name; }

std::string with_terms(const std::string& section) { return Linker(section).linked(); }

}  // namespace furrow::validation
