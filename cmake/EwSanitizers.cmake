# ew::sanitizers carries the compiler flags of EW_SANITIZE; EW_TEST_ENVIRONMENT holds the run-time options every test is started with, so
# that `ctest --preset asan` and `ctest --preset tsan` are quiet about other people's libraries and about nothing of ours.
add_library(ew_sanitizers INTERFACE)
add_library(ew::sanitizers ALIAS ew_sanitizers)
set(EW_TEST_ENVIRONMENT "")
set(EW_TEST_SLOWDOWN 1) # time limits of tests are multiplied by it, those inside tests through tests/time_limit.h
if(NOT EW_SANITIZE)
  return()
endif()

target_compile_options(ew_sanitizers INTERFACE -fsanitize=${EW_SANITIZE} -fno-omit-frame-pointer)
target_link_options(ew_sanitizers INTERFACE -fsanitize=${EW_SANITIZE})
set(suppressions ${CMAKE_CURRENT_LIST_DIR}/sanitizers)
if(EW_SANITIZE MATCHES "address")
  # No strict_string_checks: Qt's keyboard library copies names out of X replies that end without a zero, as strndup allows.
  # Memory that cannot be had is std::bad_alloc here as it is without the sanitizer; tests of oversized files rely on it.
  list(APPEND EW_TEST_ENVIRONMENT
    "ASAN_OPTIONS=allocator_may_return_null=1:check_initialization_order=1:strict_init_order=1:detect_stack_use_after_return=1"
    "LSAN_OPTIONS=suppressions=${suppressions}/lsan.supp:print_suppressions=0")
  set(EW_TEST_SLOWDOWN 5)
endif()
if(EW_SANITIZE MATCHES "undefined")
  target_compile_options(ew_sanitizers INTERFACE -fno-sanitize-recover=undefined)
  list(APPEND EW_TEST_ENVIRONMENT "UBSAN_OPTIONS=print_stacktrace=1")
endif()
if(EW_SANITIZE MATCHES "thread")
  # Libraries that are not built with the sanitizer hide their synchronisation from it; what they do among themselves is not ours to judge.
  list(APPEND EW_TEST_ENVIRONMENT
    "TSAN_OPTIONS=suppressions=${suppressions}/tsan.supp:print_suppressions=0:ignore_noninstrumented_modules=1:allocator_may_return_null=1:second_deadlock_stack=1")
  set(EW_TEST_SLOWDOWN 10)
endif()
