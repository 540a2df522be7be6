# SPDX-License-Identifier: Apache-2.0
# A program that needs nothing but the C library of the machine that it is carried to, not older than this one's.
# HDF5's own list of libraries is for its network driver, which no program here uses.
set(static_libraries)
foreach(name sz aec z)
  find_library(ANEURYSM_LIB${name} lib${name}.a REQUIRED)
  list(APPEND static_libraries ${ANEURYSM_LIB${name}})
endforeach()
find_library(ANEURYSM_LIBGSL libgsl.a REQUIRED)
find_library(ANEURYSM_LIBGSLCBLAS libgslcblas.a REQUIRED)
set_target_properties(GSL::gsl PROPERTIES IMPORTED_LOCATION ${ANEURYSM_LIBGSL} IMPORTED_LOCATION_RELEASE ${ANEURYSM_LIBGSL})
set_target_properties(GSL::gslcblas PROPERTIES IMPORTED_LOCATION ${ANEURYSM_LIBGSLCBLAS}
                      IMPORTED_LOCATION_RELEASE ${ANEURYSM_LIBGSLCBLAS})
set_property(TARGET hdf5::hdf5 PROPERTY INTERFACE_LINK_LIBRARIES ${static_libraries} m ${CMAKE_DL_LIBS})
target_link_options(aneurysm PRIVATE -static-libstdc++ -static-libgcc)
# Debian has Google Benchmark only as a shared library, which needs the C++ library's; it goes with its program.
get_target_property(library benchmark::benchmark IMPORTED_LOCATION_NONE)
get_target_property(name benchmark::benchmark IMPORTED_SONAME_NONE)
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
file(COPY_FILE ${library} ${PROJECT_BINARY_DIR}/bin/${name})
set_property(TARGET bench_frames PROPERTY BUILD_RPATH "$ORIGIN")
