// What gmsh made of drawings, kept for runs of the same drawing: loading gmsh takes a tenth of a second of
// processor time.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace quicksand {

/// The place of one drawing in the folder. It is known by all that goes into it: the text of all its files,
/// its parameters, and the program that reads it.
class DrawingStore {
public:
    /// `arguments` are those of the program `helper` behind the name of its result. Nothing is kept where
    /// `folder` is empty, and of drawings that may come out differently the next time.
    DrawingStore(const std::filesystem::path& folder, const std::filesystem::path& drawing,
                 const std::filesystem::path& helper, const std::vector<std::string>& arguments);

    /// What was kept of this very drawing.
    std::optional<nlohmann::json> find() const;

    /// A folder that cannot be written keeps nothing: the next run asks gmsh again.
    void keep(const nlohmann::json& result) const;

private:
    std::filesystem::path file_; // empty: nothing is kept
    std::string made_from_;
};

} // namespace quicksand
