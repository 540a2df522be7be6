# SPDX-License-Identifier: Apache-2.0
# Programs that need nothing but their folder and the C library of the machine that they are carried to, not older
# than this one's.
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
# What there is only as a shared library goes with the programs.
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
function(aneurysm_carry library name)
  file(REAL_PATH ${library} file)
  file(COPY_FILE ${file} ${PROJECT_BINARY_DIR}/bin/${name})
endfunction()
find_package(benchmark REQUIRED)
foreach(target benchmark::benchmark TBB::tbb)
  get_target_property(library ${target} IMPORTED_LOCATION_NONE)
  get_target_property(name ${target} IMPORTED_SONAME_NONE)
  aneurysm_carry(${library} ${name})
endforeach()
foreach(name libstdc++.so.6 libgcc_s.so.1)
  execute_process(COMMAND ${CMAKE_CXX_COMPILER} -print-file-name=${name} OUTPUT_VARIABLE library OUTPUT_STRIP_TRAILING_WHITESPACE)
  aneurysm_carry(${library} ${name})
endforeach()
set_property(TARGET aneurysm aneurysm-sensitivity bench_frames PROPERTY BUILD_RPATH "$ORIGIN")
