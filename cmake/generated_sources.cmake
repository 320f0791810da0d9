# Two sources that are written while building: build_info.cpp of the library and embedded.cpp of the page.

set(generated_dir "${PROJECT_BINARY_DIR}/generated")

# The commit changes without any source changing, so the script runs in every build; it touches the file only on change.
string(TOUPPER "${CMAKE_BUILD_TYPE}" type)
list(JOIN public_options " " public_flags)
list(JOIN private_options " " private_flags)
string(STRIP "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${type}} ${public_flags} ${private_flags}" flags)
add_custom_target(furrow_build_info
  COMMAND "${CMAKE_COMMAND}"
    "-DTEMPLATE=${PROJECT_SOURCE_DIR}/src/output/build_info.cpp.in" "-DOUTPUT=${generated_dir}/build_info.cpp"
    "-DSOURCE_DIR=${PROJECT_SOURCE_DIR}" "-DVERSION=${PROJECT_VERSION}" "-DBUILD_TYPE=${CMAKE_BUILD_TYPE}"
    "-DCOMPILER=${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}" "-DFLAGS=${flags}"
    "-DSYSTEM=${CMAKE_SYSTEM_NAME} ${CMAKE_SYSTEM_PROCESSOR}" "-DPARTS=${parts}"
    -P "${PROJECT_SOURCE_DIR}/cmake/write_build_info.cmake"
  BYPRODUCTS "${generated_dir}/build_info.cpp"
  COMMENT "Noting the commit" VERBATIM)

# Text files that the program needs wherever it is installed. A file is known by its path in the project.
file(GLOB embedded_files CONFIGURE_DEPENDS RELATIVE "${PROJECT_SOURCE_DIR}"
  validation/figures/*.gp validation/page/*.html validation/page/*.css validation/page/*.js validation/scenes/*.toml validation/scenes/literal/*.toml
  validation/scenes/best_reading/*.toml
  validation/statements.toml validation/sentences.toml validation/readings.toml verification/cases/*.toml verification/published/*.toml verification/faults.toml
  verification/engines/PROTOCOL.md)
list(TRANSFORM embedded_files PREPEND "${PROJECT_SOURCE_DIR}/" OUTPUT_VARIABLE embedded_paths)
add_custom_command(OUTPUT "${generated_dir}/embedded.cpp"
  COMMAND "${CMAKE_COMMAND}" "-DOUTPUT=${generated_dir}/embedded.cpp" "-DSOURCE_DIR=${PROJECT_SOURCE_DIR}"
    "-DFILES=${embedded_files}" -P "${PROJECT_SOURCE_DIR}/cmake/write_embedded.cmake"
  DEPENDS ${embedded_paths} "${PROJECT_SOURCE_DIR}/cmake/write_embedded.cmake"
  COMMENT "Embedding text files" VERBATIM)

# What the numbers of studies depend on; see src/report/sources.h.
file(GLOB_RECURSE hashed_files CONFIGURE_DEPENDS RELATIVE "${PROJECT_SOURCE_DIR}"
  src/*.h src/*.cpp verification/studies/*.h verification/studies/*.cpp validation/studies/*.h validation/studies/*.cpp
  validation/calibration/*.h validation/calibration/*.cpp
  benchmarks/studies/*.h benchmarks/studies/*.cpp)
file(GLOB page_files CONFIGURE_DEPENDS RELATIVE "${PROJECT_SOURCE_DIR}" validation/page/*.h validation/page/*.cpp
  verification/*.h verification/*.cpp verification/engines/*.h verification/engines/*.cpp verification/engines/adapters/*.py
  verification/fault_study/*.h verification/fault_study/*.cpp tests/studies/work_precision_counts.cpp)
list(APPEND hashed_files ${page_files})
list(TRANSFORM hashed_files PREPEND "${PROJECT_SOURCE_DIR}/" OUTPUT_VARIABLE hashed_paths)
add_custom_command(OUTPUT "${generated_dir}/sources.cpp"
  COMMAND "${CMAKE_COMMAND}" "-DOUTPUT=${generated_dir}/sources.cpp" "-DSOURCE_DIR=${PROJECT_SOURCE_DIR}"
    "-DFILES=${hashed_files}" -P "${PROJECT_SOURCE_DIR}/cmake/write_sources.cmake"
  DEPENDS ${hashed_paths} "${PROJECT_SOURCE_DIR}/cmake/write_sources.cmake"
  COMMENT "Hashing the sources" VERBATIM)

target_sources(furrow PRIVATE "${generated_dir}/build_info.cpp")
add_dependencies(furrow furrow_build_info)
