// The pictures of the report on a run, as HTML; they are drawn in a folder that is gone at the end.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace quicksand {

using Notify = std::function<void(const std::string&)>;

/// A folder for short-lived files, removed with all it holds.
class ShortLivedFolder {
public:
    /// Throws FileError.
    ShortLivedFolder();
    ~ShortLivedFolder();
    ShortLivedFolder(const ShortLivedFolder&) = delete;
    ShortLivedFolder& operator=(const ShortLivedFolder&) = delete;
    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

/// The regions of the section in the first frame.
std::string section_picture(const std::filesystem::path& results, const std::filesystem::path& folder);

/// The fields of the last frame, histories and probes as `picture` draws them, then the figures that the
/// scene asks for.
std::string result_pictures(const std::filesystem::path& results, const std::filesystem::path& folder,
                            const Notify& notify);

/// A field at up to 24 times, in one range of colours. Throws InputError where there is no such field.
std::string field_animation(const std::filesystem::path& results, const std::string& field,
                            const std::filesystem::path& folder);

/// The motion of the base with measures, histories and 5 %-damped spectra: of the scene that was run, where
/// it can still be read, else as history.csv has it. Empty without shaking.
std::string motion_pictures(const std::filesystem::path& results, const std::filesystem::path& folder,
                            const Notify& notify);

} // namespace quicksand
