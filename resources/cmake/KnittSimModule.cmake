# Settings and helpers shared by every folder of the build.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

add_library(knittsim_options INTERFACE)
# Contraction of a*b+c is off so that results do not depend on the instruction set.
target_compile_options(knittsim_options INTERFACE -Wall -Wextra -Wconversion -ffp-contract=off)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # GCC 12 warns wrongly about "text" + std::string (GCC bug 105651).
  target_compile_options(knittsim_options INTERFACE -Wno-restrict)
endif()
target_include_directories(knittsim_options INTERFACE ${CMAKE_SOURCE_DIR})
target_link_libraries(knittsim_options INTERFACE Threads::Threads)

function(knittsim_apply_switches target)
  if(KNITTSIM_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  if(KNITTSIM_SANITIZE)
    target_compile_options(${target} PRIVATE -fsanitize=${KNITTSIM_SANITIZE} -fno-omit-frame-pointer)
    target_link_options(${target} PUBLIC -fsanitize=${KNITTSIM_SANITIZE})
  endif()
endfunction()

# One static library for one folder: knittsim_module(machine SOURCES a.cpp DEPENDS knittsim_base)
function(knittsim_module name)
  cmake_parse_arguments(arg "" "" "SOURCES;DEPENDS;PRIVATE_DEPENDS" ${ARGN})
  add_library(knittsim_${name} STATIC ${arg_SOURCES})
  target_link_libraries(knittsim_${name} PUBLIC knittsim_options ${arg_DEPENDS} PRIVATE ${arg_PRIVATE_DEPENDS})
  knittsim_apply_switches(knittsim_${name})
endfunction()
