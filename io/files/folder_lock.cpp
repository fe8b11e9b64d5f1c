#include "io/files/folder_lock.hpp"

#include "io/files/file_error.hpp"
#include "solver/base/failure.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>

namespace quicksand {

FolderLock::FolderLock(const std::filesystem::path& directory)
    : descriptor_(::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC))
{
    if (descriptor_ < 0) throw FileError(directory, "cannot open the folder", system_reason(errno), "");
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
    ::close(descriptor_);
    throw InputError(directory.string() +
                     " is being written by another run. Wait for its end, or choose another folder");
}

FolderLock::~FolderLock()
{
    ::close(descriptor_);
}

} // namespace quicksand
