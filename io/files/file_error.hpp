// Files and disk gone wrong: full disk, missing rights, damaged results. FileError itself stands with the
// other failures, for the geometry throws it too.
#pragma once

#include "solver/base/failure.hpp"
