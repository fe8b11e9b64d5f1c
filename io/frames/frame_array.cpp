#include "io/frames/frame_array.hpp"

#include <string>

namespace quicksand {

FrameArray frame_array(const Quantity& quantity)
{
    FrameArray array{std::string(quantity.name), std::string(quantity.unit), {}, {}};
    if (quantity.form == QuantityForm::vector) array.components = {"X", "Y", "Z"};
    if (quantity.form == QuantityForm::tensor) array.components = {"XX", "YY", "ZZ", "XY"};
    return array;
}

} // namespace quicksand
