// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace aneurysm::comparison
{

/// How many standard deviations a further member of a normal sample of `members` is at most away from their
/// mean, but for the probability `alpha` (two-sided): t_{members-1, 1-alpha/2} sqrt(1 + 1/members).
/// At least 2 members.
double prediction_factor(int members, double alpha);

} // namespace aneurysm::comparison
