#include "app/manual/exit_meanings.hpp"

#include <array>

namespace quicksand {

std::span<const ExitMeaning> exit_meanings()
{
    static constexpr std::array meanings = {
        ExitMeaning{ExitCode::good, "success, or stopped on request"},
        ExitMeaning{ExitCode::input, "the input cannot be run: command line, scene or drawing"},
        ExitMeaning{ExitCode::numerical, "the run failed; the message names place and likely causes. stress: "
                                         "a row ended well and is wrong"},
        ExitMeaning{ExitCode::files, "files, disk or memory"},
        ExitMeaning{ExitCode::bug, "a bug in Quicksand; please report it"},
        ExitMeaning{ExitCode::inaccurate, "verify: an error is above its limit, or an order below it"}};
    return meanings;
}

} // namespace quicksand
