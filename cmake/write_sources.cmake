# cmake -DOUTPUT= -DSOURCE_DIR= "-DFILES=a;b" -P write_sources.cmake
# Writes a C++ source with a hash of each file under its name, without comments and blanks: words change no number.

set(entries "")
foreach(name IN LISTS FILES)
  file(READ "${SOURCE_DIR}/${name}" text)
  if(NOT name MATCHES "\\.py$")  # where // divides
    string(REGEX REPLACE "//[^\n]*" "" text "${text}")
  endif()
  string(REGEX REPLACE "[ \t\n]+" " " text "${text}")
  string(SHA256 hash "${text}")
  string(SUBSTRING "${hash}" 0 8 hash)
  string(APPEND entries "      {\"${name}\", \"${hash}\"},\n")
endforeach()

file(WRITE "${OUTPUT}" "// Written by cmake/write_sources.cmake; changes here are lost.
#include \"report/sources.h\"

namespace furrow {

const Sources& sources_of_this_program() {
  static const Sources all{
${entries}  };
  return all;
}

}  // namespace furrow
")
