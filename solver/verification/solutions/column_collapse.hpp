// Published scalings of collapsing columns: rough checks of flow at very large strain.
#pragma once

#include <optional>

namespace quicksand {

/// A dry granular column in a channel (Lube, Huppert, Sparks and Freundt 2005), aspect ratio a = h_i / d_i of
/// its initial height to its initial width; it spreads to one side, away from a wall. Scatter of the
/// experiments about 10 %; the material hardly matters.
///
/// Runout over the initial width, (d_inf - d_i) / d_i [-]: 1.2 a for a < 1.8, 1.9 a^(2/3) for a > 2.8;
/// nothing between, where the two laws do not meet.
std::optional<double> lube_runout_ratio(double aspect_ratio);

/// Final height at the wall over the initial width, h_inf / d_i [-]: a for a < 1.15, 0.65 a^(2/5) above.
double lube_final_height_ratio(double aspect_ratio);

} // namespace quicksand
