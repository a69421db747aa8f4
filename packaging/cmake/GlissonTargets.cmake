# glisson_module(NAME fem SOURCES ... [PUBLIC ...] [PRIVATE ...] [READS ...] [NO_PCH])
#   a static library glisson::fem with include root modules/fem/include. READS names the sources that parse what others
#   wrote.
# glisson_ui(NAME shell ... [NO_WIDGETS]) the same under ui/, with moc.
# glisson_test(NAME fem/beam [SOURCES ...] [LIBRARIES ...] [INSIDE ...] [DISPLAY] [LONG] [SCHEDULED] [COMPUTES])
#   tests/fem/beam_test.cpp, which ends in #include "beam_test.moc" -> ctest "fem/beam". DISPLAY runs it under xvfb-run.
#   LONG begins it before the others, so that none runs on alone at the end. SCHEDULED leaves it out unless ctest is told
#   "-C Scheduled", as the presets with sanitizers or counts do: it takes minutes. INSIDE names modules whose headers in src/
#   it reads: what is tested of them is not public. COMPUTES, or GLISSON_TESTS_COMPUTE for a whole folder, optimises it,
#   because it works on millions of voxels, pixels or points itself: of others half the compiler's time would go into
#   code that runs once.

# Rooms that parse what others wrote in most of their sources; of the others READS says in which. With GLISSON_FUZZ
# libFuzzer is told of each branch there, and only there: what computes keeps its pace, and all tests can run in the same
# build. (-fsanitize=fuzzer-no-link says the same, but Clang takes no precompiled header then that was compiled without.)
set(GLISSON_FUZZED_ROOMS core geometry network engine)
set(GLISSON_FUZZED -fsanitize-coverage=inline-8bit-counters,pc-table,indirect-calls,trace-cmp)

# Every unit of a target reads what the owner of a precompiled header built.
function(_glisson_reuse_pch target owner)
  if(TARGET ${owner})
    target_precompile_headers(${target} REUSE_FROM ${owner})
  endif()
endfunction()

function(_glisson_library prefix pch)
  cmake_parse_arguments(ARG "NO_PCH;NO_WIDGETS" "NAME" "SOURCES;PUBLIC;PRIVATE;READS" ${ARGN})
  set(target glisson_${prefix}${ARG_NAME})
  list(TRANSFORM ARG_SOURCES PREPEND "src/" REGEX "^[^/]+$")
  add_library(${target} STATIC ${ARG_SOURCES})
  target_include_directories(${target} PUBLIC "${CMAKE_CURRENT_SOURCE_DIR}/include"
                                       PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}/src")
  target_link_libraries(${target} PUBLIC Eigen3::Eigen ${ARG_PUBLIC} PRIVATE glisson_flags ${ARG_PRIVATE})
  if(GLISSON_FUZZ AND ARG_NAME IN_LIST GLISSON_FUZZED_ROOMS)
    target_compile_options(${target} PRIVATE ${GLISSON_FUZZED})
  elseif(GLISSON_FUZZ AND ARG_READS)
    list(TRANSFORM ARG_READS PREPEND "src/")
    set_property(SOURCE ${ARG_READS} APPEND PROPERTY COMPILE_OPTIONS ${GLISSON_FUZZED})
  endif()
  if(NOT ARG_NO_PCH)
    _glisson_reuse_pch(${target} ${pch})
  endif()
endfunction()

function(glisson_module)
  cmake_parse_arguments(MOD "" "NAME" "" ${ARGN})
  _glisson_library("" glisson_pch ${ARGN})
  add_library(glisson::${MOD_NAME} ALIAS glisson_${MOD_NAME})
endfunction()

function(glisson_ui)
  cmake_parse_arguments(MOD "NO_WIDGETS" "NAME" "" ${ARGN})
  if(MOD_NO_WIDGETS)
    _glisson_library("ui_" glisson_pch ${ARGN})
  else()
    _glisson_library("ui_" glisson_widgets_pch ${ARGN})
    target_link_libraries(glisson_ui_${MOD_NAME} PUBLIC Qt6::Widgets)
  endif()
  set_target_properties(glisson_ui_${MOD_NAME} PROPERTIES AUTOMOC ON)
  add_library(glisson::ui_${MOD_NAME} ALIAS glisson_ui_${MOD_NAME})
endfunction()

function(glisson_test)
  cmake_parse_arguments(ARG "DISPLAY;DRIVERS;LONG;SCHEDULED;COMPUTES" "NAME;TIMEOUT" "SOURCES;LIBRARIES;INSIDE" ${ARGN})
  string(REPLACE "/" "_" target "${ARG_NAME}_test")
  get_filename_component(stem "${ARG_NAME}" NAME)
  # A test holds its class itself, so moc has one file to read: automoc would add a unit and a scan to each program.
  set(moc "${CMAKE_CURRENT_BINARY_DIR}/moc/${stem}_test.moc")
  add_custom_command(OUTPUT "${moc}" DEPENDS "${stem}_test.cpp" VERBATIM
    COMMAND Qt6::moc -o "${moc}" "${CMAKE_CURRENT_SOURCE_DIR}/${stem}_test.cpp")
  add_executable(${target} ${stem}_test.cpp ${ARG_SOURCES} "${moc}")
  set_target_properties(${target} PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/tests")
  list(TRANSFORM ARG_INSIDE REPLACE "(.+)" "${PROJECT_SOURCE_DIR}/modules/\\1/src")
  target_include_directories(${target} PRIVATE "${CMAKE_CURRENT_BINARY_DIR}/moc" ${ARG_INSIDE})
  target_link_libraries(${target} PRIVATE glisson_test_flags ${ARG_LIBRARIES})
  # Qt's own headers differ where its widgets are there: those of ui/ and app/ have a precompiled header of theirs, which
  # is not optimised.
  set(pch glisson_test_pch)
  if(GLISSON_TESTS_COMPUTE)
    set(ARG_COMPUTES TRUE)
  endif()
  if(ARG_COMPUTES)
    set(pch glisson_computing_test_pch)
  else()
    target_compile_options(${target} PRIVATE ${GLISSON_RUNS_ONCE})
  endif()
  if(ARG_NAME MATCHES "^(ui|app)/")
    target_link_libraries(${target} PRIVATE Qt6::Widgets)
    set(pch glisson_widgets_test_pch)
  endif()
  if(NOT (ARG_COMPUTES AND pch STREQUAL glisson_widgets_test_pch))
    _glisson_reuse_pch(${target} ${pch})
  endif()
  set(when)
  if(ARG_SCHEDULED)
    set(when CONFIGURATIONS Scheduled)
  endif()
  if(ARG_DISPLAY)
    find_program(GLISSON_XVFB_RUN xvfb-run REQUIRED)
    add_test(NAME ${ARG_NAME} ${when}
      COMMAND ${GLISSON_XVFB_RUN} -a -s "-screen 0 1600x1000x24" $<TARGET_FILE:${target}>)
  else()
    add_test(NAME ${ARG_NAME} ${when} COMMAND ${target})
  endif()
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 300)
  endif()
  set(environment "GLISSON_SOURCE_DIR=${PROJECT_SOURCE_DIR}" "OPENBLAS_NUM_THREADS=1" "LC_ALL=C.UTF-8"
    "XDG_STATE_HOME=${CMAKE_BINARY_DIR}/state/${ARG_NAME}")  # never the person's own
  if(GLISSON_SANITIZER OR GLISSON_COVERAGE)
    # Instrumented code is 3 to 30 times slower.
    math(EXPR ARG_TIMEOUT "10 * ${ARG_TIMEOUT}")
    list(APPEND environment "QTEST_FUNCTION_TIMEOUT=3000000")
  endif()
  if(GLISSON_COVERAGE)
    list(APPEND environment "LLVM_PROFILE_FILE=${CMAKE_BINARY_DIR}/profiles/%4m.profraw")
  endif()
  if(GLISSON_SANITIZER)
    list(APPEND environment "UBSAN_OPTIONS=print_stacktrace=1"
      "LSAN_OPTIONS=suppressions=${PROJECT_SOURCE_DIR}/packaging/sanitizers/lsan.supp:print_suppressions=0"
      # QProcess shares its memory with the child until that becomes another program; threads begin afterwards.
      "TSAN_OPTIONS=die_after_fork=0:suppressions=${PROJECT_SOURCE_DIR}/packaging/sanitizers/tsan.supp")
    # Mesa's software driver, and those of cameras, leave small objects and are unloaded before leaks are counted, so that
    # no suppression can name them.
    if(ARG_DISPLAY OR ARG_DRIVERS)
      list(APPEND environment "ASAN_OPTIONS=detect_leaks=0")
    endif()
  endif()
  set_tests_properties(${ARG_NAME} PROPERTIES TIMEOUT ${ARG_TIMEOUT} ENVIRONMENT "${environment}")
  if(ARG_LONG)
    set_tests_properties(${ARG_NAME} PROPERTIES COST 1)
  endif()
endfunction()

# Of a test that computes nothing itself.
set(GLISSON_RUNS_ONCE -O0)

# What tests are compiled with. Qt6::Test would define the folder of each test, and no two could share a header.
add_library(glisson_test_flags INTERFACE)
target_link_libraries(glisson_test_flags INTERFACE glisson_flags Eigen3::Eigen Qt6::Core $<LINK_ONLY:Qt6::Test>)
target_include_directories(glisson_test_flags SYSTEM INTERFACE
  $<TARGET_PROPERTY:Qt6::Test,INTERFACE_INCLUDE_DIRECTORIES>)
target_compile_definitions(glisson_test_flags INTERFACE QT_TESTLIB_LIB)

# The headers that nearly every unit reads, compiled once for modules, for what has widgets, and for the tests of each:
# also our own of the ground floor (over two thirds of all units read them), and the engine's for those above it. Units
# include what they use all the same: presets without precompiled headers compile them.
# Never <QtWidgets> or <QtTest> whole: GCC instantiates what the inline functions of a header call anew in each unit that
# reads the precompiled one (2.5 s of processor time for an empty test with both, 1.1 s with those below).
function(_glisson_pch target)
  cmake_parse_arguments(ARG "ENGINE" "" "LIBRARIES;HEADERS;OPTIONS" ${ARGN})
  file(WRITE "${CMAKE_BINARY_DIR}/${target}.cpp" "// owns the precompiled header\n")
  add_library(${target} OBJECT "${CMAKE_BINARY_DIR}/${target}.cpp")
  target_link_libraries(${target} PRIVATE glisson_flags Eigen3::Eigen ${ARG_LIBRARIES})
  target_compile_options(${target} PRIVATE ${ARG_OPTIONS})
  set(ours core/error.h core/run_context.h geometry/camera.h geometry/topology.h volume/label_volume.h)
  set(rooms core geometry volume)
  if(ARG_ENGINE)
    list(APPEND ours engine/engine.h)
    list(APPEND rooms patient fem engine)
  endif()
  list(TRANSFORM ours PREPEND [["glisson/]])
  list(TRANSFORM ours APPEND [["]])
  foreach(room IN LISTS rooms)
    target_include_directories(${target} PRIVATE "${PROJECT_SOURCE_DIR}/modules/${room}/include")
  endforeach()
  target_precompile_headers(${target} PRIVATE <Eigen/Dense> <algorithm> <any> <array> <atomic> <cmath> <concepts>
    <cstdint> <filesystem> <functional> <map> <memory> <nlohmann/json_fwd.hpp> <optional> <random> <set> <span>
    <stdexcept> <string> <string_view> <thread> <unordered_map> <utility> <variant> <vector> ${ARG_HEADERS} ${ours})
endfunction()
if(GLISSON_PCH)
  _glisson_pch(glisson_pch)
  set(widgets <QAction> <QComboBox> <QCoreApplication> <QFormLayout> <QHBoxLayout> <QImage> <QLabel> <QMouseEvent>
    <QObject> <QPainter> <QProperty> <QPushButton> <QString> <QStringList> <QTimer> <QVBoxLayout> <QWidget>)
  _glisson_pch(glisson_widgets_pch ENGINE LIBRARIES Qt6::Widgets HEADERS ${widgets})
  if(GLISSON_TESTS)
    _glisson_pch(glisson_computing_test_pch LIBRARIES glisson_test_flags HEADERS <QTest>)
    _glisson_pch(glisson_test_pch LIBRARIES glisson_test_flags HEADERS <QTest> OPTIONS ${GLISSON_RUNS_ONCE})
    _glisson_pch(glisson_widgets_test_pch ENGINE LIBRARIES glisson_test_flags Qt6::Widgets HEADERS ${widgets} <QTest>
      OPTIONS ${GLISSON_RUNS_ONCE})
  endif()
endif()
