# cmake -DTEMPLATE= -DOUTPUT= -DSOURCE_DIR= -DVERSION= -DBUILD_TYPE= -DCOMPILER= -DFLAGS= -DSYSTEM= "-DPARTS=a;b" -P write_build_info.cmake

set(COMMIT unknown)
# Without this check, sources unpacked inside somebody else's repository would carry that repository's commit.
if(EXISTS "${SOURCE_DIR}/.git")
  # No optional locks: a build must not get in the way of a commit made at the same time.
  execute_process(COMMAND git --no-optional-locks -C "${SOURCE_DIR}" describe --always --dirty
    OUTPUT_VARIABLE described OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE status)
  if(status STREQUAL "0")
    set(COMMIT "${described}")
  endif()
endif()

# Of the solver: what decides the bits of a run and of its files. Names and texts, in the order of the names.
set(all "")
foreach(part IN LISTS PARTS)
  file(GLOB sources RELATIVE "${SOURCE_DIR}" "${SOURCE_DIR}/src/${part}/*.h" "${SOURCE_DIR}/src/${part}/*.cpp")
  foreach(source IN LISTS sources)
    file(SHA256 "${SOURCE_DIR}/${source}" hash)
    string(APPEND all "${source} ${hash}\n")
  endforeach()
endforeach()
string(SHA256 SOURCES "${all}")
string(SUBSTRING "${SOURCES}" 0 16 SOURCES)
configure_file("${TEMPLATE}" "${OUTPUT}" @ONLY)
