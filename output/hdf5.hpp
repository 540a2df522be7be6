// SPDX-License-Identifier: Apache-2.0
// The little of HDF5 that we need: files in memory, arrays, attributes;
// every failure an Error with HDF5's reason.
#pragma once

#include "common/particles.hpp"

#include <H5Cpp.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace aneurysm::output::hdf5
{

/// Who fails, for messages: reading ends in an InputError, writing in an Error.
struct Task {
    enum class Kind { read, write };
    Kind kind;
    std::string where; ///< the file

    /// \throws Error or InputError: "cannot read `name` (`reason`)"
    [[noreturn]] void fail(const std::string& name, const std::string& reason) const;
};

/// HDF5's name for a number type of ours, and the one that files hold: little-endian on every machine.
struct Type {
    const H5::PredType& memory;
    const H5::PredType& file;
};
Type type_of(double);
Type type_of(std::int64_t);
Type type_of(std::uint8_t);

/// A group of a file, the root included.
class Group
{
public:
    Group(H5::Group group, Task task) : group_(std::move(group)), task_(std::move(task)) {}

    Group create_group(const std::string& name) const;
    Group open_group(const std::string& name) const;

    /// An array of rows of `columns` numbers (1: a plain array).
    template <class Number>
    void write(const std::string& name, const std::vector<Number>& values, std::size_t columns = 1) const
    {
        write_array(name, values.data(), values.size(), columns, type_of(Number{}));
    }
    void write(const std::string& name, const std::vector<Vec3>& vectors) const;
    void write(const std::string& name, const std::vector<Kind>& kinds) const;
    void write(const std::string& name, const std::string& text) const;
    template <class Number>
    std::vector<Number> read(const std::string& name, std::size_t columns = 1) const
    {
        std::vector<Number> values(array_size(name, columns));
        read_array(name, values.data(), type_of(Number{}));
        return values;
    }
    std::vector<Vec3> read_vectors(const std::string& name) const;
    std::vector<Kind> read_kinds(const std::string& name) const;
    std::string read_text(const std::string& name) const;

    template <class Number>
    void write_attribute(const std::string& name, Number value) const
    {
        write_attribute(name, &value, 1, type_of(Number{}));
    }
    template <class Number, std::size_t n>
    void write_attribute(const std::string& name, const std::array<Number, n>& values) const
    {
        write_attribute(name, values.data(), n, type_of(Number{}));
    }
    void write_attribute(const std::string& name, const std::string& text) const;
    /// An attribute of an array of the group.
    void describe(const std::string& array, const std::string& name, const std::string& text) const;
    template <class Number>
    Number read_attribute(const std::string& name) const
    {
        Number value{};
        read_attribute(name, &value, type_of(Number{}));
        return value;
    }
    std::string read_text_attribute(const std::string& name) const;
    /// What describe() wrote.
    std::string description(const std::string& array, const std::string& name) const;

    const Task& task() const { return task_; }

private:
    void write_array(const std::string& name, const void* data, std::size_t count, std::size_t columns,
                     Type type) const;
    std::size_t array_size(const std::string& name, std::size_t columns) const;
    void read_array(const std::string& name, void* data, Type type) const;
    void write_attribute(const std::string& name, const void* data, std::size_t count, Type type) const;
    void read_attribute(const std::string& name, void* data, Type type) const;

    H5::Group group_;
    Task task_;
};

/// A file in memory: written to disk in one piece afterwards, or read from it before. So a full disk never
/// meets HDF5, and a half-written file never has its final name.
class File
{
public:
    /// Empty, to be filled. `where` names it in messages. The first `user_block` bytes of the image are the
    /// caller's (0, or a power of two from 512).
    explicit File(const std::string& where, std::size_t user_block = 0);
    /// From the bytes of a file.
    File(std::string_view image, const std::string& where);

    Group root() const;
    std::string image() const;

private:
    Task task_;
    H5::H5File file_;
    std::size_t user_block_ = 0;
};

} // namespace aneurysm::output::hdf5
