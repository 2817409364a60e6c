# Instructions of ten frames (highway's and TBB's start is not in them). What must hold:
#   - the neutral plan runs as many instructions, to the last one, in a program that has no effect's code in it;
#   - it runs at most 3000 a frame more than the slicer alone (check of the pose, plan, clock), and shows the same picture.

function(count out program way)
  execute_process(COMMAND ${VALGRIND} --tool=callgrind --callgrind-out-file=/dev/null --collect-atstart=no ${program} ${way} ${QUALITY}
    OUTPUT_VARIABLE picture ERROR_VARIABLE report RESULT_VARIABLE failed)
  # The processors of some virtual machines do not tell of RDTSCP, which highway runs when it is loaded: valgrind then refuses it, and
  # there is nothing that could be counted.
  if(report MATCHES "unhandled instruction bytes: 0xF 0x1 0xF9")
    set(${out} refused PARENT_SCOPE)
    return()
  endif()
  if(failed OR NOT report MATCHES "Collected : ([0-9]+)")
    message(FATAL_ERROR "${program} ${way} ${QUALITY} did not run: ${failed}\n${picture}${report}")
  endif()
  set(${out} ${CMAKE_MATCH_1} PARENT_SCOPE)
  set(${out}_picture "${picture}" PARENT_SCOPE)
endfunction()

count(plan ${WITH} plan)
if(plan STREQUAL "refused")
  message("Skipped: valgrind cannot run highway's RDTSCP on this processor, so that no instructions can be counted.")
  return()
endif()
count(without ${WITHOUT} plan)
count(bare ${WITH} slice)
math(EXPR added "(${plan} - ${bare}) / 10")
message("ten frames, ${QUALITY}: neutral plan ${plan} instructions, without effects in the program ${without}, slicer alone ${bare}; "
  "the plan adds ${added} a frame")
if(NOT plan_picture STREQUAL bare_picture OR NOT plan_picture STREQUAL without_picture)
  message(FATAL_ERROR "the pictures differ: ${plan_picture}, ${without_picture}, ${bare_picture}")
endif()
if(NOT plan EQUAL without)
  message(FATAL_ERROR "an effect that is not used costs instructions")
endif()
if(added GREATER 3000)
  message(FATAL_ERROR "the neutral plan does more than slice")
endif()
