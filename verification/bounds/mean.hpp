// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "verification/bounds/inexact.hpp"

namespace aneurysm::bounds
{

/// A mean of values x with weights w, sum w x / sum w, and how far rounding moves it (docs/bounds.md, B31).
/// First all are added, then all are compared with the mean.
template <class Value>
class WeightedMean
{
public:
    void add(const Inexact& w, const Value& x)
    {
        sum_ += w.value * x;
        weights_ += w.value;
        weights_error_ += w.error;
        ++count_;
    }

    /// Value{} without weights.
    Value value() const { return weights_ > 0 ? 1 / weights_ * sum_ : Value{}; }

    /// \param error  of x [in U]
    void compare(const Inexact& w, const Value& x, double error)
    {
        const double distance = size(x - value());
        terms_ += w.error * distance + w.value * error;
        sizes_ += w.value * size(x);
        farthest_ = std::max(farthest_, distance);
        largest_ = std::max(largest_, size(x));
        largest_error_ = std::max(largest_error_, error);
    }

    /// [in U]
    double error(const Rounding& rounding) const
    {
        const double roundings = 2 * count_ + 5; // the weights' factor and product, both sums, the quotient
        // No mean of these lies farther away, whatever the weights.
        const double any_weights = rounding.units(farthest_) + largest_error_ + roundings * largest_;
        const double least = weights_ - rounding.absolute(weights_error_);
        if (!(least > 0)) {
            return any_weights + rounding.units(size(value())); // there may be none
        }
        return std::min((terms_ + roundings * sizes_) / least, any_weights);
    }

private:
    static double size(double x) { return std::abs(x); }
    static double size(const Vec3& x) { return length(x); }

    Value sum_{};
    double weights_ = 0;
    double weights_error_ = 0;
    double count_ = 0;
    double terms_ = 0;
    double sizes_ = 0;
    double farthest_ = 0;
    double largest_ = 0;
    double largest_error_ = 0;
};

} // namespace aneurysm::bounds
