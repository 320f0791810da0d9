# cmake -DTEMPLATE= -DOUTPUT= -DSOURCE_DIR= -DVERSION= -DBUILD_TYPE= -DCOMPILER= -DFLAGS= -DSYSTEM= -P write_build_info.cmake

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
configure_file("${TEMPLATE}" "${OUTPUT}" @ONLY)
