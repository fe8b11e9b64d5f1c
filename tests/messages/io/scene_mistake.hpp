// One deliberate mistake in a sound scene, and all that is said of it.
#pragma once

#include "tests/unit/io/scene_example.hpp"

#include <gtest/gtest.h>

#include <string>

namespace quicksand::fixtures {

struct SceneMistake {
    std::string name;
    std::string sound;    // text of the sound scene, found there once
    std::string mistaken; // what stands in its place
    std::string message;
};

inline void PrintTo(const SceneMistake& mistake, std::ostream* stream)
{
    *stream << mistake.mistaken;
}

inline std::string name_of(const testing::TestParamInfo<SceneMistake>& info)
{
    return info.param.name;
}

} // namespace quicksand::fixtures
