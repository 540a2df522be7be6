# SPDX-License-Identifier: Apache-2.0
# The target `docs`: the documentation site, in docs/html/index.html of the build. Warnings, such as of a public
# declaration of reference/ without a comment, are errors.
find_package(Doxygen QUIET)
if(NOT DOXYGEN_FOUND)
  message(STATUS "Left out: the documentation site, without Doxygen (doxygen)")
  return()
endif()
find_package(Python3 REQUIRED COMPONENTS Interpreter)
set(site ${PROJECT_BINARY_DIR}/docs)
configure_file(docs/site/Doxyfile.in ${site}/Doxyfile @ONLY)
add_custom_target(docs
  COMMAND ${CMAKE_COMMAND} -E rm -rf ${site}/pages ${site}/html
  COMMAND aneurysm info > ${site}/equations.txt
  COMMAND ${Python3_EXECUTABLE} -B ${PROJECT_SOURCE_DIR}/docs/site/pages.py ${PROJECT_SOURCE_DIR} ${site}/equations.txt ${site}/pages
  COMMAND ${DOXYGEN_EXECUTABLE} ${site}/Doxyfile
  COMMENT "Documentation site: ${site}/html/index.html" VERBATIM)
