# SPDX-License-Identifier: Apache-2.0
# Sets aneurysm_with_cuda where there is an nvcc that works, and says when there is none. The machine code is for data
# center GPUs (A100, H100, H200) and the smaller ones of their families; newer GPUs compile the PTX.
if(NOT CMAKE_CUDA_COMPILER)
  find_program(ANEURYSM_NVCC nvcc HINTS ENV CUDA_PATH ENV CUDA_HOME PATHS /usr/local/cuda PATH_SUFFIXES bin)
  if(ANEURYSM_NVCC)
    set(ENV{CUDACXX} ${ANEURYSM_NVCC}) # where check_language looks
  endif()
endif()
if(NOT CMAKE_CUDA_ARCHITECTURES)
  set(CMAKE_CUDA_ARCHITECTURES 80-real 90-real 90-virtual)
endif()
if(NOT CMAKE_CUDA_HOST_COMPILER AND NOT DEFINED ENV{CUDAHOSTCXX})
  set(CMAKE_CUDA_HOST_COMPILER ${CMAKE_CXX_COMPILER})
endif()
set(CMAKE_CUDA_RUNTIME_LIBRARY Static)
include(CheckLanguage)
check_language(CUDA)
if(CMAKE_CUDA_COMPILER)
  set(aneurysm_with_cuda ON)
else()
  unset(CMAKE_CUDA_COMPILER CACHE) # look again next time
  set(nvcc_missing "without an nvcc that works (set CUDA_PATH, or -DANEURYSM_CUDA=OFF)")
  if(ANEURYSM_CUDA STREQUAL "ON")
    message(FATAL_ERROR "ANEURYSM_CUDA=ON ${nvcc_missing}")
  endif()
  message(STATUS "Left out: --backend cuda, ${nvcc_missing}")
endif()
