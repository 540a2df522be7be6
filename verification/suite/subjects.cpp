// SPDX-License-Identifier: Apache-2.0
#include "verification/suite/subjects.hpp"

#include "common/error.hpp"
#include "cuda/simulation.hpp"
#include "verification/bounds/inexact.hpp"

#include <algorithm>

namespace aneurysm::suite
{
namespace
{

template <class Value>
bool wants(const std::vector<Value>& chosen, Value value)
{
    return chosen.empty() || std::ranges::find(chosen, value) != chosen.end();
}

/// The equations of both precisions are the same functions of double, so the first subject stands for all.
SuiteSubject optimized(Backend backend, Precision precision)
{
    SuiteSubject s{
        {{backend, precision, 1, 0}, nullptr, bounds::unit_roundoff(precision)}, "one CPU core", ""};
    if (backend == Backend::cuda) {
        try {
            s.device = device::gpu_device();
        } catch (const Error& error) {
            s.device = "";
            s.missing = error.what();
        }
    }
    return s;
}

} // namespace

const Subject& once()
{
    static const Subject subject{backends::BackendChoice{}, &backends::reference_equations()};
    return subject;
}

std::vector<SuiteSubject> make_subjects(const std::vector<Backend>& backends,
                                        const std::vector<Precision>& precisions)
{
    std::vector<SuiteSubject> subjects;
    if (wants(backends, Backend::reference)) {
        subjects.push_back({once(), "one CPU core", ""});
    }
    bool has_equations = false;
    for (const Backend backend : {Backend::cpu, Backend::cuda}) {
        for (const Precision precision : {Precision::double_, Precision::float_}) {
            if (!wants(backends, backend) || !wants(precisions, precision)) {
                continue;
            }
            SuiteSubject s = optimized(backend, precision);
            if (!s.missing.empty() && !backends.empty()) {
                throw InputError("--backend cuda", "isn't here (" + s.missing + ")",
                                 "needed: another, or none for all that are");
            }
            if (!has_equations && s.missing.empty()) {
                s.subject.equations = &backends::device_equations();
                has_equations = true;
            }
            subjects.push_back(std::move(s));
        }
    }
    if (subjects.size() == 1 && subjects.front().subject.choice.backend == Backend::reference &&
        !wants(precisions, Precision::double_)) {
        throw InputError("--precision", "the reference has no other than double (float)", "allowed: double");
    }
    return subjects;
}

} // namespace aneurysm::suite
