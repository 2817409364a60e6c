# cmake -DBINARY=… -DFOLDER=… -DGENERATOR=… -DCXX=… -DSANITIZE=… -DPLUGIN=… -P build_outside.cmake: installs the SDK of the build tree
# BINARY into FOLDER/sdk and builds the plugin in the folder PLUGIN against it, as its author would. FOLDER is made anew.
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE ${FOLDER})
foreach(command "--install;${BINARY};--component;sdk;--prefix;${FOLDER}/sdk"
    "-S;${PLUGIN};-B;${FOLDER}/build;-G;${GENERATOR};-DCMAKE_CXX_COMPILER=${CXX};-DCMAKE_PREFIX_PATH=${FOLDER}/sdk;-DEW_SANITIZE=${SANITIZE}"
    "--build;${FOLDER}/build")
  execute_process(COMMAND ${CMAKE_COMMAND} ${command} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
