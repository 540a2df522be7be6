// SPDX-License-Identifier: Apache-2.0
#include "output/hdf5.hpp"

#include "common/error.hpp"

#include <algorithm>
#include <atomic>
#include <utility>

namespace aneurysm::output::hdf5
{
namespace
{

/// The innermost message on HDF5's error stack.
std::string library_reason()
{
    std::string text;
    const auto take_first = [](unsigned, const H5E_error2_t* error, void* to) -> herr_t {
        auto& first = *static_cast<std::string*>(to);
        if (first.empty() && error->desc != nullptr) {
            first = error->desc;
        }
        return 0;
    };
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, take_first, &text);
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text.empty() ? "HDF5 gives no reason" : text;
}

/// HDF5 prints its errors to the terminal unless told not to.
void silence()
{
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Handle property_list(hid_t kind, const Task& task)
{
    silence();
    return {H5Pcreate(kind), H5Pclose, task, "a property list"};
}

Handle in_memory(const Task& task)
{
    constexpr std::size_t increment = std::size_t{1} << 20U;
    Handle access = property_list(H5P_FILE_ACCESS, task);
    if (H5Pset_fapl_core(access.id(), increment, static_cast<hbool_t>(false)) < 0) {
        task.fail("a file in memory");
    }
    return access;
}

/// HDF5 takes two files of one name for the same file.
std::string new_name()
{
    static std::atomic<int> count = 0;
    return "in memory " + std::to_string(++count);
}

Handle create_image(std::size_t user_block, const Task& task)
{
    const Handle access = in_memory(task);
    const Handle creation = property_list(H5P_FILE_CREATE, task);
    if (H5Pset_userblock(creation.id(), user_block) < 0) {
        task.fail("a user block");
    }
    return {H5Fcreate(new_name().c_str(), H5F_ACC_TRUNC, creation.id(), access.id()), H5Fclose, task,
            "the file"};
}

Handle open_image(std::span<const std::byte> image, const Task& task)
{
    const Handle access = in_memory(task);
    // HDF5 copies the bytes, although it asks for them without const.
    void* bytes = const_cast<std::byte*>(image.data()); // NOLINT(cppcoreguidelines-pro-type-const-cast)
    if (image.empty()) {
        task.fail("the file", "it is empty");
    }
    if (H5Pset_file_image(access.id(), bytes, image.size()) < 0) {
        task.fail("a file in memory");
    }
    return {H5Fopen(new_name().c_str(), H5F_ACC_RDONLY, access.id()), H5Fclose, task, "the file"};
}

Handle text_type(std::size_t size, const Task& task)
{
    Handle type{H5Tcopy(H5T_C_S1), H5Tclose, task, "a string type"};
    if (H5Tset_size(type.id(), std::max<std::size_t>(size, 1)) < 0) {
        task.fail("a string type");
    }
    return type;
}

/// Reads a string of fixed length through `read(type, buffer)`.
template <class Read>
std::string read_fixed_text(hid_t type, const Task& task, const std::string& name, Read read)
{
    if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) != 0) {
        task.fail(name, "not a string of fixed length");
    }
    std::string text(H5Tget_size(type), '\0');
    if (read(type, text.data()) < 0) {
        task.fail(name);
    }
    return text.substr(0, text.find('\0'));
}

} // namespace

void Task::fail(const std::string& name, const std::string& reason) const
{
    if (kind == Kind::read) {
        throw InputError(where, "cannot read " + name + " (" + reason + ")",
                         "needed: the file as it was written");
    }
    throw Error(where, "cannot write " + name + " (" + reason + ")", "needed: enough memory");
}

void Task::fail(const std::string& name) const
{
    fail(name, library_reason());
}

Handle::Handle(hid_t id, Close close, const Task& task, const std::string& name) : id_(id), close_(close)
{
    if (id < 0) {
        task.fail(name);
    }
}

Handle::~Handle()
{
    if (id_ >= 0) {
        close_(id_);
    }
}

Handle::Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}

Type type_of(double)
{
    return {H5T_NATIVE_DOUBLE, H5T_IEEE_F64LE};
}
Type type_of(std::int64_t)
{
    return {H5T_NATIVE_INT64, H5T_STD_I64LE};
}
Type type_of(std::uint8_t)
{
    return {H5T_NATIVE_UINT8, H5T_STD_U8LE};
}

Group Group::create_group(const std::string& name) const
{
    return {Handle(H5Gcreate2(handle_.id(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose,
                   task_, name),
            task_};
}

Group Group::open_group(const std::string& name) const
{
    return {Handle(H5Gopen2(handle_.id(), name.c_str(), H5P_DEFAULT), H5Gclose, task_, name), task_};
}

void Group::write_array(const std::string& name, const void* data, std::size_t count, std::size_t columns,
                        Type type) const
{
    const std::array<hsize_t, 2> extent{count / columns, columns};
    const Handle space{H5Screate_simple(columns == 1 ? 1 : 2, extent.data(), nullptr), H5Sclose, task_, name};
    const Handle properties = property_list(H5P_DATASET_CREATE, task_);
    H5Pset_obj_track_times(properties.id(), false); // the same state makes the same bytes
    const Handle set{H5Dcreate2(handle_.id(), name.c_str(), type.file, space.id(), H5P_DEFAULT,
                                properties.id(), H5P_DEFAULT),
                     H5Dclose, task_, name};
    if (count > 0 && H5Dwrite(set.id(), type.memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, data) < 0) {
        task_.fail(name);
    }
}

void Group::write(const std::string& name, const std::string& text) const
{
    const Handle type = text_type(text.size(), task_);
    const Handle space{H5Screate(H5S_SCALAR), H5Sclose, task_, name};
    const Handle properties = property_list(H5P_DATASET_CREATE, task_);
    H5Pset_obj_track_times(properties.id(), false);
    const Handle set{H5Dcreate2(handle_.id(), name.c_str(), type.id(), space.id(), H5P_DEFAULT,
                                properties.id(), H5P_DEFAULT),
                     H5Dclose, task_, name};
    if (H5Dwrite(set.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, text.c_str()) < 0) {
        task_.fail(name);
    }
}

std::size_t Group::array_size(const std::string& name, std::size_t columns) const
{
    const Handle set{H5Dopen2(handle_.id(), name.c_str(), H5P_DEFAULT), H5Dclose, task_, name};
    const Handle space{H5Dget_space(set.id()), H5Sclose, task_, name};
    std::array<hsize_t, 2> extent{0, 1};
    const int rank = H5Sget_simple_extent_ndims(space.id());
    if (rank != (columns == 1 ? 1 : 2) || H5Sget_simple_extent_dims(space.id(), extent.data(), nullptr) < 0 ||
        extent[1] != columns) {
        task_.fail(name, "not an array of " + std::to_string(columns) + " columns");
    }
    // What the file says must be there before memory is taken for it.
    if (H5Dget_storage_size(set.id()) < extent[0] * columns) {
        task_.fail(name, "less data than its extent");
    }
    return extent[0] * columns;
}

void Group::read_array(const std::string& name, void* data, Type type) const
{
    const Handle set{H5Dopen2(handle_.id(), name.c_str(), H5P_DEFAULT), H5Dclose, task_, name};
    const Handle stored{H5Dget_type(set.id()), H5Tclose, task_, name};
    if (H5Tequal(stored.id(), type.file) <= 0) {
        task_.fail(name, "another number type");
    }
    if (H5Dread(set.id(), type.memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, data) < 0) {
        task_.fail(name);
    }
}

std::string Group::read_text(const std::string& name) const
{
    const Handle set{H5Dopen2(handle_.id(), name.c_str(), H5P_DEFAULT), H5Dclose, task_, name};
    const Handle type{H5Dget_type(set.id()), H5Tclose, task_, name};
    return read_fixed_text(type.id(), task_, name, [&set](hid_t as, void* buffer) {
        return H5Dread(set.id(), as, H5S_ALL, H5S_ALL, H5P_DEFAULT, buffer);
    });
}

void Group::write_attribute(const std::string& name, const void* data, std::size_t count, Type type) const
{
    const hsize_t extent = count;
    const Handle space{count == 1 ? H5Screate(H5S_SCALAR) : H5Screate_simple(1, &extent, nullptr), H5Sclose,
                       task_, name};
    const Handle attribute{
        H5Acreate2(handle_.id(), name.c_str(), type.file, space.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
        task_, name};
    if (H5Awrite(attribute.id(), type.memory, data) < 0) {
        task_.fail(name);
    }
}

void Group::write_attribute(const std::string& name, const std::string& text) const
{
    const Handle type = text_type(text.size(), task_);
    const Handle space{H5Screate(H5S_SCALAR), H5Sclose, task_, name};
    const Handle attribute{
        H5Acreate2(handle_.id(), name.c_str(), type.id(), space.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
        task_, name};
    if (H5Awrite(attribute.id(), type.id(), text.c_str()) < 0) {
        task_.fail(name);
    }
}

void Group::read_attribute(const std::string& name, void* data, Type type) const
{
    const Handle attribute{H5Aopen(handle_.id(), name.c_str(), H5P_DEFAULT), H5Aclose, task_, name};
    const Handle space{H5Aget_space(attribute.id()), H5Sclose, task_, name};
    const Handle stored{H5Aget_type(attribute.id()), H5Tclose, task_, name};
    if (H5Sget_simple_extent_npoints(space.id()) != 1 || H5Tequal(stored.id(), type.file) <= 0) {
        task_.fail(name, "not one number of its type");
    }
    if (H5Aread(attribute.id(), type.memory, data) < 0) {
        task_.fail(name);
    }
}

std::string Group::read_text_attribute(const std::string& name) const
{
    const Handle attribute{H5Aopen(handle_.id(), name.c_str(), H5P_DEFAULT), H5Aclose, task_, name};
    const Handle type{H5Aget_type(attribute.id()), H5Tclose, task_, name};
    return read_fixed_text(type.id(), task_, name, [&attribute](hid_t as, void* buffer) {
        return H5Aread(attribute.id(), as, buffer);
    });
}

File::File(const std::string& where, std::size_t user_block)
    : task_{Task::Kind::write, where}, handle_(create_image(user_block, task_)), user_block_(user_block)
{
}

File::File(std::span<const std::byte> image, const std::string& where)
    : task_{Task::Kind::read, where}, handle_(open_image(image, task_))
{
}

Group File::root() const
{
    return {Handle(H5Gopen2(handle_.id(), "/", H5P_DEFAULT), H5Gclose, task_, "the root group"), task_};
}

std::vector<std::byte> File::image() const
{
    if (H5Fflush(handle_.id(), H5F_SCOPE_GLOBAL) < 0) {
        task_.fail("the file");
    }
    // HDF5 leaves the user block out, but counts on it in the addresses.
    const ssize_t size = H5Fget_file_image(handle_.id(), nullptr, 0);
    if (size <= 0) {
        task_.fail("the file");
    }
    const auto length = static_cast<std::size_t>(size);
    std::vector<std::byte> bytes(user_block_ + length);
    if (H5Fget_file_image(handle_.id(), bytes.data() + user_block_, length) != size) {
        task_.fail("the file");
    }
    return bytes;
}

} // namespace aneurysm::output::hdf5
