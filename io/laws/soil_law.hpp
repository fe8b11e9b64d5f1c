// What a scene needs to know of a soil law: its word, its keys, how it is read, what `check` says of it. A
// law with a name and keys in solver/soil has all of it; the functions here are for laws that want more.
#pragma once

#include "io/keys/scene_check.hpp"
#include "solver/problem/problem.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace quicksand {

/// What a law is read from.
struct LawSource {
    SceneValues& values; // its resolved keys may get the numbers that defaults give
    const NamedTable& table;
    const Material& material; // with its phases, without the law
    Diagnostics& findings;
};

struct SoilLaw {
    std::string_view word = {}; // of materials.*.model
    SkeletonLaw form = {};      // any law of the kind: for what all of them have in common
    /// Rows of its keys below materials.*, but for the condition on the model.
    std::vector<SceneKey> keys = {};
    /// Report what the keys say against each other; none: nothing.
    void (*check)(const LawSource&) = nullptr;
    /// The law of a material, where its keys do not fill it one by one. With keys that are missing or wrong,
    /// which has been reported, the law is not to be used.
    SkeletonLaw (*read)(const LawSource&) = nullptr;
    /// What `check` says of it at the horizontal over vertical stress k0; none: nothing.
    std::string (*describe)(const Material&, double k0) = nullptr;
};

} // namespace quicksand
