# Few large pieces instead of many small ones, for builds that are made once: headers and their templates, which are most of
# the time, are then read once a piece. Not for daily work, where a change of one source would compile its whole piece.

# After all targets are known: those of which every piece has been compiled. Another joins by its name here.
set(FURROW_COMPILED_TOGETHER furrow furrow_export furrow_commands furrow_report furrow_page furrow_studies furrow_engines
  furrow_program unit_tests command_line_tests verification_tests validation_tests tools_tests judge_tests property_tests
  case_oracles fault_study)
function(furrow_compile_together)
  set(lines "")
  foreach(target IN LISTS FURROW_COMPILED_TOGETHER)
    if(NOT TARGET ${target})
      continue()
    endif()
    # g++ says so of every such type that is not in the file that it was called for.
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
    get_target_property(sources ${target} SOURCES)
    get_target_property(directory ${target} SOURCE_DIR)
    # The accepted counts of instructions are those of the solver's sources compiled one by one; files are not counted.
    if(target STREQUAL furrow AND CMAKE_BUILD_TYPE STREQUAL Release AND NOT FURROW_UNITY STREQUAL ALL)
      list(FILTER sources INCLUDE REGEX "src/output/")
    endif()
    foreach(source IN LISTS sources)
      cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY "${directory}" NORMALIZE)
      if(source MATCHES "\\.cpp$" AND EXISTS "${source}")
        string(APPEND lines "${target}\t${source}\n")
      endif()
    endforeach()
  endforeach()
  file(WRITE "${PROJECT_BINARY_DIR}/generated/unity.txt" "${lines}")
  find_program(FURROW_PYTHON python3 REQUIRED)
  execute_process(COMMAND "${FURROW_PYTHON}" "${PROJECT_SOURCE_DIR}/cmake/unity_groups.py" "${PROJECT_SOURCE_DIR}"
    INPUT_FILE "${PROJECT_BINARY_DIR}/generated/unity.txt" OUTPUT_FILE "${PROJECT_BINARY_DIR}/generated/unity.cmake"
    COMMAND_ERROR_IS_FATAL ANY)
  include("${PROJECT_BINARY_DIR}/generated/unity.cmake")
endfunction()
