#include "io/files/atomic_file.hpp"
#include "io/files/file_error.hpp"
#include "tests/fixtures/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace quicksand {
namespace {

using fixtures::TemporaryFolder;

TEST(AtomicFile, ReadsWhatWasWritten)
{
    const TemporaryFolder folder;
    // longer than a block of the reader, with every byte
    std::string text(150'000, '\0');
    for (std::size_t k = 0; k < text.size(); ++k) text[k] = static_cast<char>(k % 251);
    for (const std::string& content : {std::string(), std::string("a\r\nb"), text}) {
        write_atomically(folder / "a.txt", content);
        EXPECT_TRUE(read_text(folder / "a.txt") == content) << content.size();
    }
}

TEST(AtomicFile, WritingSaysThatTheFormerContentIsUntouched)
{
    const TemporaryFolder folder;
    const auto failure_of = [](const std::filesystem::path& path) {
        try {
            write_atomically(path, "text");
        } catch (const FileError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_EQ(failure_of(folder / "missing/a.txt"),
              (folder / "missing/a.txt").string() +
                  ": cannot write: No such file or directory; its former content is untouched");
    std::filesystem::create_directory(folder / "a.txt");
    EXPECT_EQ(failure_of(folder / "a.txt"),
              (folder / "a.txt").string() +
                  ": cannot replace the file: Is a directory; its former content is untouched");
}

TEST(AtomicFile, ReadingAFolderIsAFileError)
{
    const TemporaryFolder folder;
    try {
        read_text(folder.path());
        FAIL();
    } catch (const FileError& error) {
        EXPECT_EQ(std::string(error.what()), folder.path().string() + ": cannot read: Is a directory");
    }
}

TEST(AtomicFile, ReadingAMissingFileIsAFileError)
{
    const TemporaryFolder folder;
    EXPECT_THROW(read_text(folder / "missing.txt"), FileError);
}

} // namespace
} // namespace quicksand
