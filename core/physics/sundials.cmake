# Target knittsim_sundials: the parts of SUNDIALS that are used. Debian and Ubuntu build SUNDIALS with MPI, whose header
# its own headers include though no MPI function is called here.
find_package(SUNDIALS 6 REQUIRED
  COMPONENTS arkode cvode kinsol nvecserial sunlinsolspgmr sunlinsolpcg sunnonlinsolfixedpoint)

add_library(knittsim_sundials INTERFACE)
target_link_libraries(knittsim_sundials INTERFACE SUNDIALS::arkode SUNDIALS::cvode SUNDIALS::kinsol
  SUNDIALS::nvecserial SUNDIALS::sunlinsolspgmr SUNDIALS::sunlinsolpcg SUNDIALS::sunnonlinsolfixedpoint)

find_file(KNITTSIM_SUNDIALS_CONFIG sundials/sundials_config.h)
set(needs_mpi "")
if(KNITTSIM_SUNDIALS_CONFIG)
  file(STRINGS ${KNITTSIM_SUNDIALS_CONFIG} needs_mpi REGEX "define SUNDIALS_MPI_ENABLED 1")
endif()
if(needs_mpi)
  set(multiarch "${CMAKE_LIBRARY_ARCHITECTURE}")
  find_path(KNITTSIM_MPI_INCLUDE mpi.h
    HINTS ENV MPI_HOME
    PATHS /usr/lib/${multiarch}/openmpi/include /usr/lib/${multiarch}/mpich/include /usr/include/${multiarch}/mpi
      /usr/include/${multiarch}/mpich /usr/lib/openmpi/include
    PATH_SUFFIXES include)
  if(NOT KNITTSIM_MPI_INCLUDE)
    message(FATAL_ERROR "SUNDIALS was built with MPI, but mpi.h was not found (package libopenmpi-dev)")
  endif()
  target_include_directories(knittsim_sundials SYSTEM INTERFACE ${KNITTSIM_MPI_INCLUDE})
endif()
