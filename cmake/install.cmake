# SPDX-License-Identifier: Apache-2.0
# What `cmake --install` puts where, in three components: programs, pictures (needs VTK), development; and packages of them.
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME programs)
set(share ${CMAKE_INSTALL_DATADIR}/aneurysm) # common/CMakeLists.txt tells the programs

install(TARGETS aneurysm)
foreach(target aneurysm-sensitivity bench_frames) # where they were built
  if(TARGET ${target})
    install(TARGETS ${target} OPTIONAL)
  endif()
endforeach()
if(TARGET aneurysm-pictures)
  install(TARGETS aneurysm-pictures COMPONENT pictures OPTIONAL)
endif()
install(DIRECTORY data DESTINATION ${share} PATTERN pictures EXCLUDE)
install(FILES output/plot_run.py DESTINATION ${share}/output)
install(FILES verification/reproduction/plot.py DESTINATION ${share}/verification/reproduction)
install(FILES README.md CHANGELOG.md CITATION.cff NOTICE DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright)
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR})

# Man pages are the programs' own --help.
find_program(ANEURYSM_HELP2MAN help2man)
if(ANEURYSM_HELP2MAN AND aneurysm_makes_files)
  set(pages)
  foreach(command "" run compare verify reproduce info)
    string(STRIP "aneurysm ${command}" words)
    string(REPLACE " " "-" page ${words}.1)
    add_custom_command(OUTPUT ${page} VERBATIM DEPENDS aneurysm
      WORKING_DIRECTORY $<TARGET_FILE_DIR:aneurysm> # whose name help2man would give to a shell
      COMMAND ${ANEURYSM_HELP2MAN} --no-info --version-string=${PROJECT_VERSION} "--name=simulation of aneurysms by SPH"
              --output=${CMAKE_CURRENT_BINARY_DIR}/${page} "./aneurysm ${command}")
    list(APPEND pages ${CMAKE_CURRENT_BINARY_DIR}/${page})
  endforeach()
  add_custom_target(aneurysm_man ALL DEPENDS ${pages})
  add_dependencies(aneurysm_programs aneurysm_man)
  install(FILES ${pages} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 OPTIONAL)
endif()

# find_package(aneurysm): aneurysm::common, ::reference, ::cuda (with the CPU executor), ::analytic.
set_target_properties(aneurysm_device PROPERTIES EXPORT_NAME cuda)
foreach(name numerics common reference analytic)
  set_target_properties(aneurysm_${name} PROPERTIES EXPORT_NAME ${name})
endforeach()
install(TARGETS aneurysm_numerics aneurysm_common aneurysm_reference aneurysm_device aneurysm_analytic EXPORT aneurysm
        ARCHIVE COMPONENT development)
install(DIRECTORY common reference cuda analytic DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/aneurysm COMPONENT development
        FILES_MATCHING PATTERN "*.hpp")
include(CMakePackageConfigHelpers)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/aneurysm)
install(EXPORT aneurysm NAMESPACE aneurysm:: FILE aneurysm-targets.cmake DESTINATION ${package_folder} COMPONENT development)
set(aneurysm_with_cuda OFF)
if(TARGET aneurysm_gpu)
  set(aneurysm_with_cuda ON) # cuda links the CUDA runtime
endif()
configure_package_config_file(cmake/aneurysm-config.cmake.in aneurysm-config.cmake INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(aneurysm-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/aneurysm-config.cmake ${CMAKE_CURRENT_BINARY_DIR}/aneurysm-config-version.cmake
        DESTINATION ${package_folder} COMPONENT development)

# `cpack --preset package`: a .deb of each component. Debian's dpkg-shlibdeps finds what they depend on.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "the authors of aneurysm, see CITATION.cff")
set(CPACK_PACKAGE_NAME aneurysm)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL programs development)
if(TARGET aneurysm-pictures)
  list(APPEND CPACK_COMPONENTS_ALL pictures)
endif()
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_NAME aneurysm)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SUGGESTS "aneurysm-pictures, python3-matplotlib, python3-h5py")
set(CPACK_DEBIAN_PICTURES_PACKAGE_NAME aneurysm-pictures)
set(CPACK_DEBIAN_PICTURES_PACKAGE_DEPENDS "aneurysm (= ${PROJECT_VERSION}), xvfb, libgl1-mesa-dri")
set(CPACK_DEBIAN_PICTURES_PACKAGE_SUGGESTS ffmpeg)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME aneurysm-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libeigen3-dev, libgsl-dev, libtbb-dev")
set(CPACK_COMPONENT_PROGRAMS_DESCRIPTION "growth and rupture of aneurysms by smoothed particle hydrodynamics
 Simulates how an aneurysm in a branching artery grows, thins and ruptures, and verifies itself.")
set(CPACK_COMPONENT_PICTURES_DESCRIPTION "pictures, videos and windows of aneurysm's runs")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "libraries and headers of aneurysm, for CMake's find_package")
include(CPack)
