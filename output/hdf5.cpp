// SPDX-License-Identifier: Apache-2.0
#include "output/hdf5.hpp"

#include "common/error.hpp"
#include "common/text.hpp"

#include <algorithm>
#include <atomic>
#include <type_traits>

namespace aneurysm::output::hdf5
{
namespace
{

/// The innermost message of HDF5's last failure.
thread_local std::string library_reason; // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)

/// HDF5 calls this when a function of it fails; its own choice would print to the terminal.
herr_t note_reason(hid_t stack, void*)
{
    library_reason.clear();
    const auto take_first = [](unsigned, const H5E_error2_t* error, void*) -> herr_t {
        if (library_reason.empty() && error->desc != nullptr) {
            library_reason = error->desc;
        }
        return 0;
    };
    H5Ewalk2(stack, H5E_WALK_UPWARD, take_first, nullptr);
    library_reason = excerpt(library_reason);
    return 0;
}

/// Does f; `name` is what it reads or writes, for the message when HDF5 fails.
template <class F>
auto attempt(const Task& task, const std::string& name, const F& f)
{
    H5Eset_auto2(H5E_DEFAULT, note_reason, nullptr);
    try {
        return f();
    } catch (const H5::Exception&) {
        task.fail(name, library_reason.empty() ? "HDF5 gives no reason" : library_reason);
    }
}

H5::FileAccPropList in_memory()
{
    constexpr std::size_t increment = std::size_t{1} << 20U;
    H5::FileAccPropList access;
    access.setCore(increment, false);
    return access;
}

/// HDF5 takes two files of one name for the same file.
std::string new_name()
{
    static std::atomic<int> count = 0;
    return "in memory " + std::to_string(++count);
}

H5::H5File create_image(std::size_t user_block, const Task& task)
{
    return attempt(task, "the file", [&] {
        H5::FileCreatPropList creation;
        creation.setUserblock(user_block);
        return H5::H5File(new_name(), H5F_ACC_TRUNC, creation, in_memory());
    });
}

H5::H5File open_image(std::string_view image, const Task& task)
{
    if (image.empty()) {
        task.fail("the file", "it is empty");
    }
    return attempt(task, "the file", [&] {
        const H5::FileAccPropList access = in_memory();
        // HDF5 copies the bytes, although it asks for them without const.
        void* bytes = const_cast<char*>(image.data()); // NOLINT(cppcoreguidelines-pro-type-const-cast)
        H5Pset_file_image(access.getId(), bytes, image.size());
        return H5::H5File(new_name(), H5F_ACC_RDONLY, H5::FileCreatPropList::DEFAULT, access);
    });
}

H5::StrType text_type(const std::string& text)
{
    return {H5::PredType::C_S1, std::max<std::size_t>(text.size(), 1)};
}

/// Without times: the same state makes the same bytes.
H5::DSetCreatPropList untimed()
{
    H5::DSetCreatPropList properties;
    H5Pset_obj_track_times(properties.getId(), false);
    return properties;
}

/// The string of fixed length that an array or an attribute holds.
template <class Place>
std::string fixed_text(const Place& place, const Task& task, const std::string& name)
{
    if (place.getTypeClass() != H5T_STRING || place.getStrType().isVariableStr()) {
        task.fail(name, "not a string of fixed length");
    }
    std::string text;
    if constexpr (std::is_same_v<Place, H5::Attribute>) {
        place.read(place.getStrType(), text);
    } else {
        place.read(text, place.getStrType());
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

Type type_of(double)
{
    return {H5::PredType::NATIVE_DOUBLE, H5::PredType::IEEE_F64LE};
}
Type type_of(std::int64_t)
{
    return {H5::PredType::NATIVE_INT64, H5::PredType::STD_I64LE};
}
Type type_of(std::uint8_t)
{
    return {H5::PredType::NATIVE_UINT8, H5::PredType::STD_U8LE};
}

Group Group::create_group(const std::string& name) const
{
    return {attempt(task_, name, [&] { return group_.createGroup(name); }), task_};
}

Group Group::open_group(const std::string& name) const
{
    return {attempt(task_, name, [&] { return group_.openGroup(name); }), task_};
}

void Group::write_array(const std::string& name, const void* data, std::size_t count, std::size_t columns,
                        Type type) const
{
    attempt(task_, name, [&] {
        const std::array<hsize_t, 2> extent{count / columns, columns};
        const H5::DataSpace space(columns == 1 ? 1 : 2, extent.data());
        const H5::DataSet set = group_.createDataSet(name, type.file, space, untimed());
        if (count > 0) {
            set.write(data, type.memory);
        }
    });
}

void Group::write(const std::string& name, const std::vector<Vec3>& vectors) const
{
    static_assert(sizeof(Vec3) == 3 * sizeof(double));
    write_array(name, vectors.data(), 3 * vectors.size(), 3, type_of(double{}));
}

void Group::write(const std::string& name, const std::vector<Kind>& kinds) const
{
    static_assert(sizeof(Kind) == sizeof(std::uint8_t));
    write_array(name, kinds.data(), kinds.size(), 1, type_of(std::uint8_t{}));
}

void Group::write(const std::string& name, const std::string& text) const
{
    attempt(task_, name, [&] {
        group_.createDataSet(name, text_type(text), H5::DataSpace(), untimed()).write(text, text_type(text));
    });
}

std::size_t Group::array_size(const std::string& name, std::size_t columns) const
{
    return attempt(task_, name, [&] {
        const H5::DataSet set = group_.openDataSet(name);
        const H5::DataSpace space = set.getSpace();
        std::array<hsize_t, 2> extent{0, 1};
        if (space.getSimpleExtentNdims() != (columns == 1 ? 1 : 2) ||
            space.getSimpleExtentDims(extent.data()) < 0 || extent[1] != columns) {
            task_.fail(name, "not an array of " + std::to_string(columns) + " columns");
        }
        // What the file says must be there before memory is taken for it.
        if (set.getStorageSize() < extent[0] * columns) {
            task_.fail(name, "less data than its extent");
        }
        return extent[0] * columns;
    });
}

void Group::read_array(const std::string& name, void* data, Type type) const
{
    attempt(task_, name, [&] {
        const H5::DataSet set = group_.openDataSet(name);
        if (!(set.getDataType() == type.file)) {
            task_.fail(name, "another number type");
        }
        set.read(data, type.memory);
    });
}

std::vector<Vec3> Group::read_vectors(const std::string& name) const
{
    std::vector<Vec3> vectors(array_size(name, 3) / 3);
    read_array(name, vectors.data(), type_of(double{}));
    return vectors;
}

std::vector<Kind> Group::read_kinds(const std::string& name) const
{
    std::vector<Kind> kinds;
    for (const std::uint8_t number : read<std::uint8_t>(name)) {
        if (number > static_cast<std::uint8_t>(Kind::outlet_2)) {
            task_.fail(name, "unknown value " + std::to_string(number));
        }
        kinds.push_back(static_cast<Kind>(number));
    }
    return kinds;
}

std::string Group::read_text(const std::string& name) const
{
    return attempt(task_, name, [&] { return fixed_text(group_.openDataSet(name), task_, name); });
}

void Group::write_attribute(const std::string& name, const void* data, std::size_t count, Type type) const
{
    attempt(task_, name, [&] {
        const hsize_t extent = count;
        const H5::DataSpace space = count == 1 ? H5::DataSpace() : H5::DataSpace(1, &extent);
        group_.createAttribute(name, type.file, space).write(type.memory, data);
    });
}

void Group::write_attribute(const std::string& name, const std::string& text) const
{
    attempt(task_, name, [&] {
        group_.createAttribute(name, text_type(text), H5::DataSpace()).write(text_type(text), text);
    });
}

void Group::describe(const std::string& array, const std::string& name, const std::string& text) const
{
    attempt(task_, array + ": " + name, [&] {
        const H5::DataSet set = group_.openDataSet(array);
        set.createAttribute(name, text_type(text), H5::DataSpace()).write(text_type(text), text);
    });
}

std::string Group::description(const std::string& array, const std::string& name) const
{
    return attempt(task_, array + ": " + name,
                   [&] { return fixed_text(group_.openDataSet(array).openAttribute(name), task_, name); });
}

void Group::read_attribute(const std::string& name, void* data, Type type) const
{
    attempt(task_, name, [&] {
        const H5::Attribute attribute = group_.openAttribute(name);
        if (attribute.getSpace().getSimpleExtentNpoints() != 1 || !(attribute.getDataType() == type.file)) {
            task_.fail(name, "not one number of its type");
        }
        attribute.read(type.memory, data);
    });
}

std::string Group::read_text_attribute(const std::string& name) const
{
    return attempt(task_, name, [&] { return fixed_text(group_.openAttribute(name), task_, name); });
}

File::File(const std::string& where, std::size_t user_block)
    : task_{Task::Kind::write, where}, file_(create_image(user_block, task_)), user_block_(user_block)
{
}

File::File(std::string_view image, const std::string& where)
    : task_{Task::Kind::read, where}, file_(open_image(image, task_))
{
}

Group File::root() const
{
    return {attempt(task_, "the root group", [&] { return file_.openGroup("/"); }), task_};
}

std::string File::image() const
{
    return attempt(task_, "the file", [&] {
        file_.flush(H5F_SCOPE_GLOBAL);
        // HDF5 leaves the user block out, but counts on it in the addresses.
        const auto size = std::max<ssize_t>(H5Fget_file_image(file_.getId(), nullptr, 0), 0);
        std::string bytes(user_block_ + static_cast<std::size_t>(size), '\0');
        if (size == 0 || H5Fget_file_image(file_.getId(), bytes.data() + user_block_,
                                           static_cast<std::size_t>(size)) != size) {
            throw H5::FileIException();
        }
        return bytes;
    });
}

} // namespace aneurysm::output::hdf5
