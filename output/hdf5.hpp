// SPDX-License-Identifier: Apache-2.0
// The little of HDF5 that we need: files in memory, arrays, attributes;
// every failure an Error with HDF5's reason.
#pragma once

#include <hdf5.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
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
    /// The same with HDF5's own reason.
    [[noreturn]] void fail(const std::string& name) const;
};

/// An HDF5 identifier and how to close it.
class Handle
{
public:
    using Close = herr_t (*)(hid_t);

    /// Fails for `task` when `id` says that the call which made it did.
    Handle(hid_t id, Close close, const Task& task, const std::string& name);
    ~Handle();
    Handle(Handle&& other) noexcept;
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    Handle& operator=(Handle&&) = delete;

    hid_t id() const { return id_; }

private:
    hid_t id_;
    Close close_;
};

/// HDF5's name for a number type of ours, and the one that files hold: little-endian on every machine.
struct Type {
    hid_t memory;
    hid_t file;
};
Type type_of(double);
Type type_of(std::int64_t);
Type type_of(std::uint8_t);

/// A group of a file, the root included.
class Group
{
public:
    Group(Handle handle, Task task) : handle_(std::move(handle)), task_(std::move(task)) {}

    Group create_group(const std::string& name) const;
    Group open_group(const std::string& name) const;

    /// An array of rows of `columns` numbers (1: a plain array).
    template <class Number>
    void write(const std::string& name, std::span<const Number> values, std::size_t columns = 1) const
    {
        write_array(name, values.data(), values.size(), columns, type_of(Number{}));
    }
    void write(const std::string& name, const std::string& text) const;
    template <class Number>
    std::vector<Number> read(const std::string& name, std::size_t columns = 1) const
    {
        std::vector<Number> values(array_size(name, columns));
        read_array(name, values.data(), type_of(Number{}));
        return values;
    }
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
    bool has_attribute(const std::string& name) const { return H5Aexists(handle_.id(), name.c_str()) > 0; }
    template <class Number>
    Number read_attribute(const std::string& name) const
    {
        Number value{};
        read_attribute(name, &value, type_of(Number{}));
        return value;
    }
    std::string read_text_attribute(const std::string& name) const;

    const Task& task() const { return task_; }

private:
    void write_array(const std::string& name, const void* data, std::size_t count, std::size_t columns,
                     Type type) const;
    std::size_t array_size(const std::string& name, std::size_t columns) const;
    void read_array(const std::string& name, void* data, Type type) const;
    void write_attribute(const std::string& name, const void* data, std::size_t count, Type type) const;
    void read_attribute(const std::string& name, void* data, Type type) const;

    Handle handle_;
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
    File(std::span<const std::byte> image, const std::string& where);

    Group root() const;
    std::vector<std::byte> image() const;

private:
    Task task_;
    Handle handle_;
    std::size_t user_block_ = 0;
};

} // namespace aneurysm::output::hdf5
