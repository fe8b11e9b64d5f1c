// Feeds the program's readers with damaged files, for some seconds each: whatever a file holds, a reader
// takes it or throws one of the failures that name a file or an input. Built with sanitizers, see
// sanitize.sh.
//
//   mutated_inputs SECONDS SEED
#include "io/motions/peer_record.hpp"
#include "io/motions/time_table.hpp"
#include "io/pictures/picture_table.hpp"
#include "io/results/checkpoint.hpp"
#include "io/scene/scene_file.hpp"
#include "solver/base/failure.hpp"
#include "tests/fixtures/checkout.hpp"
#include "tests/fixtures/temporary_folder.hpp"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <random>

namespace quicksand {
namespace {

namespace fs = std::filesystem;
using namespace fixtures;

/// A kind of file: sound ones to begin with, and what reads them.
struct Kind {
    std::string name;
    std::vector<std::string> seeds;
    std::function<void(const fs::path& file, const std::string& text)> read;
};

void write_text(const fs::path& file, const std::string& text)
{
    std::ofstream(file, std::ios::binary | std::ios::trunc) << text;
}

/// Words that readers take for something, to be put between others.
const std::vector<std::string> words = {
    "nan",
    "-inf",
    "1e400",
    "-1e-320",
    "\"",
    "[",
    "]",
    "\n",
    ",",
    "=",
    "[[",
    "\\u0000",
    "9223372036854775808",
    "#",
    ".",
    "NPTS=",
    "DT=",
    "'",
    "{",
    "}",
    "\r",
    ";",
    "0x",
    "1_0",
    "m/s2",
    "g",
};

std::string mutated(std::string text, const std::vector<std::string>& seeds, std::mt19937_64& random)
{
    const auto below = [&random](std::size_t count) { return count == 0 ? 0 : random() % count; };
    for (std::size_t times = 1 + below(6); times > 0; --times) {
        const std::size_t at = below(text.size() + 1),
                          length = below(std::min<std::size_t>(64, text.size() - at + 1));
        switch (below(6)) {
        case 0: // a bit
            if (at < text.size()) text[at] = static_cast<char>(text[at] ^ (1 << below(8)));
            break;
        case 1: // a byte
            if (at < text.size()) text[at] = static_cast<char>(below(256));
            break;
        case 2:
            text.erase(at, length);
            break;
        case 3: // a piece twice
            text.insert(at, text.substr(at, length));
            break;
        case 4:
            text.insert(at, words[below(words.size())]);
            break;
        case 5: { // a piece of another one, or the end is missing
            const std::string& other = seeds[below(seeds.size())];
            text.replace(at, std::string::npos, below(2) == 0 ? "" : other.substr(below(other.size())));
            break;
        }
        }
    }
    return text;
}

/// Returns how many inputs there were; ends the program at the first that is not read in order.
std::size_t try_kind(const Kind& kind, double seconds, std::uint64_t seed, const fs::path& folder)
{
    std::mt19937_64 random(seed);
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + std::chrono::duration<double>(seconds);
    std::size_t count = 0, taken = 0;
    for (; Clock::now() < end; ++count) {
        const std::string text = mutated(kind.seeds[random() % kind.seeds.size()], kind.seeds, random);
        const fs::path file = folder / ("input." + kind.name);
        write_text(file, text); // of a crash, it is what did it
        try {
            kind.read(file, text);
            ++taken;
        } catch (const InputError&) {
        } catch (const FileError&) {
        } catch (const std::exception& error) {
            std::printf("%s, input %zu of seed %llu: %s\nthe input is kept in %s\n", kind.name.c_str(), count,
                        static_cast<unsigned long long>(seed), error.what(), file.c_str());
            std::exit(1);
        }
    }
    std::printf("%-10s %9zu inputs, %zu of them read\n", kind.name.c_str(), count, taken);
    std::fflush(stdout);
    return count;
}

std::vector<std::string> texts_of(const std::vector<std::string>& files)
{
    std::vector<std::string> texts;
    for (const std::string& file : files) texts.push_back(text_of(in_checkout(file)));
    return texts;
}

std::string checkpoint_text(const fs::path& folder, bool saturated)
{
    const Problem problem = small_problem(saturated);
    write_checkpoint(folder / "sound.h5", small_state(problem), "hash");
    return text_of(folder / "sound.h5");
}

std::vector<Kind> all_kinds(const fs::path& folder)
{
    std::vector<Kind> kinds;
    kinds.push_back({"scene",
                     texts_of({"examples/dike/scene.toml", "examples/culvert/scene.toml",
                               "examples/level_ground_motion/scene.toml"}),
                     [](const fs::path& file, const std::string&) { read_scene_file(file, {}); }});
    kinds.push_back({"at2", texts_of({"examples/level_ground_motion/apeel2_loma_prieta_1989_133.AT2"}),
                     [](const fs::path& file, const std::string& text) {
                         Diagnostics findings;
                         is_peer_record(file, text);
                         parse_peer_record(file, text, findings);
                     }});
    kinds.push_back({"table", texts_of({"examples/element_dss/triggering_curve.csv"}),
                     [](const fs::path&, const std::string& text) {
                         TimeTable table;
                         if (parse_time_table(text, table).empty()) check_times(table);
                     }});
    kinds.push_back({"csv", texts_of({"examples/element_dss/nevada_triggering.csv"}),
                     [](const fs::path& file, const std::string&) { read_picture_table(file); }});
    kinds.push_back({"h5",
                     {checkpoint_text(folder, true), checkpoint_text(folder, false)},
                     [](const fs::path& file, const std::string&) { read_checkpoint(file, "hash"); }});
    return kinds;
}

int try_all(double seconds, std::uint64_t seed)
{
    char folder[] = "/tmp/mutated_XXXXXX";
    if (mkdtemp(folder) == nullptr) return 1;
    for (const Kind& kind : all_kinds(folder)) try_kind(kind, seconds, seed, folder);
    fs::remove_all(folder);
    return 0;
}

} // namespace
} // namespace quicksand

int main(int count, char** words)
{
    if (count != 3) {
        std::printf("mutated_inputs SECONDS SEED\n");
        return 2;
    }
    return quicksand::try_all(std::atof(words[1]), std::strtoull(words[2], nullptr, 10));
}
