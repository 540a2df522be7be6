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

using Names = std::vector<std::string>;

bool contains(const Names& names, const std::string& name)
{
    return std::ranges::find(names, name) != names.end();
}

void check(const Names& backends, const Names& precisions)
{
    for (const std::string& name : backends) {
        if (!contains({"reference", "cpu", "cuda"}, name)) {
            throw InputError("--backend", "unknown (" + name + ")", "allowed: reference, cpu, cuda");
        }
    }
    for (const std::string& name : precisions) {
        bounds::unit_roundoff(name);
    }
    const bool only_reference = !backends.empty() && std::ranges::all_of(backends, [](const auto& name) {
        return name == "reference";
    });
    if (only_reference && !precisions.empty() && !contains(precisions, "double")) {
        throw InputError("--precision", "the reference has no other than double (" + precisions[0] + ")",
                         "allowed: double");
    }
}

/// The equations of both precisions are the same functions of double, so the first subject stands for all.
SuiteSubject optimized(const std::string& backend, const std::string& precision)
{
    SuiteSubject s{
        {{backend, precision, 1, 0}, nullptr, bounds::unit_roundoff(precision)}, "one CPU core", ""};
    if (backend == "cuda") {
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

std::vector<SuiteSubject> make_subjects(const Names& backends, const Names& precisions)
{
    check(backends, precisions);
    const auto wanted = [&](const char* name) { return backends.empty() || contains(backends, name); };
    std::vector<SuiteSubject> subjects;
    if (wanted("reference")) {
        subjects.push_back({once(), "one CPU core", ""});
    }
    bool has_equations = false;
    for (const char* backend : {"cpu", "cuda"}) {
        for (const char* precision : {"double", "float"}) {
            if (!wanted(backend) || (!precisions.empty() && !contains(precisions, precision))) {
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
    return subjects;
}

} // namespace aneurysm::suite
