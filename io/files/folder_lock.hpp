// A folder that one process writes to and others keep out of.
#pragma once

#include <filesystem>

namespace quicksand {

/// Holds a folder for as long as it lives. The system lets go of it when the process ends in whatever way,
/// and no file is left behind. File systems that know no locks are not held.
class FolderLock {
public:
    /// Throws InputError when another process, or another lock of this one, holds the folder; FileError when
    /// it cannot be opened.
    explicit FolderLock(const std::filesystem::path& directory);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

private:
    int descriptor_;
};

} // namespace quicksand
