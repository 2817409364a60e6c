# ew_add_plugin(NAME LOGIC ... PANEL ... ENTRY ... [LINK ...] [PANEL_LINK ...] [DESCRIPTION text] [CAPABILITIES ...] [VERSION x.y.z]
#               [TRANSLATIONS NAME_de.ts ...]):
# one plugin, the same way inside EchoWeave's own tree and outside it after find_package(EchoWeave REQUIRED COMPONENTS sdk).
#   LOGIC  sources without Qt: the static library NAME_logic, which tests link on its own; LINK goes to it as well
#   PANEL  Qt widgets (moc runs over them); ew::widgets and Qt5::Widgets are linked when there are any
#   ENTRY  the source with the three exported functions of ew/sdk/plugin.h
#   TRANSLATIONS  its words in other languages, NAME_LANGUAGE.ts; what lrelease makes of them lies beside the manifest, and the window loads it
# The library lands in <build>/lib/plugins/NAME/ with its manifest plugin.json beside it and installs to lib/echoweave/plugins/NAME.
include_guard(GLOBAL)
include(${CMAKE_CURRENT_LIST_DIR}/EwKnownWords.cmake)

# What abi_number.h of the SDK says after `name`: it is read, not compiled.
function(ew_sdk_says name result)
  get_target_property(folders ew::sdk INTERFACE_INCLUDE_DIRECTORIES)
  foreach(folder ${folders})
    string(REGEX REPLACE "\\$<BUILD_INTERFACE:([^>]*)>" "\\1" folder "${folder}")
    if(EXISTS "${folder}/ew/sdk/abi_number.h")
      set(header "${folder}/ew/sdk/abi_number.h")
      break()
    endif()
  endforeach()
  if(NOT header)
    message(FATAL_ERROR "ew/sdk/abi_number.h was not found beside the target ew::sdk; the EchoWeave SDK is not complete.")
  endif()
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${header}")
  file(STRINGS "${header}" line REGEX "${name}[ =]+" LIMIT_COUNT 1)
  string(REGEX REPLACE ".*${name}[ =]+\"?([0-9.]*).*" "\\1" value "${line}")
  set(${result} "${value}" PARENT_SCOPE)
endfunction()

function(ew_add_plugin name)
  cmake_parse_arguments(arg "" "DESCRIPTION;VERSION;TITLE" "LOGIC;PANEL;ENTRY;LINK;PANEL_LINK;CAPABILITIES;APART;TRANSLATIONS" ${ARGN})
  ew_refuse_unknown_words("ew_add_plugin(${name})" LOGIC PANEL ENTRY LINK PANEL_LINK CAPABILITIES APART TRANSLATIONS)
  if(NOT arg_ENTRY)
    message(FATAL_ERROR "ew_add_plugin(${name}): name the source with the exported functions after ENTRY.")
  endif()
  if(NOT arg_VERSION)
    set(arg_VERSION ${PROJECT_VERSION})
  endif()
  if(NOT arg_VERSION)
    set(arg_VERSION 0.0.0)
  endif()
  if(NOT arg_TITLE)
    set(arg_TITLE ${name})
  endif()

  add_library(ew_plugin_${name} MODULE ${arg_ENTRY} ${arg_PANEL})
  target_link_libraries(ew_plugin_${name} PRIVATE ew::sdk ${arg_PANEL_LINK})
  if(arg_LOGIC)
    add_library(ew_${name}_logic STATIC ${arg_LOGIC})
    add_library(ew::${name}_logic ALIAS ew_${name}_logic)
    target_include_directories(ew_${name}_logic PUBLIC ${CMAKE_CURRENT_SOURCE_DIR})
    target_link_libraries(ew_${name}_logic PUBLIC ew::sdk ${arg_LINK})
    target_link_libraries(ew_plugin_${name} PRIVATE ew_${name}_logic)
  else()
    target_include_directories(ew_plugin_${name} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
    target_link_libraries(ew_plugin_${name} PRIVATE ${arg_LINK})
  endif()
  if(arg_PANEL)
    if(NOT TARGET ew::widgets)
      message(FATAL_ERROR "ew_add_plugin(${name}): a panel is built of ew::widgets, which is not configured.")
    endif()
    if(NOT TARGET Qt5::Widgets OR NOT TARGET Qt5::Svg)
      find_package(Qt5 5.15 REQUIRED COMPONENTS Widgets Svg)
    endif()
    ew_sdk_says(EW_ABI_QT qt)
    if(NOT "${Qt5Widgets_VERSION}" MATCHES "^${qt}\\.")
      message(FATAL_ERROR "ew_add_plugin(${name}): EchoWeave was built with Qt ${qt}, and Qt ${Qt5Widgets_VERSION} was found; widgets cross the door.")
    endif()
    set_target_properties(ew_plugin_${name} PROPERTIES AUTOMOC ON)
    target_link_libraries(ew_plugin_${name} PRIVATE ew::widgets Qt5::Widgets)
    target_compile_definitions(ew_plugin_${name} PRIVATE QT_NO_KEYWORDS)
  endif()
  foreach(target ew_plugin_${name} ew_${name}_logic)
    if(TARGET ${target})
      set_target_properties(${target} PROPERTIES CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON POSITION_INDEPENDENT_CODE ON)
      target_compile_features(${target} PUBLIC cxx_std_20)
      if(COMMAND ew_join_sources) # inside EchoWeave's own tree
        ew_join_sources(${target} APART ${arg_APART})
        if(arg_PANEL AND target STREQUAL "ew_plugin_${name}")
          ew_compile_quickly(${target})
          ew_precompile(${target} window)
        else()
          ew_precompile(${target} library)
        endif()
      endif()
      if(TARGET ew::warnings)
        target_link_libraries(${target} PRIVATE ew::warnings ew::sanitizers)
      endif()
    endif()
  endforeach()
  # Everything a plugin needs must be found when it is linked, and it stays loaded: what it registered with VTK or Qt lives on.
  # A sanitizer's own symbols come from the program, so there the first check has to rest.
  target_link_options(ew_plugin_${name} PRIVATE -Wl,-z,nodelete)
  if(NOT EW_SANITIZE)
    target_link_options(ew_plugin_${name} PRIVATE -Wl,-z,defs)
  endif()
  set(folder ${CMAKE_BINARY_DIR}/lib/plugins/${name})
  set_target_properties(ew_plugin_${name} PROPERTIES PREFIX "" OUTPUT_NAME ${name} LIBRARY_OUTPUT_DIRECTORY ${folder})

  ew_sdk_says(kAbi abi)
  set(capabilities "")
  foreach(capability ${arg_CAPABILITIES})
    list(APPEND capabilities "\"${capability}\"")
  endforeach()
  list(JOIN capabilities ", " capabilities)
  string(REPLACE "\"" "\\\"" description "${arg_DESCRIPTION}")
  file(CONFIGURE OUTPUT ${folder}/plugin.json @ONLY CONTENT [[{
  "name": "@name@",
  "title": "@arg_TITLE@",
  "version": "@arg_VERSION@",
  "abi": @abi@,
  "library": "@name@.so",
  "capabilities": [@capabilities@],
  "description": "@description@"
}
]])
  if(arg_TRANSLATIONS)
    find_package(Qt5LinguistTools 5.15 REQUIRED)
  endif()
  foreach(words ${arg_TRANSLATIONS})
    get_filename_component(stem ${words} NAME_WE)
    if(NOT stem MATCHES "^${name}_[a-zA-Z_]+$")
      message(FATAL_ERROR "ew_add_plugin(${name}): the translation ${words} must be called ${name}_LANGUAGE.ts, or no window finds it.")
    endif()
    add_custom_command(OUTPUT ${folder}/${stem}.qm DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${words}
      COMMAND Qt5::lrelease -silent ${CMAKE_CURRENT_SOURCE_DIR}/${words} -qm ${folder}/${stem}.qm)
    target_sources(ew_plugin_${name} PRIVATE ${folder}/${stem}.qm)
    install(FILES ${folder}/${stem}.qm DESTINATION lib/echoweave/plugins/${name} COMPONENT runtime)
  endforeach()
  install(TARGETS ew_plugin_${name} LIBRARY DESTINATION lib/echoweave/plugins/${name} COMPONENT runtime)
  install(FILES ${folder}/plugin.json DESTINATION lib/echoweave/plugins/${name} COMPONENT runtime)
endfunction()
