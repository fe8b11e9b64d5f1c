// Runs the built program as a user does, in a folder of its own.
#pragma once

#include "tests/fixtures/checkout.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace quicksand::testing_program {

struct Outcome {
    int code = -1;      // exit code, -1 when the program was killed
    std::string output; // standard output and error together
};

/// A shell command's exit code and output; `$QUICKSAND` in it is the program.
inline Outcome run_shell(const std::string& command)
{
    const std::string line = "QUICKSAND='" + built_program() + "'; { " + command + "\n} 2>&1";
    std::FILE* pipe = popen(line.c_str(), "r");
    if (pipe == nullptr) throw std::runtime_error("cannot run " + line);
    Outcome outcome;
    std::array<char, 4096> buffer;
    for (std::size_t count = 0; (count = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;) {
        outcome.output.append(buffer.data(), count);
    }
    const int status = pclose(pipe);
    if (WIFEXITED(status)) outcome.code = WEXITSTATUS(status);
    return outcome;
}

inline Outcome run_program(const std::string& arguments)
{
    return run_shell("\"$QUICKSAND\" " + arguments);
}

/// A new empty folder that is removed at the end.
class WorkFolder {
public:
    WorkFolder()
    {
        std::string name = (std::filesystem::temp_directory_path() / "quicksand_test_XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make " + name);
        path_ = name;
    }
    ~WorkFolder()
    {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    WorkFolder(const WorkFolder&) = delete;
    WorkFolder& operator=(const WorkFolder&) = delete;

    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    std::string string() const { return path_.string(); }

private:
    std::filesystem::path path_;
};

inline std::string read_file(const std::filesystem::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// First line that is no comment.
inline std::string header_of(const std::filesystem::path& file)
{
    std::ifstream stream(file);
    for (std::string line; std::getline(stream, line);) {
        if (!line.starts_with('#')) return line;
    }
    return "";
}

/// The numbers of a column of a table with comments; NaN where a cell is empty.
inline std::vector<double> numbers_of(const std::filesystem::path& file, const std::string& column)
{
    std::istringstream header(header_of(file));
    int place = 0;
    std::string word;
    while (std::getline(header, word, ',') && word != column) ++place;
    EXPECT_EQ(word, column) << "is no column of " << file;
    std::ifstream table(file);
    std::vector<double> numbers;
    bool is_below = false; // the header
    for (std::string line; std::getline(table, line);) {
        if (line.starts_with('#')) continue;
        std::istringstream row(line);
        for (int k = 0; k <= place; ++k) std::getline(row, word, ',');
        if (is_below) numbers.push_back(word.empty() ? NAN : std::stod(word));
        is_below = true;
    }
    return numbers;
}

inline void expect_mention(const Outcome& outcome, const std::string& text)
{
    EXPECT_NE(outcome.output.find(text), std::string::npos) << "no '" << text << "' in:\n" << outcome.output;
}

inline std::string example(const std::string& name)
{
    return in_checkout("examples/" + name);
}

} // namespace quicksand::testing_program
