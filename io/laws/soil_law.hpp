// What scenes and element tests need to know of a soil law: its word, its keys, how it is read, what is said
// of it. A law with a name and keys in solver/soil has all of it; the functions here are for laws that want
// more.
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

/// A law with what reports of element tests say of it.
struct DescribedLaw {
    SkeletonLaw law = {};
    std::string title = {};       // "UBCSAND"
    std::string density = {};     // as given, "(N1)60 = 13.9"; "" where a law knows none
    std::string density_key = {}; // that gave it
    std::string numbers = {};     // "shear_modulus = 10 MPa, poisson_ratio = 0.3"
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
    /// Rows of its keys in element tests, and how it is read there; none: as in scenes.
    std::vector<SceneKey> element_keys = {};
    DescribedLaw (*read_for_element)(const LawSource&) = nullptr;
    /// A usual soil of the law, for benchmarks; none: the middle of what is usual for each of its keys.
    SkeletonLaw (*example)() = nullptr;
};

} // namespace quicksand
