# SPDX-License-Identifier: Apache-2.0
# spack install aneurysm, in a Spack repository whose packages/aneurysm/ has this file.
# Not tried: Spack was not at hand. Until there is a release in an archive, give the sources: spack dev-build aneurysm@main
from spack.package import *


class Aneurysm(CMakePackage):
    """Growth and rupture of aneurysms in a branching artery by smoothed particle hydrodynamics: a reference
    implementation with verified equations, an optimized one of the same bits, and the comparison of both."""

    homepage = "https://doi.org/10.3390/math13152439"

    license("Apache-2.0")  # with GSL linked in, a built program as a whole is under the GPL, version 3 or later

    version("main", branch="main")

    variant("pictures", default=False, description="Pictures, videos and windows, with VTK")
    variant("cuda", default=False, description="The CUDA backend")
    variant("benchmark", default=False, description="The benchmark bench_frames")

    depends_on("c", type="build")
    depends_on("cxx", type="build")
    depends_on("cmake@3.25:", type="build")
    depends_on("ninja", type="build")
    depends_on("python@3.9:", type=("build", "run"))
    depends_on("py-matplotlib", type="run")
    depends_on("boost@1.74:")
    depends_on("boost+test", type="test")
    depends_on("cli11")
    depends_on("eigen@3.4:3")
    depends_on("gsl@2.7:")
    depends_on("hdf5+cxx")
    depends_on("intel-oneapi-tbb")
    depends_on("nlohmann-json@3.11:")
    depends_on("benchmark", when="+benchmark")
    depends_on("cuda", when="+cuda")
    depends_on("vtk@9.1: +opengl2", when="+pictures")
    depends_on("libx11", when="+pictures")

    generator("ninja")

    def cmake_args(self):
        # Spack's compiler wrapper adds -march of its target.
        return [
            self.define("ANEURYSM_MARCH", ""),
            self.define("ANEURYSM_TESTS", self.run_tests),
            self.define("ANEURYSM_CUDA", "ON" if self.spec.satisfies("+cuda") else "OFF"),
            self.define("CMAKE_DISABLE_FIND_PACKAGE_VTK", not self.spec.satisfies("+pictures")),
            self.define("CMAKE_DISABLE_FIND_PACKAGE_benchmark", not self.spec.satisfies("+benchmark")),
        ]
