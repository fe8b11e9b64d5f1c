#include "app/commands/commands.hpp"
#include "app/run/example_folder.hpp"
#include "geometry/drawing/nearest_name.hpp"
#include "io/files/atomic_file.hpp"
#include "io/keys/diagnostics.hpp"
#include "solver/base/failure.hpp"

#include <iostream>

namespace quicksand {

namespace {

const ExampleKind& find_kind(const std::string& name)
{
    for (const ExampleKind& kind : example_kinds())
        if (kind.word == name) return kind;
    const std::string nearest = nearest_name(name, example_names());
    throw InputError("there is no kind of scene '" + name + "'\nexpected: " + one_of(example_names()) +
                     (nearest.empty() ? "" : "\nhint: did you mean " + nearest + "?"));
}

std::string replace_once(std::string text, const std::string& from, const std::string& to)
{
    const std::size_t place = text.find(from);
    ENSURE(place != std::string::npos);
    return text.replace(place, from.size(), to);
}

} // namespace

ExitCode create_scene(const NewChoice& choice)
{
    const ExampleKind& kind = find_kind(choice.example);
    const std::filesystem::path folder =
        choice.folder.has_filename() ? choice.folder : choice.folder.parent_path();
    const std::string name = folder.filename().string();
    if (std::filesystem::exists(folder)) {
        throw InputError(folder.string() + " exists already\nhint: choose a new name, or remove it first");
    }
    if (name.empty() || name.find_first_of("\"\\") != std::string::npos) {
        throw InputError("'" + folder.string() +
                         "' cannot be the name of a scene: it must be a plain folder name");
    }
    const std::filesystem::path example = example_folder(kind.folder);
    const std::string drawing = name + ".geo";
    const std::string scene = replace_once(read_text(example / "scene.toml"),
                                           "file = \"" + kind.drawing + "\"", "file = \"" + drawing + "\"");
    std::filesystem::create_directories(folder);
    write_atomically(folder / "scene.toml", scene);
    write_atomically(folder / drawing, read_text(example / kind.drawing));
    for (const std::string& file : kind.files) write_atomically(folder / file, read_text(example / file));
    std::cout << "Made " << (folder / "scene.toml").string() << " and " << (folder / drawing).string()
              << ". Change them as you like, then:\n  quicksand check " << folder.string()
              << "\n  quicksand run " << folder.string() << '\n';
    return ExitCode::good;
}

} // namespace quicksand
