// A sound file of element tests for the tests, and texts made from it.
#pragma once

#include "io/element_file.hpp"
#include "solver/base/failure.hpp"
#include "tests/unit/io/scene_example.hpp"

#include <fstream>
#include <string>
#include <vector>

namespace quicksand::fixtures {

inline const std::string sound_tests = R"(test_version = 1
title = "sand"

[materials.sand]
model = "ubcsand"
n1_60 = 13.9

[tests.strength]
kind = "cyclic_shear_stress_controlled"
vertical_stress = "100 kPa"
k0 = 0.5
csr = [0.15, 0.2, 0.3]
cycles = 30
)";

/// A folder with a file of tests; messages name the files without the folder.
class ElementFolder {
public:
    void write(const std::string& name, const std::string& text) const
    {
        std::ofstream(folder_ / name, std::ios::binary) << text;
    }
    ElementReading read(const std::string& text, const std::vector<std::string>& overrides = {}) const
    {
        write("test.toml", text);
        return read_element_file(folder_ / "test.toml", overrides);
    }
    /// What is said of the file: the errors with the warnings, or the warnings alone.
    std::string message(const std::string& text, const std::vector<std::string>& overrides = {}) const
    {
        try {
            const ElementReading reading = read(text, overrides);
            return without_folder(reading.warnings.render(reading.programme.text));
        } catch (const InputError& error) {
            return without_folder(error.what()) + "\n";
        }
    }
    const TemporaryFolder& folder() const { return folder_; }

private:
    std::string without_folder(std::string text) const
    {
        const std::string prefix = folder_.path().string() + "/";
        for (auto at = text.find(prefix); at != std::string::npos; at = text.find(prefix)) {
            text.erase(at, prefix.size());
        }
        return text;
    }

    TemporaryFolder folder_;
};

} // namespace quicksand::fixtures
