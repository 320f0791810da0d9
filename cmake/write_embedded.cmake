# cmake -DOUTPUT= -DSOURCE_DIR= "-DFILES=a;b" -P write_embedded.cmake
# Writes a C++ source with the text of each file under its name.

set(entries "")
foreach(name IN LISTS FILES)
  file(READ "${SOURCE_DIR}/${name}" text)
  string(FIND "${text}" ")EMBEDDED\"" end_mark)
  if(NOT end_mark EQUAL -1)
    message(FATAL_ERROR "${name}: contains the text )EMBEDDED\", which ends the C++ literal that holds it")
  endif()
  string(APPEND entries "    {R\"EMBEDDED(${name})EMBEDDED\"sv,\n     R\"EMBEDDED(${text})EMBEDDED\"sv},\n")
endforeach()
list(LENGTH FILES count)

file(WRITE "${OUTPUT}" "// Written by cmake/write_embedded.cmake; changes here are lost.
#include \"report/embedded.h\"

#include <array>
#include <stdexcept>
#include <string>

namespace furrow {
namespace {

using namespace std::string_view_literals;

struct File {
  std::string_view name;
  std::string_view text;
};

constexpr std::array<File, ${count}> files{{
${entries}}};

}  // namespace

std::string_view embedded(std::string_view name) {
  for (const File& file : files) {
    if (file.name == name) return file.text;
  }
  throw std::out_of_range(\"no embedded file \" + std::string(name));
}

std::vector<std::string_view> embedded_files(std::string_view folder) {
  std::vector<std::string_view> names;
  for (const File& file : files) {
    if (file.name.starts_with(folder)) names.push_back(file.name);
  }
  return names;
}

}  // namespace furrow
")
