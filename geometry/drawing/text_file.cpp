#include "geometry/drawing/text_file.hpp"

#include "solver/base/failure.hpp"

#include <array>
#include <cerrno>
#include <fstream>

namespace quicksand {

std::string read_text(const std::filesystem::path& path)
{
    errno = 0;
    std::ifstream stream(path, std::ios::binary);
    if (!stream) throw FileError(path, "cannot read", system_reason(errno), "");
    std::string text;
    std::array<char, 65536> block;
    // A failed read throws out of an istreambuf_iterator; read() turns it into a bad stream.
    do {
        stream.read(block.data(), static_cast<std::streamsize>(block.size()));
        text.append(block.data(), static_cast<std::size_t>(stream.gcount()));
    } while (stream);
    if (stream.bad()) throw FileError(path, "cannot read", system_reason(errno), "");
    return text;
}

} // namespace quicksand
