find_package(GTest REQUIRED)
find_package(rapidcheck REQUIRED)
include(GoogleTest)

# furrow_add_tests(label pattern): all sources that match, in this directory and below, make one program LABEL_tests, and
# each of its tests is known to ctest under LABEL. No sources, no program: a new file joins without an edit here.
function(furrow_add_tests label pattern)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${pattern})
  if(FURROW_ONLY_SOLVER)  # without the tests of what stands above src
    foreach(source IN LISTS sources)
      file(STRINGS "${source}" above REGEX "#include \"(validation|verification|benchmarks|report)/")
      if(above)
        list(REMOVE_ITEM sources "${source}")
      endif()
    endforeach()
    if(NOT label MATCHES "^(unit|property|allocation|determinism|threads)$")
      return()
    endif()
  endif()
  if(NOT sources)
    return()
  endif()
  add_executable(${label}_tests ${sources})
  target_include_directories(${label}_tests PRIVATE "${PROJECT_SOURCE_DIR}")
  target_link_libraries(${label}_tests PRIVATE $<IF:$<TARGET_EXISTS:furrow_page>,furrow_page,furrow> nlohmann_json::nlohmann_json GTest::gtest_main rapidcheck rapidcheck_gtest)
  target_compile_definitions(${label}_tests PRIVATE FURROW_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
    FURROW_PROGRAM="${PROJECT_BINARY_DIR}/furrow")
  # Tests need not be fast, but they are most of what is compiled. The library under test stays as it is.
  target_compile_options(${label}_tests PRIVATE $<$<CONFIG:Release>:-O1> $<$<CONFIG:Debug>:-O0> ${FURROW_TEST_OPTIONS})
  if(TARGET furrow_program AND label MATCHES "^(command_line|injection|property|expected_to_fail)$")
    add_dependencies(${label}_tests furrow_program)
  endif()
  # PRE_TEST: a program that crashes at start fails its tests, not the build.
  gtest_discover_tests(${label}_tests DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 60
    XML_OUTPUT_DIR "${PROJECT_BINARY_DIR}/test_results" PROPERTIES LABELS ${label})
endfunction()
