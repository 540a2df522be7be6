// SPDX-License-Identifier: Apache-2.0
#include "analytic/exact/waveform.hpp"

#include "analytic/exact/precise.hpp"

#include <algorithm>
#include <stdexcept>

namespace aneurysm::analytic
{

WaveformValue exact_waveform(Waveform waveform, double v_0, double T, double t)
{
    const Precise x = 2 * precise_pi() * t / T;
    const auto with = [&](const Precise& shape, const Precise& slope) {
        return WaveformValue{static_cast<double>(v_0 * shape), static_cast<double>(abs(v_0 * x * slope))};
    };
    switch (waveform) {
    case Waveform::sine:
        return with(sin(x), cos(x));
    case Waveform::rectified_sine:
        return with(sqrt(Precise(1 - cos(x) * cos(x))), cos(x));
    case Waveform::raised_sine: {
        const Precise c = cos(Precise(precise_pi() / 4 - x / 2));
        return with(c * c, cos(x) / 2);
    }
    case Waveform::constant:
        return with(1, 0);
    default:
        throw std::invalid_argument("exact_waveform: a table has no formula");
    }
}

double hat_sum(const std::vector<double>& time, const std::vector<double>& velocity, double T, double t)
{
    const std::size_t n = time.size();
    const Precise phase = t - floor(Precise(t) / T) * T;
    Precise sum = 0;
    for (std::size_t k = 0; k < n; ++k) {
        const Precise before = k > 0 ? Precise(time[k - 1]) : Precise(time[n - 1]) - T;
        const Precise after = k + 1 < n ? Precise(time[k + 1]) : Precise(time[0]) + T;
        for (const int cycle : {-1, 0, 1}) {
            const Precise s = phase + Precise(cycle) * T;
            const Precise rising = (s - before) / (time[k] - before);
            const Precise falling = (after - s) / (after - time[k]);
            sum += velocity[k] * std::max(Precise(0), std::min(rising, falling));
        }
    }
    return static_cast<double>(sum);
}

} // namespace aneurysm::analytic
