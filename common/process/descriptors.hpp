// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

namespace aneurysm
{

/// A file descriptor that is closed at the end.
class Descriptor
{
public:
    explicit Descriptor(int number = none) : number_(number) {}
    ~Descriptor() { close(); }
    Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, none)) {}
    Descriptor& operator=(Descriptor&& other) noexcept
    {
        std::swap(number_, other.number_);
        return *this;
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    int number() const { return number_; }
    bool is_open() const { return number_ >= 0; }
    /// \return whether the system closed it; errno says why not
    bool close();

private:
    static constexpr int none = -1;
    int number_;
};

/// Gives standard input, output and error a place when the program was started with them closed; else the next file
/// that is opened gets their number, and with it what belongs there. What is written to them then still fails.
/// Before any file is opened.
void fill_standard_descriptors();

} // namespace aneurysm
