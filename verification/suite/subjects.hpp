// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "verification/suite/check.hpp"

#include <string>
#include <vector>

namespace aneurysm::suite
{

/// A subject, where it computes, and why it can't where it can't.
struct SuiteSubject {
    Subject subject;
    std::string device;  ///< in words
    std::string missing; ///< why this build or machine lacks it; empty: it is there
};

/// What checks of Scope::once are given: the reference.
const Subject& once();

/// The reference, and cpu and cuda in both precisions; a cuda that is missing says so.
/// \param backends    only these; one that is missing is bad input then. Empty: all
/// \param precisions  of cpu and cuda; empty: double and float
/// \throws InputError
std::vector<SuiteSubject> make_subjects(const std::vector<Backend>& backends = {},
                                        const std::vector<Precision>& precisions = {});

} // namespace aneurysm::suite
