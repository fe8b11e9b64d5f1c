// One function of several, for std::visit.
#pragma once

namespace quicksand {

/// Its call is that of the case whose argument fits.
template <class... Cases>
struct Overload : Cases... {
    using Cases::operator()...;
};
template <class... Cases>
Overload(Cases...) -> Overload<Cases...>;

} // namespace quicksand
