# Flags of our own code, and one helper that makes a module's library.

add_library(hybrid_flags INTERFACE)
target_include_directories(hybrid_flags INTERFACE ${PROJECT_SOURCE_DIR}/include)
target_include_directories(hybrid_flags SYSTEM INTERFACE ${EIGEN3_INCLUDE_DIR} /usr/include/eigen3)
# No contraction of a*b+c across statements and no -ffast-math: results are equal to the bit.
target_compile_options(hybrid_flags INTERFACE -Wall -Wextra -Wshadow -march=${HYBRID_ARCH} -ffp-contract=off)
if(HYBRID_WARNINGS_AS_ERRORS)
  target_compile_options(hybrid_flags INTERFACE -Werror)
endif()
# A library's calls of Eigen stay within it: an exported template of ours would take the place of gmsh's, whose flags
# (alignment of memory) may differ. Test unit.hidden_symbols.
target_compile_options(hybrid_flags INTERFACE -fvisibility=hidden -fvisibility-inlines-hidden)
if(HYBRID_SANITIZE)
  target_compile_options(hybrid_flags INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
  target_link_options(hybrid_flags INTERFACE -fsanitize=address,undefined)
  # GCC warns wrongly of <regex> in instrumented code; the release build keeps this warning.
  target_compile_options(hybrid_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
endif()
if(HYBRID_LIBFUZZER)
  target_compile_options(hybrid_flags INTERFACE -fsanitize=fuzzer-no-link) # libFuzzer sees what the readers do
endif()

# deal.II for the modules that include it. Its own deal_ii_setup_target() would append its
# optimisation flags after ours and forbid PUBLIC and PRIVATE in target_link_libraries.
include(${DEAL_II_TARGET_CONFIG})
set(deal_ii_build RELEASE)
if(CMAKE_BUILD_TYPE STREQUAL "Debug" AND DEAL_II_BUILD_TYPE MATCHES "Debug")
  set(deal_ii_build DEBUG)
endif()
add_library(hybrid_deal_ii INTERFACE)
target_include_directories(hybrid_deal_ii SYSTEM INTERFACE ${DEAL_II_INCLUDE_DIRS})
target_compile_definitions(hybrid_deal_ii INTERFACE ${DEAL_II_USER_DEFINITIONS} ${DEAL_II_USER_DEFINITIONS_${deal_ii_build}})
separate_arguments(deal_ii_linker_flags UNIX_COMMAND "${DEAL_II_LINKER_FLAGS} ${DEAL_II_LINKER_FLAGS_${deal_ii_build}}")
target_link_options(hybrid_deal_ii INTERFACE ${deal_ii_linker_flags})
target_link_libraries(hybrid_deal_ii INTERFACE ${DEAL_II_TARGET_${deal_ii_build}})

# ccache does not keep what was compiled with precompiled headers.
if(CMAKE_CXX_COMPILER_LAUNCHER MATCHES ccache)
  set(CMAKE_DISABLE_PRECOMPILE_HEADERS ON)
endif()

# Sources that stand together in the list of a target are compiled together (HYBRID_UNITY): what they instantiate from
# Eigen, deal.II and googletest costs more than themselves. Names in their anonymous namespaces must differ.
function(hybrid_compile_together target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${HYBRID_UNITY} UNITY_BUILD_BATCH_SIZE ${HYBRID_UNITY_SOURCES})
  if(HYBRID_UNITY) # the warning takes sources that are included for headers
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
  endif()
endfunction()

# hybrid_module(<name> SOURCES ... [DEPENDS ...] [DEAL_II] [UNITY])
# makes the static library hybrid_<name>. DEAL_II adds deal.II's include paths and libraries. UNITY compiles sources
# together. Other modules read the usual headers precompiled.
function(hybrid_module name)
  cmake_parse_arguments(ARG "DEAL_II;UNITY" "" "SOURCES;DEPENDS" ${ARGN})
  set(target hybrid_${name})
  add_library(${target} STATIC ${ARG_SOURCES})
  if(ARG_DEAL_II)
    target_link_libraries(${target} PUBLIC hybrid_deal_ii)
  endif()
  target_link_libraries(${target} PUBLIC hybrid_flags ${ARG_DEPENDS})
  if(ARG_UNITY)
    hybrid_compile_together(${target})
  else()
    target_precompile_headers(${target} PRIVATE <Eigen/Core> <algorithm> <array> <cmath> <filesystem> <fstream>
      <functional> <map> <memory> <set> <sstream> <string> <vector>)
  endif()
endfunction()

# hybrid_unit_test(<module> SOURCES ...) makes one test executable and one ctest entry
# (label unit) for a module.
function(hybrid_unit_test module)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS" ${ARGN})
  set(target ${module}_unit_tests)
  add_executable(${target} ${ARG_SOURCES})
  target_link_libraries(${target} PRIVATE hybrid_${module} ${ARG_DEPENDS} GTest::gtest GTest::gtest_main)
  hybrid_compile_together(${target})
  target_precompile_headers(${target} PRIVATE <gtest/gtest.h> <Eigen/Dense> <algorithm> <array> <cmath> <filesystem>
    <fstream> <functional> <map> <memory> <random> <set> <sstream> <string> <vector>)
  add_test(NAME unit.${module} COMMAND ${target})
  set_tests_properties(unit.${module} PROPERTIES LABELS unit TIMEOUT 900
    ENVIRONMENT "OPENBLAS_NUM_THREADS=1;OMP_NUM_THREADS=1;OMPI_ALLOW_RUN_AS_ROOT=1;OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1")
endfunction()

# make format: lay the sources out as .clang-format says (deal.II's style).
find_program(CLANG_FORMAT clang-format)
if(CLANG_FORMAT)
  add_custom_target(format
    COMMAND find include src tests ( -name "*.h" -o -name "*.cc" ) -exec ${CLANG_FORMAT} -i {} +
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} VERBATIM)
endif()

# make documentation: headers and documents as pages in documentation/html of the build folder; fails on any warning.
find_program(DOXYGEN doxygen)
configure_file(${PROJECT_SOURCE_DIR}/cmake/Doxyfile.in ${PROJECT_BINARY_DIR}/Doxyfile @ONLY)
if(DOXYGEN)
  add_custom_target(documentation
    COMMAND ${DOXYGEN} ${PROJECT_BINARY_DIR}/Doxyfile
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} VERBATIM)
endif()
