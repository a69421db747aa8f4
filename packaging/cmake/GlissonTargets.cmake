# glisson_module(NAME fem SOURCES ... [PUBLIC ...] [PRIVATE ...] [NO_PCH])
#   a static library glisson::fem with include root modules/fem/include.
# glisson_ui(NAME shell ...) the same under ui/, with moc.
# glisson_test(NAME fem/beam [SOURCES ...] [LIBRARIES ...] [DISPLAY])
#   tests/fem/beam_test.cpp -> ctest "fem/beam". DISPLAY runs it under xvfb-run.

function(_glisson_library prefix)
  cmake_parse_arguments(ARG "NO_PCH" "NAME" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  set(target glisson_${prefix}${ARG_NAME})
  list(TRANSFORM ARG_SOURCES PREPEND "src/" REGEX "^[^/]+$")
  add_library(${target} STATIC ${ARG_SOURCES})
  target_include_directories(${target} PUBLIC "${CMAKE_CURRENT_SOURCE_DIR}/include"
                                       PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}/src")
  target_link_libraries(${target} PUBLIC Eigen3::Eigen ${ARG_PUBLIC} PRIVATE glisson_flags ${ARG_PRIVATE})
  if(GLISSON_PCH AND NOT ARG_NO_PCH AND TARGET glisson_pch)
    target_precompile_headers(${target} REUSE_FROM glisson_pch)
  endif()
endfunction()

function(glisson_module)
  cmake_parse_arguments(MOD "" "NAME" "" ${ARGN})
  _glisson_library("" ${ARGN})
  add_library(glisson::${MOD_NAME} ALIAS glisson_${MOD_NAME})
endfunction()

function(glisson_ui)
  cmake_parse_arguments(MOD "" "NAME" "" ${ARGN})
  _glisson_library("ui_" ${ARGN})
  set_target_properties(glisson_ui_${MOD_NAME} PROPERTIES AUTOMOC ON)
  add_library(glisson::ui_${MOD_NAME} ALIAS glisson_ui_${MOD_NAME})
endfunction()

function(glisson_test)
  cmake_parse_arguments(ARG "DISPLAY;DRIVERS;NO_PCH" "NAME;TIMEOUT" "SOURCES;LIBRARIES" ${ARGN})
  string(REPLACE "/" "_" target "${ARG_NAME}_test")
  get_filename_component(stem "${ARG_NAME}" NAME)
  add_executable(${target} ${stem}_test.cpp ${ARG_SOURCES})
  set_target_properties(${target} PROPERTIES AUTOMOC ON RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/tests")
  target_link_libraries(${target} PRIVATE glisson_flags Eigen3::Eigen Qt6::Test ${ARG_LIBRARIES})
  if(GLISSON_PCH AND NOT ARG_NO_PCH AND TARGET glisson_pch)
    target_precompile_headers(${target} REUSE_FROM glisson_pch)
  endif()
  if(ARG_DISPLAY)
    find_program(GLISSON_XVFB_RUN xvfb-run REQUIRED)
    add_test(NAME ${ARG_NAME} COMMAND ${GLISSON_XVFB_RUN} -a -s "-screen 0 1600x1000x24" $<TARGET_FILE:${target}>)
  else()
    add_test(NAME ${ARG_NAME} COMMAND ${target})
  endif()
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 300)
  endif()
  set(environment "GLISSON_SOURCE_DIR=${PROJECT_SOURCE_DIR}" "OPENBLAS_NUM_THREADS=1" "LC_ALL=C.UTF-8")
  if(GLISSON_SANITIZER)
    # Instrumented code is 3 to 30 times slower.
    math(EXPR ARG_TIMEOUT "10 * ${ARG_TIMEOUT}")
    list(APPEND environment "UBSAN_OPTIONS=print_stacktrace=1" "QTEST_FUNCTION_TIMEOUT=3000000"
      "LSAN_OPTIONS=suppressions=${PROJECT_SOURCE_DIR}/packaging/sanitizers/lsan.supp:print_suppressions=0"
      "TSAN_OPTIONS=suppressions=${PROJECT_SOURCE_DIR}/packaging/sanitizers/tsan.supp")
    # Mesa's software driver, and those of cameras, leave small objects and are unloaded before leaks are counted, so that
    # no suppression can name them.
    if(ARG_DISPLAY OR ARG_DRIVERS)
      list(APPEND environment "ASAN_OPTIONS=detect_leaks=0")
    endif()
  endif()
  set_tests_properties(${ARG_NAME} PROPERTIES TIMEOUT ${ARG_TIMEOUT} ENVIRONMENT "${environment}")
endfunction()

# The headers that nearly every unit reads. One target owns them, all others reuse what it built.
if(GLISSON_PCH)
  file(WRITE "${CMAKE_BINARY_DIR}/glisson_pch.cpp" "// owns the precompiled header\n")
  add_library(glisson_pch OBJECT "${CMAKE_BINARY_DIR}/glisson_pch.cpp")
  target_link_libraries(glisson_pch PRIVATE glisson_flags Eigen3::Eigen)
  target_precompile_headers(glisson_pch PRIVATE <Eigen/Dense> <algorithm> <array> <cmath> <cstdint> <filesystem>
    <functional> <map> <memory> <optional> <random> <span> <string> <string_view> <unordered_map> <utility>
    <variant> <vector>)
endif()
