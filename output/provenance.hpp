// SPDX-License-Identifier: Apache-2.0
// What every record that we write says of its origin.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace aneurysm::output
{

/// Program, version, commit, compiler, flags.
nlohmann::ordered_json provenance();

/// Where and how this process runs: host, batch job, command line, threads that pay, versions of the libraries, GPU driver.
nlohmann::ordered_json surroundings();

/// Name of this machine in its network.
std::string host();

/// Now, as in 2025-07-24T13:05:00Z.
std::string now_utc();

/// Processor, its threads and the operating system, in words.
std::string machine();

} // namespace aneurysm::output
