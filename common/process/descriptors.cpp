// SPDX-License-Identifier: Apache-2.0
#include "common/process/descriptors.hpp"

#include <cerrno>
#include <fcntl.h>
#include <initializer_list>
#include <unistd.h>

namespace aneurysm
{

bool Descriptor::close()
{
    return !is_open() || ::close(std::exchange(number_, none)) == 0;
}

void fill_standard_descriptors()
{
    for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (::fcntl(descriptor, F_GETFD) < 0 && errno == EBADF) {
            // The lowest free number, which is this one. Of the wrong kind: reading and writing fail as before.
            static_cast<void>(::open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY));
        }
    }
}

} // namespace aneurysm
