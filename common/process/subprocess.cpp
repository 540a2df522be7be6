// SPDX-License-Identifier: Apache-2.0
#include "common/process/subprocess.hpp"

#include "common/error.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace aneurysm
{
namespace
{

/// As the system's calls want it: with a null behind the last.
std::vector<char*> pointers_to(std::vector<std::string>& words)
{
    std::vector<char*> pointers;
    for (std::string& word : words) {
        pointers.push_back(word.data());
    }
    pointers.push_back(nullptr);
    return pointers;
}

} // namespace

std::filesystem::path program_folder()
{
    std::error_code no_proc;
    return std::filesystem::read_symlink("/proc/self/exe", no_proc).parent_path();
}

std::string own_program(const std::string& name)
{
    return program_folder() / name;
}

void run_program(const std::vector<std::string>& words, const std::string& advice)
{
    std::vector<std::string> copies = words;
    std::vector<char*> arguments = pointers_to(copies);
    pid_t child = 0;
    const int refused = posix_spawnp(&child, arguments.front(), nullptr, nullptr, arguments.data(), environ);
    if (refused != 0) {
        throw Error(words.front(), std::string("can't be started (") + std::strerror(refused) + ")", advice);
    }
    int status = 0;
    while (waitpid(child, &status, 0) < 0) {
        if (errno != EINTR) {
            throw Error(words.front(), std::string("got lost (") + std::strerror(errno) + ")", advice);
        }
    }
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
        const std::string how = WIFEXITED(status) ? "exit code " + std::to_string(WEXITSTATUS(status))
                                                  : "signal " + std::to_string(WTERMSIG(status));
        throw Error(words.front(), "failed (" + how + ")", advice);
    }
}

void become_program(const std::string& name, const std::vector<std::string>& arguments,
                    const std::string& asked_by, const std::string& needed)
{
    std::vector<std::string> words{own_program(name)};
    words.insert(words.end(), arguments.begin(), arguments.end());
    execv(words.front().c_str(), pointers_to(words).data());
    throw InputError(asked_by, words.front() + " can't be started (" + std::strerror(errno) + ")",
                     "needed: the program of that name beside this one; " + needed);
}

} // namespace aneurysm
