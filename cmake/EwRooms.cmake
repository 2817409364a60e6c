# ew_check_rooms(LIBRARY [FOLDERS]): a library of many sources has folders by subject under src/, its rooms. They have an order, from the
# bottom to the top, and a room includes nothing of those above it; so there are no circles either. What others may include, include/ew/,
# counts for the room that has its source.

# The rooms of each library that has them, from the bottom to the top; whoever adds a folder says here where it stands.
set(EW_ROOMS_io files volumes surfaces dicom sweeps images films)
set(EW_ROOMS_phantom shapes patient echoes scanner)
set(EW_ROOMS_library files case making learning index access publishing)
set(EW_ROOMS_assessment measures works attempts rating)
set(EW_ROOMS_ui window/layout jobs measure/words keys case scan scan/doppler scan/console scan/cine scan/zoom scan/source scan/cost annotate body measure/calipers
  measure/worksheets measure trackers/control trackers/wizard trackers start images plugins import
  window/frame window/features window)
set(EW_ROOMS_cli run commands bench/tools bench/images bench/volumes bench/teaching bench)

# No folder of sources holds more; the next file makes two rooms of one.
set(EW_LARGEST_ROOM 50)

# The room of each file name (without ending) of `library`: EW_ROOM_OF_<stem> in the caller, and EW_ROOM_FILES: every file, from src/.
macro(ew_read_rooms library)
  set(src ${CMAKE_SOURCE_DIR}/workstation/${library}/src)
  file(GLOB_RECURSE EW_ROOM_FILES RELATIVE ${src} CONFIGURE_DEPENDS ${src}/*.h ${src}/*.cpp)
  foreach(file ${EW_ROOM_FILES})
    get_filename_component(room ${file} DIRECTORY)
    get_filename_component(stem ${file} NAME_WE)
    if(NOT room IN_LIST EW_ROOMS_${library})
      message(FATAL_ERROR "workstation/${library}/src/${file}: '${room}' is no room of ${library}; say in cmake/EwRooms.cmake where it stands.")
    endif()
    set(EW_ROOM_OF_${stem} ${room})
    math(EXPR EW_COUNT_${room} "0${EW_COUNT_${room}} + 1")
    if(EW_COUNT_${room} GREATER EW_LARGEST_ROOM)
      message(FATAL_ERROR "workstation/${library}/src/${room} holds more than ${EW_LARGEST_ROOM} files; make two rooms of it.")
    endif()
  endforeach()
endmacro()

function(ew_check_rooms library)
  ew_read_rooms(${library})
  foreach(file ${EW_ROOM_FILES})
    get_filename_component(room ${file} DIRECTORY)
    list(FIND EW_ROOMS_${library} ${room} floor)
    file(STRINGS ${src}/${file} lines REGEX "^#include \"")
    foreach(line ${lines})
      if(line MATCHES "^#include \"ew/${library}/([a-z0-9_]+)\\.h\"")
        set(other "${EW_ROOM_OF_${CMAKE_MATCH_1}}")
      elseif(line MATCHES "^#include \"([a-z0-9_/]+)/[a-z0-9_]+\\.h\"")
        set(other ${CMAKE_MATCH_1})
      else()
        continue()
      endif()
      list(FIND EW_ROOMS_${library} "${other}" its)
      if(its GREATER floor)
        message(FATAL_ERROR "workstation/${library}/src/${file} includes something of '${other}', which stands above '${room}' "
          "(cmake/EwRooms.cmake); move one of the two, or what both need below them.")
      endif()
    endforeach()
  endforeach()
endfunction()

function(ew_check_all_rooms)
  foreach(library ${EW_LAYERS})
    if(DEFINED EW_ROOMS_${library})
      ew_check_rooms(${library})
    else()
      file(GLOB files ${CMAKE_SOURCE_DIR}/workstation/${library}/src/*.cpp ${CMAKE_SOURCE_DIR}/workstation/${library}/src/*.h)
      list(LENGTH files count)
      if(count GREATER EW_LARGEST_ROOM)
        message(FATAL_ERROR "workstation/${library}/src holds ${count} files, more than ${EW_LARGEST_ROOM}; give it rooms (cmake/EwRooms.cmake).")
      endif()
    endif()
  endforeach()
endfunction()
