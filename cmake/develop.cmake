# Tests, benchmarks and fuzz targets.
foreach(room api api_c apps_cli import session study study_report)
  ajar_compile_quickly(ajar_${room}_test)
endforeach()
# They write the images that they read.
target_link_libraries(ajar_imageio_test PRIVATE ZLIB::ZLIB ${AJAR_IMAGE_LIBRARIES})
target_include_directories(ajar_imageio_test SYSTEM PRIVATE ${AJAR_IMAGE_INCLUDE_DIRS})
target_link_libraries(ajar_scene_test PRIVATE ${AJAR_IMAGE_LIBRARIES})
target_include_directories(ajar_scene_test SYSTEM PRIVATE ${AJAR_IMAGE_INCLUDE_DIRS})

add_subdirectory(fuzz)

# Tests that cross rooms.
file(GLOB test_support CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/support/*.cpp)
add_library(ajar_test_support STATIC ${test_support})
ajar_compile_by_folder(ajar_test_support ${test_support})
target_include_directories(ajar_test_support PUBLIC ${PROJECT_SOURCE_DIR}/tests)
target_compile_definitions(ajar_test_support PRIVATE AJAR_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
target_link_libraries(ajar_test_support PUBLIC ajar_session ajar_path GTest::gtest TBB::tbb)

# Two programs: the folders of quick ones, and all others.
function(ajar_crossing_test name)
  add_executable(${name} ${ARGN})
  ajar_compile_by_folder(${name} ${ARGN})
  target_link_libraries(${name} PRIVATE ajar_test_support GTest::gtest_main)
  target_compile_definitions(${name} PRIVATE AJAR_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  # Computing is mostly done in the libraries, as for the tests of rooms.
  target_compile_options(${name} PRIVATE -O1)
endfunction()
set(folders_elsewhere cli|report|soak)
set(folders_quick code|formats|oracles)
file(GLOB crossing_tests CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/*/*_test.cpp)
set(quick_tests ${crossing_tests})
list(FILTER crossing_tests EXCLUDE REGEX "/(${folders_elsewhere}|${folders_quick})/")
list(FILTER quick_tests INCLUDE REGEX "/(${folders_quick})/")
ajar_crossing_test(ajar_crossing_test ${crossing_tests})
ajar_crossing_test(ajar_crossing_quick_test ${quick_tests})
add_test(NAME crossing_quick COMMAND ajar_crossing_quick_test)
set_tests_properties(crossing_quick PROPERTIES LABELS "crossing;quick")
# The longest of all: begun first, and in parts, so that no processor is left with one.
set(crossing_parts 8)
math(EXPR last_part "${crossing_parts} - 1")
foreach(part RANGE ${last_part})
  add_test(NAME crossing_${part} COMMAND ajar_crossing_test)
  # Two runs of one program would write the same file of results.
  set_tests_properties(crossing_${part} PROPERTIES LABELS crossing COST 1000 ENVIRONMENT
    "GTEST_TOTAL_SHARDS=${crossing_parts};GTEST_SHARD_INDEX=${part};GTEST_OUTPUT=json:${PROJECT_BINARY_DIR}/test-results/crossing_${part}.json")
endforeach()

# Kills renders, in forks of a process that must have no threads of its own.
add_executable(ajar_soak_test tests/soak/soak_test.cpp)
target_link_libraries(ajar_soak_test PRIVATE ajar_test_support GTest::gtest_main)
add_test(NAME soak COMMAND ajar_soak_test)
set_tests_properties(soak PROPERTIES LABELS crossing)

# The program as a user runs it.
file(GLOB cli_tests CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/cli/*_test.cpp)
add_executable(ajar_cli_test ${cli_tests})
ajar_compile_by_folder(ajar_cli_test ${cli_tests})
target_include_directories(ajar_cli_test PRIVATE ${PROJECT_SOURCE_DIR}/tests)
target_compile_definitions(ajar_cli_test PRIVATE AJAR_PROGRAM="$<TARGET_FILE:ajar>"
  AJAR_LIBRARY="$<TARGET_FILE:ajar_library>" AJAR_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
target_link_libraries(ajar_cli_test PRIVATE ajar_post nlohmann_json::nlohmann_json ZLIB::ZLIB GTest::gtest_main)
add_dependencies(ajar_cli_test ajar)
if(TARGET ajar-mpi)
  add_dependencies(ajar_cli_test ajar-mpi)
  target_compile_definitions(ajar_cli_test PRIVATE AJAR_MPIRUN="${MPIEXEC_EXECUTABLE}")
endif()
ajar_compile_quickly(ajar_cli_test)
add_test(NAME cli COMMAND ajar_cli_test)
# Waits as much as it works.
set_tests_properties(cli PROPERTIES LABELS program COST 2000)

# The report's page in a browser, and a program that writes one to look at.
add_library(ajar_report_content STATIC tests/report/example_content.cpp)
target_include_directories(ajar_report_content PUBLIC ${PROJECT_SOURCE_DIR}/tests)
target_link_libraries(ajar_report_content PUBLIC ajar_study_report)
add_executable(ajar_report_example tests/report/example_report.cpp)
target_link_libraries(ajar_report_example PRIVATE ajar_report_content)
add_executable(ajar_report_page_test tests/report/page_test.cpp)
target_compile_definitions(ajar_report_page_test PRIVATE AJAR_PAGE_DRIVERS="${PROJECT_SOURCE_DIR}/tests/report")
target_link_libraries(ajar_report_page_test PRIVATE ajar_report_content GTest::gtest_main)
add_test(NAME report_page COMMAND ajar_report_page_test)
set_tests_properties(report_page PROPERTIES LABELS "program;quick")

# Sources that benchmarks share, with their tests.
file(GLOB measuring_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/bench/measuring/*.cpp)
set(measuring_tests ${measuring_sources})
list(FILTER measuring_sources EXCLUDE REGEX "_test\\.cpp$")
list(FILTER measuring_tests INCLUDE REGEX "_test\\.cpp$")
add_library(ajar_measuring STATIC ${measuring_sources})
ajar_compile_by_folder(ajar_measuring ${measuring_sources})
target_include_directories(ajar_measuring PUBLIC ${PROJECT_SOURCE_DIR}/bench)
target_link_libraries(ajar_measuring PUBLIC ajar_test_support CLI11::CLI11)
add_executable(ajar_measuring_test ${measuring_tests})
ajar_compile_by_folder(ajar_measuring_test ${measuring_tests})
target_link_libraries(ajar_measuring_test PRIVATE ajar_measuring GTest::gtest_main)
ajar_compile_quickly(ajar_measuring_test)
add_test(NAME measuring COMMAND ajar_measuring_test)
find_package(Python3 REQUIRED COMPONENTS Interpreter)
# The page of `ajar view`, with the program, and with a server that renders nothing.
add_test(NAME viewer_page COMMAND ${Python3_EXECUTABLE} -B ${PROJECT_SOURCE_DIR}/tests/viewer/drive_viewer.py
  $<TARGET_FILE:ajar> ${PROJECT_BINARY_DIR}/test-pictures/viewer)
add_test(NAME viewer_mock COMMAND ${Python3_EXECUTABLE} -B ${PROJECT_SOURCE_DIR}/tests/viewer/try_page.py
  ${PROJECT_BINARY_DIR}/viewer_page ${PROJECT_BINARY_DIR}/test-pictures/viewer-mock)
set_tests_properties(viewer_page viewer_mock PROPERTIES LABELS "program" SKIP_RETURN_CODE 77)
add_test(NAME results COMMAND ${Python3_EXECUTABLE} -B ${PROJECT_SOURCE_DIR}/bench/results_test.py)
add_test(NAME comments COMMAND ${Python3_EXECUTABLE} -B ${PROJECT_SOURCE_DIR}/cmake/check_comments.py --self-test)
set_tests_properties(measuring results comments PROPERTIES LABELS "bench;quick")

# Counting allocations replaces operator new, so only the program that reports them has it.
foreach(name budget error estimate finished lights limit time)
  add_executable(ajar_${name}_bench bench/${name}_bench.cpp)
  target_link_libraries(ajar_${name}_bench PRIVATE ajar_measuring)
  target_compile_options(ajar_${name}_bench PRIVATE -O1)  # times the libraries, not its own code
endforeach()
target_sources(ajar_limit_bench PRIVATE bench/allocations.cpp)

# The example as its reader builds it: elsewhere, with what is installed alone.
add_test(NAME package COMMAND ${CMAKE_COMMAND}
  -D BUILD=${PROJECT_BINARY_DIR} -D EXAMPLE=${PROJECT_SOURCE_DIR}/examples/render -D SOURCE=${PROJECT_SOURCE_DIR}
  -D COMPILER=${CMAKE_CXX_COMPILER} -D "SANITIZE=${AJAR_SANITIZE}" -P ${PROJECT_SOURCE_DIR}/tests/package/package_test.cmake)
set_tests_properties(package PROPERTIES LABELS "program;quick")

# Python's package with the library of this build. `./dev test` makes an environment with what its tests need; without one they are
# skipped.
# A sanitizer's own library must be the first of a process, which is not for a library to say.
if(NOT AJAR_SANITIZE)
  add_test(NAME python COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/python/tests/run.py
    $<TARGET_LINKER_FILE:ajar_library> ${PROJECT_SOURCE_DIR}/build/python-tests/bin/python)
  set_tests_properties(python PROPERTIES LABELS program SKIP_RETURN_CODE 77 COST 900)
endif()
