# SPDX-License-Identifier: Apache-2.0
# Programs that need nothing but the C library of the machine that they are carried to, not older than this one's.
# HDF5's own list of libraries is for its network driver, which no program here uses.
set(static_libraries)
foreach(name sz aec z)
  find_library(ANEURYSM_LIB${name} lib${name}.a REQUIRED)
  list(APPEND static_libraries ${ANEURYSM_LIB${name}})
endforeach()
set_property(TARGET hdf5::hdf5 PROPERTY INTERFACE_LINK_LIBRARIES ${static_libraries} m ${CMAKE_DL_LIBS})
foreach(program aneurysm bench_reference bench_frames)
  if(TARGET ${program})
    target_link_options(${program} PRIVATE -static-libstdc++ -static-libgcc)
  endif()
endforeach()
