// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>

namespace aneurysm
{

/// Everything that goes wrong on purpose. One line: where it happened (file, JSON path, frame, particle),
/// what is wrong (with the value), and what to do or what is allowed.
class Error : public std::runtime_error
{
public:
    Error(const std::string& where, const std::string& fault, const std::string& advice)
        : std::runtime_error(where + ": " + fault + "; " + advice), where_(where), fault_(fault),
          advice_(advice)
    {
    }

    const std::string& where() const { return where_; }
    const std::string& fault() const { return fault_; }
    const std::string& advice() const { return advice_; }

private:
    std::string where_;
    std::string fault_;
    std::string advice_;
};

/// Bad input: nothing was computed and nothing was written.
class InputError : public Error
{
public:
    using Error::Error;
};

/// The simulation itself failed (NaN, blow-up): what was written before stays.
class SimulationError : public Error
{
public:
    using Error::Error;
};

} // namespace aneurysm
