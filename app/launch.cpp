// SPDX-License-Identifier: Apache-2.0
#include "app/launch.hpp"

#include "common/error.hpp"
#include "common/process/subprocess.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace aneurysm::app
{

void launch(const std::string& program, const std::vector<std::string>& arguments,
            const std::string& asked_by, const std::string& needed)
{
    std::vector<std::string> words{own_program(program)};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& word : words) {
        pointers.push_back(word.data());
    }
    pointers.push_back(nullptr);
    execv(words[0].c_str(), pointers.data());
    throw InputError(asked_by, words[0] + " can't be started (" + std::strerror(errno) + ")",
                     "needed: the program of that name beside this one; " + needed);
}

} // namespace aneurysm::app
