#include "output/kept_result.h"

#include <fstream>
#include <iterator>

#include "output/files.h"

namespace furrow {

void refuse_what_is_not(const std::string& what, const std::filesystem::path& file,
                        const std::function<bool(const std::string& text)>& is_one) {
  std::error_code failed;
  const std::filesystem::file_type type = std::filesystem::symlink_status(file, failed).type();
  if (type == std::filesystem::file_type::not_found) return;
  if (type == std::filesystem::file_type::regular) {
    std::ifstream stream(file, std::ios::binary);
    if (is_one({std::istreambuf_iterator<char>(stream), {}})) return;
  }
  throw FileError(file.string() + " is not " + what +
                  " that furrow could replace; move it away, or choose another place");
}

}  // namespace furrow
