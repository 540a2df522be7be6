// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace thrust
{

template <class Iterator, class Function>
struct transform_iterator {
    Iterator in;
    Function function;
    auto operator[](int i) const { return function(in[i]); }
};
template <class Iterator, class Function>
transform_iterator<Iterator, Function> make_transform_iterator(Iterator in, Function function)
{
    return {in, function};
}

} // namespace thrust
