# ew_refuse_unknown_words(CALL LIST...): stops the configuration when cmake_parse_arguments(arg ...) met a word that CALL does not know, also where
# one of the given lists of several values swallowed it: "PANELS p.cpp" after ENTRY would build a plugin without its panel, and say nothing.
# A keyword that nothing follows is a slip as well: "PANEL" before "ENTRY plugin.cpp" would do the same.
# Keywords are written in capitals; sources, targets, labels and capabilities are not.
include_guard(GLOBAL)

macro(ew_refuse_unknown_words call)
  set(unknown ${arg_UNPARSED_ARGUMENTS})
  foreach(list ${ARGN})
    foreach(word IN LISTS arg_${list})
      if(word MATCHES "^[A-Z][A-Z_]+$")
        list(APPEND unknown "${word}")
      endif()
    endforeach()
  endforeach()
  if(unknown)
    list(JOIN unknown " " unknown)
    message(FATAL_ERROR "${call} does not know what to do with: ${unknown}.")
  endif()
  if(arg_KEYWORDS_MISSING_VALUES)
    list(JOIN arg_KEYWORDS_MISSING_VALUES " and " missing)
    message(FATAL_ERROR "${call} is given nothing after ${missing}; leave the word out, or say what it stands for.")
  endif()
endmacro()
