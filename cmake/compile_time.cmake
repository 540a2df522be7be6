# SPDX-License-Identifier: Apache-2.0
# How the project compiles in half the time. Neither means changes a bit of any result.
#
# aneurysm_precompile(target): the headers of the standard library that nearly all sources include are parsed once. Only
# with g++, and not under the sanitizers, whose build would notice an include that is missing.
# aneurysm_light(target [headers]): a room that computes few numbers is optimized little, too; its headers are those of the
# target aneurysm_headers_light, or another's.
set(headers <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <limits> <map> <memory> <numbers> <optional>
            <span> <sstream> <string> <string_view> <utility> <vector>)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND NOT ANEURYSM_SANITIZE)
  set(aneurysm_precompiles ON)
else()
  set(aneurysm_precompiles OFF)
endif()

file(WRITE ${PROJECT_BINARY_DIR}/headers.cpp "") # the precompiled headers belong to a source
add_library(aneurysm_headers OBJECT ${PROJECT_BINARY_DIR}/headers.cpp)
target_link_libraries(aneurysm_headers PRIVATE aneurysm_numerics)
add_library(aneurysm_headers_light OBJECT ${PROJECT_BINARY_DIR}/headers.cpp)
target_link_libraries(aneurysm_headers_light PRIVATE aneurysm_numerics)
target_compile_options(aneurysm_headers_light PRIVATE $<$<CONFIG:Release>:-O1>)
if(ANEURYSM_TESTS)
  add_library(aneurysm_headers_test OBJECT ${PROJECT_BINARY_DIR}/headers.cpp)
  target_link_libraries(aneurysm_headers_test PRIVATE aneurysm_numerics Boost::unit_test_framework)
  target_compile_definitions(aneurysm_headers_test PRIVATE BOOST_TEST_DYN_LINK)
  target_compile_options(aneurysm_headers_test PRIVATE $<$<CONFIG:Release>:-O1>)
endif()
if(aneurysm_precompiles)
  target_precompile_headers(aneurysm_headers PRIVATE ${headers})
  target_precompile_headers(aneurysm_headers_light PRIVATE ${headers} <nlohmann/json.hpp>)
  if(ANEURYSM_TESTS)
    target_precompile_headers(aneurysm_headers_test PRIVATE ${headers} <boost/test/unit_test.hpp>)
  endif()
endif()

function(aneurysm_precompile target)
  if(aneurysm_precompiles)
    target_precompile_headers(${target} REUSE_FROM aneurysm_headers)
  endif()
endfunction()

set(light_options $<$<CONFIG:Release>:-O1>)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  list(APPEND light_options -Wno-array-bounds -Wno-stringop-overflow) # with -O1 it sees them in std::string + "a"
endif()
function(aneurysm_light target)
  target_compile_options(${target} PRIVATE ${light_options})
  set(headers aneurysm_headers_light ${ARGN})
  list(GET headers -1 headers)
  if(aneurysm_precompiles)
    target_precompile_headers(${target} REUSE_FROM ${headers})
  endif()
endfunction()
