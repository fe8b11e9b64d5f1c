#include "app/commands/number_check.hpp"

#include <CLI/Validators.hpp>

#include <cmath>
#include <string>

namespace quicksand {

CLI::Validator number_in(const Interval& interval)
{
    const std::string allowed = describe(interval, Dimension::none);
    const auto refusal = [interval, allowed](std::string& word) -> std::string {
        double number = 0.0;
        const bool finite = CLI::detail::lexical_cast(word, number) && std::isfinite(number);
        if (finite && interval.contains(number)) return "";
        return word + (finite ? " is out of range" : " is not a finite number") + "\nexpected: " + allowed;
    };
    return {refusal, allowed};
}

} // namespace quicksand
