// The file: a dataset for every array of Particles under its name, chunked and with Fletcher-32 checksums,
// and attributes of the root group: format_version, state_hash, program_version, stage, time, step,
// stages_before, memory_columns, last_step, whole_step, step_scale, implicit_cost, step_halvings,
// times_halved, explicit_end, particles, reactions; for every column of a free field the same in a group
// free_field_K, and their number free_fields. The last 16 bytes are the FNV-1a hash of all before them, which
// HDF5 does not look at: the file is checked before HDF5 opens it, since it copes badly with damaged tables.
// HDF5 keeps no times of its objects, so that equal states make equal files.
#include "io/results/checkpoint.hpp"

#include "io/files/atomic_file.hpp"
#include "io/files/file_error.hpp"
#include "io/results/run_manifest.hpp"
#include "solver/base/failure.hpp"

#include <hdf5.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <string_view>
#include <system_error>
#include <utility>

namespace quicksand {

namespace {

namespace fs = std::filesystem;

constexpr std::int64_t format_version = 18;
constexpr hsize_t chunk_entries = 8192;

/// An HDF5 call failed; the caller knows the file and makes a FileError of it.
struct Hdf5Failure {
    std::string what;
};

/// Owner of an HDF5 handle, closed by the function of its kind.
class Handle {
public:
    Handle(hid_t id, herr_t (*close)(hid_t), const std::string& what) : id_(id), close_(close)
    {
        if (id < 0) throw Hdf5Failure{what};
    }
    ~Handle() { close_(id_); }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    operator hid_t() const { return id_; }

private:
    hid_t id_;
    herr_t (*close_)(hid_t);
};

/// Keeps HDF5 from printing its error stack.
class QuietHdf5 {
public:
    QuietHdf5()
    {
        H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
        H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    }
    ~QuietHdf5() { H5Eset_auto2(H5E_DEFAULT, function_, data_); }
    QuietHdf5(const QuietHdf5&) = delete;
    QuietHdf5& operator=(const QuietHdf5&) = delete;

private:
    H5E_auto2_t function_ = nullptr;
    void* data_ = nullptr;
};

void require(herr_t status, const std::string& what)
{
    if (status < 0) throw Hdf5Failure{what};
}

hid_t type_of(double)
{
    return H5T_NATIVE_DOUBLE;
}

hid_t type_of(std::int32_t)
{
    return H5T_NATIVE_INT32;
}

hid_t type_of(std::int64_t)
{
    return H5T_NATIVE_INT64;
}

template <class Value>
void write_number(hid_t file, const char* name, Value value)
{
    const Handle space(H5Screate(H5S_SCALAR), H5Sclose, name);
    const Handle attribute(H5Acreate2(file, name, type_of(value), space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                           name);
    require(H5Awrite(attribute, type_of(value), &value), name);
}

template <class Value>
Value read_number(hid_t file, const char* name)
{
    Value value{};
    const Handle attribute(H5Aopen(file, name, H5P_DEFAULT), H5Aclose, name);
    require(H5Aread(attribute, type_of(value), &value), name);
    return value;
}

void write_text(hid_t file, const char* name, const std::string& text)
{
    const Handle space(H5Screate(H5S_SCALAR), H5Sclose, name);
    const Handle type(H5Tcopy(H5T_C_S1), H5Tclose, name);
    require(H5Tset_size(type, text.size() + 1), name);
    const Handle attribute(H5Acreate2(file, name, type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose, name);
    require(H5Awrite(attribute, type, text.c_str()), name);
}

std::string read_text_attribute(hid_t file, const char* name)
{
    const Handle attribute(H5Aopen(file, name, H5P_DEFAULT), H5Aclose, name);
    const Handle type(H5Aget_type(attribute), H5Tclose, name);
    std::string text(H5Tget_size(type), '\0');
    require(H5Aread(attribute, type, text.data()), name);
    return text.substr(0, text.find('\0'));
}

template <class Value>
void write_array(hid_t file, const char* name, const std::vector<Value>& values)
{
    const hsize_t count = values.size();
    const hsize_t chunk = std::min(count, chunk_entries);
    const Handle space(H5Screate_simple(1, &count, nullptr), H5Sclose, name);
    const Handle layout(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, name);
    require(H5Pset_chunk(layout, 1, &chunk), name);
    require(H5Pset_fletcher32(layout), name);
    require(H5Pset_obj_track_times(layout, false), name);
    const Handle dataset(H5Dcreate2(file, name, type_of(Value{}), space, H5P_DEFAULT, layout, H5P_DEFAULT),
                         H5Dclose, name);
    require(H5Dwrite(dataset, type_of(Value{}), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), name);
}

/// Reads an array of `count` entries; leaves it empty where the scene has no such array.
template <class Value>
void read_array(hid_t file, const char* name, std::size_t count, std::vector<Value>& values)
{
    if (H5Lexists(file, name, H5P_DEFAULT) <= 0) return;
    const Handle dataset(H5Dopen2(file, name, H5P_DEFAULT), H5Dclose, name);
    const Handle space(H5Dget_space(dataset), H5Sclose, name);
    if (H5Sget_simple_extent_npoints(space) != static_cast<hssize_t>(count)) throw Hdf5Failure{name};
    values.resize(count);
    require(H5Dread(dataset, type_of(Value{}), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), name);
}

/// The bytes of a file that HDF5 builds in memory. HDF5 itself copes badly with a full disk: after a failed
/// flush its file can be neither closed nor abandoned. So it writes here, and plain bytes go to the disk.
struct FileImage {
    std::string bytes;        // complete once the file is closed
    std::size_t capacity = 0; // of HDF5's buffer [byte]
};

void* grow_image(void* buffer, size_t size, H5FD_file_image_op_t, void* image)
{
    static_cast<FileImage*>(image)->capacity = size;
    return std::realloc(buffer, size);
}

/// HDF5 gives the buffer back on closing; its checksums are complete only then.
herr_t take_image(void* buffer, H5FD_file_image_op_t operation, void* user_data)
{
    auto& image = *static_cast<FileImage*>(user_data);
    if (operation == H5FD_FILE_IMAGE_OP_FILE_CLOSE)
        image.bytes.assign(static_cast<const char*>(buffer), image.capacity);
    std::free(buffer);
    return 0;
}

void* share_image(void* image)
{
    return image;
}

herr_t leave_image(void*)
{
    return 0;
}

/// Settings for a file in memory, in the newer format, which has checksums of its own structure too.
void set_up_memory_file(hid_t settings, FileImage& image)
{
    constexpr std::size_t growth = 1; // the buffer is as long as the file [byte]
    H5FD_file_image_callbacks_t callbacks{nullptr,     nullptr,     grow_image, take_image,
                                          share_image, leave_image, &image};
    require(H5Pset_fapl_core(settings, growth, false), "settings");
    require(H5Pset_file_image_callbacks(settings, &callbacks), "settings");
    require(H5Pset_libver_bounds(settings, H5F_LIBVER_V18, H5F_LIBVER_V110), "settings");
}

std::string group_of_free_field(std::size_t k)
{
    return "free_field_" + std::to_string(k);
}

void write_numbers(const State& state, hid_t place)
{
    write_number(place, "stage", static_cast<std::int64_t>(state.stage));
    write_number(place, "time", state.time);
    write_number(place, "step", state.step);
    write_number(place, "stages_before", state.stages_before);
    write_number(place, "last_step", state.last_step);
    write_number(place, "whole_step", state.whole_step);
    write_number(place, "step_scale", state.step_scale);
    write_number(place, "implicit_cost", state.implicit_cost);
    write_number(place, "step_halvings", state.step_halvings);
    write_number(place, "times_halved", state.times_halved);
    write_number(place, "explicit_end", state.explicit_end);
    write_number(place, "particles", static_cast<std::int64_t>(state.particles.size()));
    write_number(place, "memory_columns", static_cast<std::int64_t>(state.particles.memory.size()));
    if (state.balance_terms)
        for_each_number(*state.balance_terms,
                        [&](const char* name, double value) { write_number(place, name, value); });
}

void write_arrays(const State& state, hid_t place)
{
    // Arrays a dry scene does not need are empty and left out.
    const auto write = [&](const char* name, const auto& values) {
        if (!values.empty()) write_array(place, name, values);
    };
    for_each_index_array(state.particles, write);
    for_each_array(state.particles, write);
    write("reaction_x", state.reactions.x);
    write("reaction_y", state.reactions.y);
    write_number(place, "reactions", static_cast<std::int64_t>(state.reactions.x.size()));
}

/// All of a state, in the file or in a group of it, with groups for the columns of free fields.
void write_into(const State& state, hid_t place)
{
    write_numbers(state, place);
    write_arrays(state, place);
    if (state.free_fields.empty()) return;
    write_number(place, "free_fields", static_cast<std::int64_t>(state.free_fields.size()));
    for (std::size_t k = 0; k < state.free_fields.size(); ++k) {
        const std::string name = group_of_free_field(k);
        const Handle properties(H5Pcreate(H5P_GROUP_CREATE), H5Pclose, name);
        require(H5Pset_obj_track_times(properties, false), name);
        const Handle group(H5Gcreate2(place, name.c_str(), H5P_DEFAULT, properties, H5P_DEFAULT), H5Gclose,
                           name);
        write_into(state.free_fields[k].column, group);
    }
}

void write_state(const State& state, const std::string& state_hash, FileImage& image)
{
    const Handle settings(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "settings");
    set_up_memory_file(settings, image);
    const Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose, "settings");
    require(H5Pset_obj_track_times(creation, false), "settings");
    const Handle file(H5Fcreate("in memory", H5F_ACC_TRUNC, creation, settings), H5Fclose,
                      "creating the file");
    write_number(file, "format_version", format_version);
    write_text(file, "program_version", program_version());
    write_text(file, "state_hash", state_hash);
    write_into(state, file);
    require(H5Fflush(file, H5F_SCOPE_GLOBAL), "flushing the file");
}

State read_state(hid_t file)
{
    State state;
    state.stage = static_cast<Stage>(read_number<std::int64_t>(file, "stage"));
    state.time = read_number<double>(file, "time");
    state.step = read_number<std::int64_t>(file, "step");
    state.stages_before = read_number<std::int64_t>(file, "stages_before");
    state.last_step = read_number<double>(file, "last_step");
    state.whole_step = read_number<double>(file, "whole_step");
    state.step_scale = read_number<double>(file, "step_scale");
    state.implicit_cost = read_number<double>(file, "implicit_cost");
    state.step_halvings = read_number<std::int64_t>(file, "step_halvings");
    state.times_halved = read_number<std::int64_t>(file, "times_halved");
    state.explicit_end = read_number<std::int64_t>(file, "explicit_end");
    const auto count = static_cast<std::size_t>(read_number<std::int64_t>(file, "particles"));
    state.particles.memory.resize(
        static_cast<std::size_t>(read_number<std::int64_t>(file, "memory_columns")));
    if (H5Aexists(file, "balance_kinetic_change") > 0) {
        state.balance_terms.emplace();
        for_each_number(*state.balance_terms,
                        [&](const char* name, double& value) { value = read_number<double>(file, name); });
    }
    const auto read = [&](const char* name, auto& values) { read_array(file, name, count, values); };
    for_each_index_array(state.particles, read);
    for_each_array(state.particles, read);
    const auto reactions = static_cast<std::size_t>(read_number<std::int64_t>(file, "reactions"));
    read_array(file, "reaction_x", reactions, state.reactions.x);
    read_array(file, "reaction_y", reactions, state.reactions.y);
    if (H5Aexists(file, "free_fields") <= 0) return state;
    state.free_fields.resize(static_cast<std::size_t>(read_number<std::int64_t>(file, "free_fields")));
    for (std::size_t k = 0; k < state.free_fields.size(); ++k) {
        const std::string name = group_of_free_field(k);
        const Handle group(H5Gopen2(file, name.c_str(), H5P_DEFAULT), H5Gclose, name);
        state.free_fields[k].column = read_state(group);
    }
    return state;
}

/// The arrays must be complete: those of a group are all there, or none.
void require_complete(const State& state)
{
    std::map<ArrayGroup, bool> present = {{ArrayGroup::always, true}};
    for_each_array(state.particles, [&](const char* name, const Scalars& values) {
        const auto group = present.emplace(group_of(name), !values.empty()).first;
        if (values.empty() == group->second) throw Hdf5Failure{name};
    });
    if (state.particles.material.size() != state.particles.size()) throw Hdf5Failure{"material"};
    if (state.particles.region.size() != state.particles.size()) throw Hdf5Failure{"region"};
    for (const FreeFieldState& field : state.free_fields) require_complete(field.column);
}

void require_intact(const fs::path& path)
{
    constexpr std::size_t hash_length = 16;
    const std::string bytes = read_text(path);
    if (bytes.size() < hash_length) throw Hdf5Failure{"its end, it is cut off"};
    const std::string_view content = std::string_view(bytes).substr(0, bytes.size() - hash_length);
    if (text_hash(content) != bytes.substr(content.size())) throw Hdf5Failure{"its checksum"};
}

void require_same_scene(const fs::path& path, hid_t file, const std::string& state_hash)
{
    const std::int64_t version = read_number<std::int64_t>(file, "format_version");
    if (version != format_version)
        throw InputError(path.string() + ": the checkpoint has format " + std::to_string(version) +
                         ", this program reads format " + std::to_string(format_version) +
                         "\nhint: go on with the program that wrote it, or start the run anew with "
                         "--overwrite");
    const std::string found = read_text_attribute(file, "state_hash");
    if (found != state_hash)
        throw InputError(path.string() + ": the checkpoint is of another scene (hash " + found +
                         ", this one has " + state_hash +
                         "). Resume with the unchanged scene file and the same --set values");
}

} // namespace

void write_checkpoint(const fs::path& path, const State& state, const std::string& state_hash)
{
    const QuietHdf5 quiet;
    const fs::path folder = fs::absolute(path).parent_path();
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw FileError(folder, "cannot create the folder", error.message(), "");
    try {
        FileImage image;
        write_state(state, state_hash, image);
        write_durably(path, image.bytes + text_hash(image.bytes));
    } catch (const Hdf5Failure& failure) {
        throw FileError(path, "cannot write the checkpoint", "HDF5 failed at: " + failure.what,
                        "the checkpoint before it is untouched");
    }
}

State read_checkpoint(const fs::path& path, const std::string& state_hash)
{
    const QuietHdf5 quiet;
    if (!fs::exists(path)) throw InputError(path.string() + ": there is no checkpoint to resume from");
    try {
        require_intact(path);
        const Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, "opening the file");
        require_same_scene(path, file, state_hash);
        State state = read_state(file);
        require_complete(state);
        return state;
    } catch (const Hdf5Failure& failure) {
        throw FileError(path, "cannot read the checkpoint", "it is damaged at: " + failure.what,
                        "start the run anew with --overwrite");
    }
}

CheckpointWriter::CheckpointWriter(fs::path path, double interval, const State& state, std::string state_hash,
                                   std::shared_ptr<BackgroundWriter> background)
    : path_(std::move(path)), interval_(interval), state_(state), state_hash_(std::move(state_hash)),
      background_(std::move(background)), last_(Clock::now())
{
}

void CheckpointWriter::after_step(const StepReport& report)
{
    background_->report_failure();
    if (!report.is_restart_point || Clock::now() - last_ < interval_) return;
    background_->write(state_, [path = path_, hash = state_hash_](const State& copy) {
        write_checkpoint(path, copy, hash);
    });
    last_ = Clock::now();
}

} // namespace quicksand
