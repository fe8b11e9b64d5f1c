#include "io/files/atomic_file.hpp"

#include "io/files/file_error.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <system_error>

namespace quicksand {

namespace fs = std::filesystem;

namespace {

void write_temporary(const fs::path& path, std::string_view text)
{
    const fs::path temporary = temporary_name(path);
    std::FILE* file = std::fopen(temporary.c_str(), "wb");
    if (!file) throw FileError(path, "cannot write", system_reason(errno), "its former content is untouched");
    errno = 0;
    const bool written = std::fwrite(text.data(), 1, text.size(), file) == text.size();
    int reason = errno;
    // A full disk may show only when the buffer is flushed on closing.
    const bool closed = std::fclose(file) == 0;
    if (written && closed) return;
    if (written) reason = errno;
    std::error_code ignored;
    fs::remove(temporary, ignored);
    throw FileError(path, "cannot write", system_reason(reason), "its former content is untouched");
}

/// Put a file's or folder's content on the disk itself.
void synchronize(const fs::path& path)
{
    const int descriptor = ::open(path.c_str(), O_RDONLY);
    if (descriptor < 0) throw FileError(path, "cannot open", system_reason(errno), "");
    const bool done = ::fsync(descriptor) == 0;
    const int reason = errno;
    ::close(descriptor);
    // Some file systems cannot synchronize folders and say EINVAL; then there is nothing more to do.
    if (!done && reason != EINVAL)
        throw FileError(path, "cannot bring to the disk", system_reason(reason), "");
}

} // namespace

fs::path temporary_name(const fs::path& path)
{
    return path.string() + ".tmp";
}

void replace_file(const fs::path& path)
{
    std::error_code error;
    fs::rename(temporary_name(path), path, error);
    if (error)
        throw FileError(path, "cannot replace the file", error.message(), "its former content is untouched");
}

void write_atomically(const fs::path& path, std::string_view text)
{
    write_temporary(path, text);
    replace_file(path);
}

void write_durably(const fs::path& path, std::string_view bytes)
{
    write_temporary(path, bytes);
    synchronize(temporary_name(path));
    replace_file(path);
    synchronize(fs::absolute(path).parent_path());
}

} // namespace quicksand
