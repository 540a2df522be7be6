// SPDX-License-Identifier: Apache-2.0
// All of the CUDA code, compiled for the emulated GPU. In a namespace of its own (see CMakeLists.txt): its
// lanes are single threads, and mustn't be mixed up with the CPU's.
#include "tests/emulated_gpu/simulation.hpp"

#include "cuda/setup.cpp"         // NOLINT
#include "cuda/simulation_gpu.cu" // NOLINT

namespace emulated_gpu
{
namespace
{

using aneurysm::device::Extent;
using aneurysm::device::GpuExecutor;
using aneurysm::device::Index;
template <class T>
using Buffer = aneurysm::device::Buffer<T, GpuExecutor>;

template <class T>
Buffer<T> uploaded(GpuExecutor& gpu, const std::vector<T>& values)
{
    Buffer<T> buffer(gpu, static_cast<Index>(values.size()));
    gpu.upload(buffer.get(), values.data(), values.size());
    return buffer;
}
template <class T>
std::vector<T> downloaded(GpuExecutor& gpu, const Buffer<T>& buffer)
{
    std::vector<T> values(static_cast<std::size_t>(buffer.size()));
    gpu.download(values.data(), buffer.get(), values.size());
    return values;
}

struct ValueOf {
    const double* values;

    double operator()(Index i) const { return values[i]; }
};

} // namespace

double sum(const std::vector<double>& values, int actual, int block_size)
{
    GpuExecutor gpu(block_size);
    const Buffer<double> in = uploaded(gpu, values);
    const Buffer<Index> n = uploaded(gpu, std::vector<Index>{actual});
    Buffer<double> scratch(gpu, in.size() + 8);
    Buffer<double> out(gpu, 1);
    gpu.reduce(Extent{in.size(), n.get()}, ValueOf{in.get()}, scratch.get(), out.get());
    return downloaded(gpu, out)[0];
}
std::vector<int> scan(const std::vector<int>& values, int actual)
{
    GpuExecutor gpu(0);
    const Buffer<Index> in = uploaded(gpu, values);
    const Buffer<Index> n = uploaded(gpu, std::vector<Index>{actual});
    Buffer<Index> out(gpu, in.size() + 1);
    gpu.reserve_sort(in.size(), 2);
    gpu.scan(Extent{in.size(), n.get()}, in.get(), out.get());
    return downloaded(gpu, out);
}
Sorted sort(const std::vector<int>& keys, int end)
{
    GpuExecutor gpu(0);
    const Buffer<Index> in = uploaded(gpu, keys);
    Buffer<Index> sorted(gpu, in.size());
    Buffer<Index> order(gpu, in.size());
    Buffer<Index> starts(gpu, end + 1);
    gpu.reserve_sort(in.size(), end);
    gpu.sort(in.size(), in.get(), sorted.get(), order.get(), end);
    gpu.find_starts(in.size(), sorted.get(), starts.get(), end);
    return {downloaded(gpu, sorted), downloaded(gpu, order), downloaded(gpu, starts)};
}

std::unique_ptr<aneurysm::Simulation> simulate(const aneurysm::Scenario& scenario, const Options& options,
                                               const aneurysm::SimulationState& state)
{
    using aneurysm::device::Tuning;
    Tuning tuning;
    tuning.block_size = options.block_size;
    tuning.gradients =
        options.computes_gradients ? Tuning::Gradients::computed : Tuning::Gradients::automatic;
    return aneurysm::device::make_gpu_simulation(scenario, options.precision, tuning, state);
}

} // namespace emulated_gpu
