// The order of the page: a reviewer's questions.
#pragma once

#include <string>
#include <vector>

namespace furrow::validation {

// A part may also have sections of its own: the scenes, the checks, how it was made.
struct PagePart {
  std::string id, title, question;
  std::vector<std::string> studies;
};
const std::vector<PagePart>& page_parts();

}  // namespace furrow::validation
