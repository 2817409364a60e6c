# ew_add_library, ew_add_test, ew_add_gui_test: one way to make a target, so that flags and rules reach every one of them.

add_library(ew_warnings INTERFACE)
add_library(ew::warnings ALIAS ew_warnings)
target_compile_options(ew_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Wold-style-cast -Woverloaded-virtual
  $<$<NOT:$<BOOL:$<TARGET_PROPERTY:EW_COMPILED_QUICKLY>>>:-Wnull-dereference> -Wdouble-promotion $<$<BOOL:${EW_WARNINGS_AS_ERRORS}>:-Werror>
  # An enumerator that is added has to be given its words and its ways, in every preset (tests/rules/words_of_enums_test.cpp).
  $<$<NOT:$<BOOL:${EW_WARNINGS_AS_ERRORS}>>:-Werror=switch>)

# At -O3 GCC 12 warns about the inside of std::string (its bug 105651) and of the JSON library; at -O2, where warnings are errors, it does not.
target_compile_options(ew_warnings INTERFACE $<$<CONFIG:Release>:-Wno-restrict> $<$<CONFIG:Release>:-Wno-null-dereference>)

# Sources joined by EW_UNITY are not the file that is compiled, so GCC takes their anonymous namespaces for those of headers.
target_compile_options(ew_warnings INTERFACE $<$<BOOL:${EW_UNITY}>:-Wno-subobject-linkage>)

include(EwSanitizers)
include(EwPrecompile)
include(${CMAKE_CURRENT_LIST_DIR}/../workstation/sdk/cmake/EwKnownWords.cmake)

# ew_compile_quickly(TARGET): what the target does itself is little beside what it calls, so it is optimised less, which compiles in a third
# less time. At -O1 GCC 12 takes the JSON library's pointers for null.
function(ew_compile_quickly target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Dev>:-O1> $<$<CONFIG:Release>:-O2>)
  set_target_properties(${target} PROPERTIES EW_COMPILED_QUICKLY ON)
endfunction()

# ew_join_sources(TARGET [APART SOURCES...]): several sources of a target are compiled as one (EW_UNITY of them), which reads their headers and
# instantiates their templates once. Only sources of one folder are joined, so what is private to a file may have its name in another room.
# Left alone are sources that use a name of their neighbours for something else (APART, said by whoever adds the target) and those that
# highway compiles once for each instruction set.
function(ew_join_sources target)
  cmake_parse_arguments(arg "" "" "APART" ${ARGN})
  if(NOT EW_UNITY)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  get_target_property(sources ${target} SOURCES)
  foreach(source ${sources})
    set(file ${source})
    if(NOT IS_ABSOLUTE "${file}")
      set(file ${CMAKE_CURRENT_SOURCE_DIR}/${file})
    endif()
    if(source IN_LIST arg_APART OR NOT file MATCHES "\\.cpp$" OR NOT EXISTS "${file}")
      continue()
    endif()
    file(STRINGS "${file}" targets REGEX "hwy/foreach_target.h")
    if(targets)
      continue()
    endif()
    get_filename_component(folder ${file} DIRECTORY)
    file(RELATIVE_PATH folder ${CMAKE_CURRENT_SOURCE_DIR} ${folder})
    string(MAKE_C_IDENTIFIER "in_${folder}" folder)
    math(EXPR batch "0${joined_${folder}} / ${EW_UNITY}")
    math(EXPR joined_${folder} "0${joined_${folder}} + 1")
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${folder}_${batch})
  endforeach()
endfunction()

# ew_add_library(NAME HEADERS ... SOURCES ... PUBLIC ... PRIVATE ... [APART ...] [PRECOMPILED kind] [QT]): the static library ew_NAME, also
# known as ew::NAME. include/ is its interface; src/ is nobody else's business. QT turns on moc for this target; kind as in EwPrecompile.
function(ew_add_library name)
  cmake_parse_arguments(arg "QT" "PRECOMPILED" "HEADERS;SOURCES;PUBLIC;PRIVATE;RESOURCES;APART" ${ARGN})
  ew_refuse_unknown_words("ew_add_library(${name})" HEADERS SOURCES PUBLIC PRIVATE RESOURCES APART)
  add_library(ew_${name} STATIC ${arg_HEADERS} ${arg_SOURCES} ${arg_RESOURCES})
  add_library(ew::${name} ALIAS ew_${name})
  target_include_directories(ew_${name} PUBLIC $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:include>
    PRIVATE ${CMAKE_CURRENT_SOURCE_DIR}/src)
  target_compile_features(ew_${name} PUBLIC cxx_std_20)
  target_link_libraries(ew_${name} PUBLIC ${arg_PUBLIC} PRIVATE ${arg_PRIVATE} $<BUILD_INTERFACE:ew::warnings> $<BUILD_INTERFACE:ew::sanitizers>)
  if(arg_QT)
    set_target_properties(ew_${name} PROPERTIES AUTOMOC ON AUTORCC ON)
    target_compile_definitions(ew_${name} PUBLIC QT_NO_KEYWORDS)
    set(arg_PRECOMPILED window)
  elseif(NOT arg_PRECOMPILED)
    set(arg_PRECOMPILED library)
  endif()
  ew_precompile(ew_${name} ${arg_PRECOMPILED})
  ew_join_sources(ew_${name} APART ${arg_APART})
endfunction()

# ew_group_test(TARGET): the target tests_FOLDER builds all test programs of the folder of tests/ they stand in.
function(ew_group_test target)
  get_filename_component(folder ${CMAKE_CURRENT_SOURCE_DIR} NAME)
  if(NOT TARGET tests_${folder})
    add_custom_target(tests_${folder})
  endif()
  add_dependencies(tests_${folder} ${target})
endfunction()

# For programs that open plugins: the mark of a thread that somebody waits for (ew/core/responsive_thread.h) is the program's, and not one of
# each copy of core.
set(EW_EXPORT_THREAD_MARK "LINKER:--export-dynamic-symbol=ewResponsiveMarks")

# ew_link_test(TARGET): without lines for a debugger, which are three quarters of a test program and of the 17 GiB that a whole build would
# take; functions keep their names. Sanitizers get them, for their reports.
option(EW_TEST_LINES "Keep lines for a debugger in the test programs" OFF)
function(ew_link_test target)
  if(NOT EW_TEST_LINES AND NOT EW_SANITIZE AND CMAKE_EXECUTABLE_FORMAT STREQUAL "ELF")
    target_link_options(${target} PRIVATE LINKER:--strip-debug)
  endif()
endfunction()

# ew_add_test(NAME SOURCES ... LINK ... [LABELS ...] [TIMEOUT s]): a GoogleTest program tests/ run by ctest, one entry per TEST.
# TIMEOUT guards against hanging alone: it is at least ten times what a test takes on a machine that does nothing else.
function(ew_add_test name)
  if(NOT EW_BUILD_TESTS)
    return()
  endif()
  cmake_parse_arguments(arg "" "TIMEOUT" "SOURCES;LINK;LABELS;APART" ${ARGN})
  ew_refuse_unknown_words("ew_add_test(${name})" SOURCES LINK LABELS APART)
  if(NOT arg_LABELS)
    set(arg_LABELS unit)
  endif()
  if(NOT arg_TIMEOUT)
    set(arg_TIMEOUT 900)
  endif()
  add_executable(test_${name} ${arg_SOURCES})
  ew_join_sources(test_${name} APART ${arg_APART})
  ew_group_test(test_${name})
  ew_link_test(test_${name})
  target_link_libraries(test_${name} PRIVATE ${arg_LINK} ew_test_places GTest::gtest GTest::gtest_main rapidcheck ew::warnings ew::sanitizers)
  target_include_directories(test_${name} PRIVATE ${CMAKE_SOURCE_DIR}/tests)
  ew_compile_quickly(test_${name})
  if(NOT "${arg_LINK}" MATCHES "Qt5::") # with Qt the compiler makes another kind of code
    ew_precompile(test_${name} test)
  endif()
  include(GoogleTest)
  math(EXPR timeout_s "${arg_TIMEOUT} * ${EW_TEST_SLOWDOWN}")
  gtest_discover_tests(test_${name} DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 300 PROPERTIES LABELS "${arg_LABELS}" TIMEOUT ${timeout_s})
  if(EW_SANITIZE)
    target_compile_definitions(test_${name} PRIVATE EW_TEST_SLOWDOWN=${EW_TEST_SLOWDOWN})
    # The PROPERTIES of gtest_discover_tests cannot carry a list; ctest reads this file after the tests were discovered.
    set(file ${CMAKE_CURRENT_BINARY_DIR}/test_${name}_environment.cmake)
    file(WRITE ${file} "foreach(test \${test_${name}_TESTS})\n  set_tests_properties(\"\${test}\" PROPERTIES ENVIRONMENT \"${EW_TEST_ENVIRONMENT}\")\nendforeach()\n")
    set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${file})
  endif()
endfunction()

# ew_add_gui_test(NAME SOURCES ... LINK ...): a QtTest program with its own main, run on the one X server that ./check starts.
function(ew_add_gui_test name)
  if(NOT EW_BUILD_TESTS)
    return()
  endif()
  cmake_parse_arguments(arg "" "TIMEOUT" "SOURCES;LINK" ${ARGN})
  ew_refuse_unknown_words("ew_add_gui_test(${name})" SOURCES LINK)
  if(NOT arg_TIMEOUT)
    set(arg_TIMEOUT 1800)
  endif()
  add_executable(test_gui_${name} ${arg_SOURCES})
  set_target_properties(test_gui_${name} PROPERTIES AUTOMOC ON)
  ew_link_test(test_gui_${name})
  target_link_libraries(test_gui_${name} PRIVATE ${arg_LINK} ew_test_places Qt5::Test Qt5::Widgets ew::warnings ew::sanitizers)
  target_include_directories(test_gui_${name} PRIVATE ${CMAKE_SOURCE_DIR}/tests)
  target_compile_definitions(test_gui_${name} PRIVATE QT_NO_KEYWORDS)
  ew_compile_quickly(test_gui_${name})
  ew_precompile(test_gui_${name} window_test)
  if(EW_SANITIZE)
    target_compile_definitions(test_gui_${name} PRIVATE EW_TEST_SLOWDOWN=${EW_TEST_SLOWDOWN})
  endif()
  if(EW_SANITIZE MATCHES "thread")
    # Qt, VTK and Mesa's rasteriser are built without the sanitizer and hide their locks from it; test_jobs watches the window's threads.
    set_target_properties(test_gui_${name} PROPERTIES EXCLUDE_FROM_ALL ON)
    return()
  endif()
  add_test(NAME gui_${name} COMMAND test_gui_${name})
  math(EXPR timeout_s "${arg_TIMEOUT} * ${EW_TEST_SLOWDOWN}")
  # QtTest ends a function after five minutes unless it is told otherwise.
  # Graphics drivers and input methods are unloaded before leaks are looked for, so theirs cannot be told apart by name.
  string(REPLACE "ASAN_OPTIONS=" "ASAN_OPTIONS=detect_leaks=0:" environment "${EW_TEST_ENVIRONMENT}")
  # One at a time, for there is one display; begun first, so that the other cores have the rest to do meanwhile.
  set_tests_properties(gui_${name} PROPERTIES LABELS gui TIMEOUT ${timeout_s} RESOURCE_LOCK display COST 1000
    ENVIRONMENT "QT_QPA_PLATFORM=xcb;LP_NUM_THREADS=1;XDG_RUNTIME_DIR=/tmp;ECHOWEAVE_CACHE=${CMAKE_BINARY_DIR}/tests/cache;QTEST_FUNCTION_TIMEOUT=${timeout_s}000;${environment}")
endfunction()

# ew_add_window_test(FOLDER/NAME [SOURCES ...] [LINK ...] [NEEDS targets] [WITH plugins] [DEFINE ...] [TIMEOUT s]): the GUI test gui_NAME of
# FOLDER/NAME_test.cpp and SOURCES, which reaches the window by ew::ui_test_door. Without one of the targets that it NEEDS it is left out;
# of the plugins that it is run WITH those that are configured are built before, and EW_WITH_PLUGIN says so to the source.
function(ew_add_window_test file)
  cmake_parse_arguments(arg "" "TIMEOUT" "SOURCES;LINK;NEEDS;WITH;DEFINE" ${ARGN})
  ew_refuse_unknown_words("ew_add_window_test(${file})" SOURCES LINK NEEDS WITH DEFINE)
  foreach(needed ${arg_NEEDS})
    if(NOT TARGET ${needed})
      return()
    endif()
  endforeach()
  if(NOT arg_TIMEOUT)
    set(arg_TIMEOUT 1800)
  endif()
  get_filename_component(name ${file} NAME)
  set(target test_gui_${name})
  ew_add_gui_test(${name} SOURCES ${file}_test.cpp ${arg_SOURCES} LINK ew::ui_test_door ${arg_LINK} TIMEOUT ${arg_TIMEOUT})
  if(arg_DEFINE)
    target_compile_definitions(${target} PRIVATE ${arg_DEFINE})
  endif()
  vtk_module_autoinit(TARGETS ${target} MODULES ${VTK_LIBRARIES})
  foreach(plugin ${arg_WITH})
    if(TARGET ew_plugin_${plugin})
      string(TOUPPER ${plugin} word)
      target_compile_definitions(${target} PRIVATE EW_WITH_${word})
      list(APPEND arg_NEEDS ew_plugin_${plugin})
    endif()
  endforeach()
  if(arg_NEEDS)
    add_dependencies(${target} ${arg_NEEDS})
  endif()
endfunction()
