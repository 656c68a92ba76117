# The tests. run.c compares with the goldens, every test_<name>.c in a folder of tests/ is a
# program, and scripts are named below. Each runs from the project's root; status 77 means that a
# needed package is not installed, and ctest lists the test as skipped at its end.
pkg_check_modules(CMOCKA REQUIRED IMPORTED_TARGET cmocka)
pkg_check_modules(MPFR REQUIRED IMPORTED_TARGET mpfr)
find_library(EMBREE embree3 REQUIRED) # traces the rays of tests/frame_reference/reference_ray.c

# leaks.txt suppresses small leaks of Mesa for every context, and fontconfig's tables. An arithmetic
# fault traps: handle_sigill prints where. The quarantine of freed memory is 16 MB instead of 256,
# and pages are kept: requesting them from the system took a fourth of the time of drawing tests.
set(LEAKS "ASAN_OPTIONS=detect_leaks=1:handle_sigill=1:quarantine_size_mb=16:allocator_release_to_os_interval_ms=-1;LSAN_OPTIONS=suppressions=${PROJECT_SOURCE_DIR}/tests/leaks.txt:print_suppressions=0")
# matc_test(name command...)
function(matc_test name)
  add_test(NAME ${name} COMMAND ${ARGN} WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
  set_tests_properties(${name} PROPERTIES SKIP_RETURN_CODE 77 ENVIRONMENT "${LEAKS}")
endfunction()

# Tests with equal results in both builds run only in the sanitized build if both exist: ./setup
# test under CI. Tests that the sanitized build omits or thins out, and quick tests, run in both.
option(MATC_TESTS_ONCE "Leaves out tests that the sanitized build runs in full" OFF)
set(SANITIZED FALSE)
if(CMAKE_C_FLAGS MATCHES "sanitize")
  set(SANITIZED TRUE)
endif()

add_executable(golden tests/run.c)
target_link_libraries(golden PRIVATE matc_tool)
set_target_properties(golden PROPERTIES LINKER_LANGUAGE CXX)
matc_test(golden golden ${PROJECT_SOURCE_DIR})
matc_test(embed_example embed_example)

# Ends a process at its n-th call, or lets that fail. Of no sanitizer's: it is loaded before them.
add_library(strike MODULE tests/kill/strike.c)
target_compile_options(strike PRIVATE -fno-sanitize=all)
target_link_libraries(strike PRIVATE matc_flags ${CMAKE_DL_LIBS})
target_link_options(strike PRIVATE -fno-sanitize=all)

# Makes the n-th allocation fail, for tests/tool/out_of_memory.sh
add_library(failing_malloc MODULE tests/kill/failing_malloc.c)
target_compile_options(failing_malloc PRIVATE -fno-sanitize=all)
target_link_libraries(failing_malloc PRIVATE matc_flags)
target_link_options(failing_malloc PRIVATE -fno-sanitize=all)

# ctest -L quick: for the inner loop, a few seconds in all
set(QUICK golden abi embed_example functions layers locale exports format words tutorial)

file(GLOB TESTS CONFIGURE_DEPENDS tests/test_*.c tests/*/test_*.c tests/*/*/test_*.c)
# A test passes properties to ctest by a comment line, /* ctest: WORD... */. The words are:
#   unsanitized  Not in the sanitized build. Either the test measures stack or memory, which
#                sanitizers change; or its results are means or pictures, which they cannot change;
#                or the driver's compiler would take minutes, and another test runs the same code
#                under sanitizers.
#   alone        A program of its own where tests are joined: tests that use kill/world.c, and those
#                with megabytes of arrays, which LeakSanitizer would scan in every joined test.
#   unoptimized  Without optimizations of Mesa's shader compiler, which takes most of the time of the
#                test. It then takes two thirds of the time and draws the same bits.
#   small-pages  Without large pages, since the test measures memory or stack.
#   quick        In ctest -L quick, too.
#   seconds=N    Usual time from 10 seconds on: a first run starts the longest tests first.
set(WORDS unsanitized alone unoptimized small-pages quick)
foreach(file ${TESTS})
  get_filename_component(name ${file} NAME_WE)
  file(STRINGS ${file} line REGEX "^/[*] ctest: .* [*]/$")
  string(REGEX REPLACE "^/[*] ctest: (.*) [*]/$" "\\1" words "${line}")
  separate_arguments(words)
  foreach(word ${words})
    if(word MATCHES "^seconds=([0-9]+)$")
      list(APPEND LONG ${name}=${CMAKE_MATCH_1})
    elseif(word IN_LIST WORDS)
      list(APPEND WITH_${word} ${name})
    else()
      message(FATAL_ERROR "${file}: ctest: has no word ${word}")
    endif()
  endforeach()
endforeach()
list(APPEND QUICK ${WITH_quick})
# A program of tests, and what some of them need beside
function(matc_test_program program)
  add_executable(${program} ${ARGN})
  target_compile_definitions(${program} PRIVATE SOURCE_FOLDER="${PROJECT_SOURCE_DIR}" MATC_PROGRAM="$<TARGET_FILE:matc>"
    MATVIEW_PROGRAM="$<TARGET_FILE:matview>")
  target_link_libraries(${program} PRIVATE test_support matc_tool matc_autotune matc_view PkgConfig::CMOCKA PkgConfig::CJSON)
  set_target_properties(${program} PROPERTIES LINKER_LANGUAGE CXX RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/tests)
endfunction()
function(matc_test_needs program name)
  if(name STREQUAL test_host OR name STREQUAL test_host_arguments OR name STREQUAL test_frame_moved)
    target_include_directories(${program} PRIVATE ${MATC_PUBLIC})
  elseif(name STREQUAL test_picture_file)
    target_include_directories(${program} SYSTEM PRIVATE ${OPENEXR_INCLUDE})
  elseif(name MATCHES "^test_exact")
    target_link_libraries(${program} PRIVATE PkgConfig::MPFR)
  elseif(name MATCHES "^test_frame")
    target_link_libraries(${program} PRIVATE ${EMBREE})
  elseif(name MATCHES "^test_kill")
    target_sources(${program} PRIVATE tests/kill/world.c)
    target_compile_definitions(${program} PRIVATE STRIKE_LIBRARY="$<TARGET_FILE:strike>")
    add_dependencies(${program} strike matc)
  endif()
endfunction()
# Linking two hundred programs takes a minute of CPU time; a joined one takes a second:
# tests/joined NAME ARGUMENTS... There are two, because tests that do not draw start faster without
# the renderer's libraries.
option(MATC_TESTS_JOINED "Makes two programs of most tests, for who runs all of them" OFF)
set(JOINED joined joined_frame)
if(MATC_TESTS_JOINED)
  foreach(program ${JOINED})
    matc_test_program(${program} tests/joined.c)
    target_include_directories(${program} PRIVATE ${PROJECT_BINARY_DIR})
    target_compile_definitions(${program} PRIVATE JOINED_TESTS="gen/${program}.def")
  endforeach()
endif()
foreach(file ${TESTS})
  get_filename_component(name ${file} NAME_WE)
  file(STRINGS ${file} partly REGEX "tests/(sanitized|kill/world)[.]h")
  if(SANITIZED AND name IN_LIST WITH_unsanitized)
    continue()
  elseif(MATC_TESTS_ONCE AND NOT partly AND NOT name IN_LIST WITH_unsanitized AND NOT name IN_LIST QUICK)
    continue()
  endif()
  if(MATC_TESTS_JOINED AND NOT name IN_LIST WITH_alone)
    file(STRINGS ${file} draws REGEX "\"(runtime|tests/(draw|frame|frame_reference|meshes|value))/")
    set(program joined)
    if(draws)
      set(program joined_frame)
    endif()
    target_sources(${program} PRIVATE ${file})
    set_source_files_properties(${file} PROPERTIES COMPILE_DEFINITIONS main=${name}_main)
    file(STRINGS ${file} main REGEX "^int main[(]void[)]")
    string(APPEND ROWS_${program} "TEST(${name}, $<IF:$<BOOL:${main}>,void,ARGUMENTS>)\n")
    matc_test_needs(${program} ${name})
    set(PROGRAM_${name} ${program} ${name})
  else()
    matc_test_program(${name} ${file})
    matc_test_needs(${name} ${name})
    set(PROGRAM_${name} ${name})
  endif()
  matc_test(${name} ${PROGRAM_${name}})
endforeach()
if(MATC_TESTS_JOINED)
  foreach(program ${JOINED})
    file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/gen/${program}.def CONTENT "${ROWS_${program}}")
  endforeach()
endif()
if(NOT MATC_TESTS_ONCE)
  matc_test(test_gl_egl ${PROGRAM_test_gl} egl)
  matc_test(test_gl_texture_egl ${PROGRAM_test_gl_texture} egl)
endif()

# Rebuilds the stages that read ops.def with the operation that the file's head explains: a new
# operation needs a row and no other file. Other stages are reused, even if they access its tables,
# because ir.h declares these without a length.
set(ADDED ${PROJECT_BINARY_DIR}/operation/grammar/ops.def)
add_custom_command(OUTPUT ${ADDED} COMMAND sh -c "mkdir -p operation/grammar && awk -f $1 $2 >$3" - ${PROJECT_SOURCE_DIR}/tests/operation/add.awk
    ${PROJECT_SOURCE_DIR}/grammar/ops.def ${ADDED} WORKING_DIRECTORY ${PROJECT_BINARY_DIR}
  DEPENDS ${PROJECT_SOURCE_DIR}/tests/operation/add.awk ${PROJECT_SOURCE_DIR}/grammar/ops.def VERBATIM)
foreach(file ${COMPILER})
  file(STRINGS ${file} reads REGEX "grammar/ops[.]def|OP_COUNT")
  if(reads) # the others do not change: libmatc has them
    list(APPEND READERS ${file})
  endif()
endforeach()
add_executable(operation tests/operation/inversesqrt.c ${READERS} ${ADDED})
target_include_directories(operation BEFORE PRIVATE ${PROJECT_BINARY_DIR}/operation)
target_include_directories(operation PRIVATE ${GLSLANG_INCLUDE})
target_compile_options(operation PRIVATE -O0)
target_link_libraries(operation PRIVATE libmatc PkgConfig::XXHASH PkgConfig::CJSON)
set_target_properties(operation PROPERTIES LINKER_LANGUAGE CXX RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/tests)
matc_test(operation operation)

# Polynomials of the renderer's lobes, to be put into its GLSL: programs to run by hand
foreach(name principled anisotropy area film diffuse)
  add_executable(fit_${name} EXCLUDE_FROM_ALL tests/fits/${name}.c tests/fits/solve.c)
  target_include_directories(fit_${name} PRIVATE ${PROJECT_SOURCE_DIR})
  target_link_libraries(fit_${name} PRIVATE matc_flags m)
  set_target_properties(fit_${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/tests)
endforeach()

# LeakSanitizer crashes on the thread-local storage of hundreds of closed contexts; without
# scanning it, it finds as many leaks.
foreach(name test_mended test_gl_egl)
  if(TEST ${name})
    set_tests_properties(${name} PROPERTIES ENVIRONMENT "${LEAKS}:use_tls=0")
  endif()
endforeach()

foreach(name ${WITH_unoptimized})
  if(TEST ${name})
    set_property(TEST ${name} APPEND PROPERTY ENVIRONMENT GALLIVM_PERF=nopt)
  endif()
endforeach()

# Large pages, where the kernel has them, take a tenth off what draws without sanitizers.
if(MATC_TESTS_ONCE AND MATC_TESTS_JOINED)
  foreach(file ${TESTS})
    get_filename_component(name ${file} NAME_WE)
    if(TEST ${name} AND PROGRAM_${name} MATCHES "joined_frame" AND NOT name IN_LIST WITH_small-pages)
      set_property(TEST ${name} APPEND PROPERTY ENVIRONMENT GLIBC_TUNABLES=glibc.malloc.hugetlb=1:glibc.malloc.mmap_threshold=1073741824:glibc.malloc.trim_threshold=4294967296)
    endif()
  endforeach()
endif()

# From outside
if(NOT MATC_TESTS_ONCE)
  matc_test(command_line sh tests/tool/command_line.sh $<TARGET_FILE:matc>)
  matc_test(batch sh tests/tool/batch.sh $<TARGET_FILE:matc>)
  matc_test(folder sh tests/tool/folder.sh $<TARGET_FILE:matc>)
  matc_test(links sh tests/tool/links.sh $<TARGET_FILE:matc> $<TARGET_FILE:matview>)
  matc_test(lists sh tests/docs/lists.sh $<TARGET_FILE:matc>)
  matc_test(options sh tests/tool/options.sh $<TARGET_FILE:matc>)
  matc_test(names sh tests/tool/names.sh $<TARGET_FILE:matc>)
  matc_test(special sh tests/tool/special.sh $<TARGET_FILE:matc>)
  matc_test(watch sh tests/tool/watch.sh $<TARGET_FILE:matc>)
  matc_test(schema sh tests/schema/run.sh $<TARGET_FILE:matc> ${PROJECT_BINARY_DIR})
  add_executable(tree_json tests/suites/tree.c)
  target_link_libraries(tree_json PRIVATE libmatc)
  set_target_properties(tree_json PROPERTIES LINKER_LANGUAGE CXX)
  matc_test(suites sh tests/suites/run.sh $<TARGET_FILE:tree_json> ${PROJECT_BINARY_DIR})
endif()
if(TEST test_frame_meshes)
  matc_test(meshes sh tests/meshes/fetch.sh ${PROJECT_BINARY_DIR})
  set_tests_properties(test_frame_meshes PROPERTIES DEPENDS meshes)
endif()

# The libraries and packages
set(LIBRARIES ${MATC_KINDS})
list(TRANSFORM LIBRARIES REPLACE "(.+)" "$<TARGET_FILE:matc_\\1>")
matc_test(abi sh tests/packaging/abi.sh ${LIBRARIES} $<TARGET_FILE:matc_render_shared>)
if(NOT SANITIZED) # a program without sanitizers cannot link to a library with them
  matc_test(package sh tests/packaging/package.sh ${PROJECT_BINARY_DIR})
  matc_test(install sh tests/packaging/install.sh ${PROJECT_BINARY_DIR})
  matc_test(install_make sh tests/packaging/install.sh ${PROJECT_BINARY_DIR} "Unix Makefiles")
  matc_test(subproject sh tests/packaging/subproject.sh)
  matc_test(add sh tests/docs/add.sh ${PROJECT_BINARY_DIR})
  foreach(tool ninja make meson)
    matc_test(build_${tool} sh tests/packaging/build_tools.sh ${PROJECT_BINARY_DIR} ${tool})
  endforeach()
endif()

# Tests with equal results in every build: checks of the sources, of SPIR-V, of figures in docs/,
# and the browser as a second judge of WebGL 2 programs (ctest -L browser)
if(NOT SANITIZED)
  matc_test(functions matbench functions)
  matc_test(instructions matbench instructions) # against shaders by hand
  matc_test(matbench sh tests/tool/matbench.sh $<TARGET_FILE:matbench>)
  # Tests only depfiles; command_line.sh writes some under sanitizers.
  matc_test(depfile sh tests/tool/depfile.sh $<TARGET_FILE:matc>)
  matc_test(view sh tests/viewer/view.sh $<TARGET_FILE:matview>)
  matc_test(out_of_memory sh tests/tool/out_of_memory.sh $<TARGET_FILE:matc> $<TARGET_FILE:failing_malloc>)
  matc_test(root sh tests/tool/root.sh $<TARGET_FILE:matc> $<TARGET_FILE:matview>)
  matc_test(order sh tests/sources/order.sh)
  matc_test(layers sh tests/sources/layers.sh ${CMAKE_CURRENT_BINARY_DIR})
  matc_test(locale sh tests/sources/locale.sh)
  matc_test(readmes sh tests/sources/readmes.sh)
  matc_test(exports sh tests/sources/exports.sh ${CMAKE_CURRENT_BINARY_DIR})
  matc_test(format sh tests/sources/format.sh)
  matc_test(words sh tests/words.sh)
  matc_test(tidy sh tests/sources/tidy.sh ${PROJECT_BINARY_DIR})
  # Checks for stale rows; tests/README.md explains how to run the mutants.
  matc_test(mutants sh tests/mutants/run.sh --check)
  matc_test(test_valid_spirv ${PROGRAM_test_valid} spirv)
  matc_test(pages sh tests/docs/pages.sh $<TARGET_FILE:matc> $<TARGET_FILE:matview>)
  matc_test(pictured sh tests/docs/pictured.sh $<TARGET_FILE:matc> ${PROJECT_BINARY_DIR}/reference)
  matc_test(reference sh tests/docs/reference.sh $<TARGET_FILE:docs>)
  matc_test(site sh tests/docs/site.sh ${PROJECT_BINARY_DIR})
  matc_test(pictures sh tests/docs/pictures.sh $<TARGET_FILE:matc> $<TARGET_FILE:matview>)
  matc_test(howto sh tests/docs/howto.sh $<TARGET_FILE:matc> $<TARGET_FILE:matview>)
  matc_test(tutorial sh tests/docs/tutorial.sh $<TARGET_FILE:matc> $<TARGET_FILE:matview>)
  matc_test(figures sh tests/docs/figures.sh ${PROJECT_BINARY_DIR})
  matc_test(browser sh tests/browser/run.sh $<TARGET_FILE:matc> ${PROJECT_BINARY_DIR})
  set_tests_properties(browser PROPERTIES LABELS browser)
endif()

# Usual seconds of tests other than test_*.c; later runs go by measured times.
list(APPEND LONG howto=15 install_make=101 add=81 pictures=80 batch=78 install=66 figures=57 subproject=55
  command_line=46 site=25 schema=33 test_valid_spirv=33 package=26 links=25 special=23 view=22 order=21
  fuzz_scene_seeds=21 folder=16 names=15 pages=12 options=10 layers=10)
foreach(pair ${LONG})
  string(REPLACE "=" ";" pair ${pair})
  list(GET pair 0 name)
  list(GET pair 1 seconds)
  if(TEST ${name})
    set_tests_properties(${name} PROPERTIES COST ${seconds})
  endif()
endforeach()

# Those of the inner loop
foreach(name ${QUICK})
  if(TEST ${name})
    set_tests_properties(${name} PROPERTIES LABELS quick)
  endif()
endforeach()
