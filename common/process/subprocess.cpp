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

std::string own_program(const std::string& name)
{
    return std::filesystem::read_symlink("/proc/self/exe").parent_path() / name;
}

void run_program(const std::vector<std::string>& words, const std::string& advice)
{
    std::vector<std::string> copies = words;
    std::vector<char*> arguments;
    for (std::string& word : copies) {
        arguments.push_back(word.data());
    }
    arguments.push_back(nullptr);
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

} // namespace aneurysm
