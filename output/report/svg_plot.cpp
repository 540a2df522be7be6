// SPDX-License-Identifier: Apache-2.0
#include "output/report/svg_plot.hpp"

#include "output/report/numbers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace aneurysm::report
{
namespace
{

// The picture [px].
constexpr double width = 640;
constexpr double left = 78;
constexpr double right = 624;
constexpr double top = 12;
constexpr double bottom = 292;
constexpr double legend_top = bottom + 62;
constexpr double legend_line = 19;
constexpr std::size_t styles = 6; ///< of series

std::string px(double x)
{
    return printed("%.1f", x);
}

std::string label(double x)
{
    return printed("%.5g", x == 0 ? 0 : x); // -0 is 0
}

/// One axis: from values to pixels, and where its ticks are.
class Axis
{
public:
    Axis(bool logarithmic, double from, double to) : log_(logarithmic), from_(from), to_(to) {}

    void include(double x) ///< that it shows
    {
        low_ = std::min(low_, scaled(x));
        high_ = std::max(high_, scaled(x));
    }
    /// After the last value: some air.
    void close()
    {
        if (low_ > high_) {
            low_ = high_ = log_ ? 0 : 0.5; // nothing to show
        }
        const double air = high_ > low_ ? 0.04 * (high_ - low_)
                           : log_       ? 0.5
                                        : std::max(std::abs(low_), 1.0) / 2;
        low_ -= air;
        high_ += air;
    }

    bool shows(double x) const { return std::isfinite(x) && (!log_ || x > 0); }
    double place(double x) const { return from_ + (to_ - from_) * (scaled(x) - low_) / (high_ - low_); }
    /// Multiples of 1, 2 or 5 times a power of ten, four to nine of them; on a logarithmic axis of more than
    /// a decade of exponents.
    std::vector<double> ticks() const
    {
        const bool decades = log_ && high_ - low_ > 1;
        const auto value = [&](double x) { return log_ && !decades ? std::pow(10, x) : x; };
        const double rough = (value(high_) - value(low_)) / 8;
        const double power = std::pow(10, std::floor(std::log10(rough)));
        const double digit = rough / power;
        const double fine = power * (digit <= 1 ? 1 : digit <= 2 ? 2 : digit <= 5 ? 5 : 10);
        const double step = decades ? std::max(fine, 1.0) : fine;
        std::vector<double> ticks;
        for (double n = std::ceil(value(low_) / step); n * step <= value(high_); ++n) {
            ticks.push_back(decades ? std::pow(10, n * step) : n * step);
        }
        return ticks;
    }

private:
    double scaled(double x) const { return log_ ? std::log10(x) : x; }

    bool log_;
    double from_;
    double to_;
    double low_ = std::numeric_limits<double>::infinity();
    double high_ = -std::numeric_limits<double>::infinity();
};

struct Axes {
    Axis x;
    Axis y;

    bool show(const Series& s, std::size_t k) const { return x.shows(s.x[k]) && y.shows(s.y[k]); }
};

std::size_t size(const Series& s)
{
    return std::min(s.x.size(), s.y.size());
}

Axes axes_of(const Plot& plot)
{
    Axes axes{Axis(plot.log_x, left, right), Axis(plot.log_y, bottom, top)};
    for (const Series& s : plot.series) {
        for (std::size_t k = 0; k < size(s); ++k) {
            if (axes.show(s, k)) {
                axes.x.include(s.x[k]);
                axes.y.include(s.y[k]);
            }
        }
    }
    axes.x.close();
    axes.y.close();
    return axes;
}

Markup line(const char* style, double x_0, double y_0, double x_1, double y_1)
{
    return empty_element(
        "line", {{"class", style}, {"x1", px(x_0)}, {"y1", px(y_0)}, {"x2", px(x_1)}, {"y2", px(y_1)}});
}

Markup text(double x, double y, const char* anchor, const std::string& content,
            const std::string& transform = "")
{
    return element("text", {{"x", px(x)}, {"y", px(y)}, {"text-anchor", anchor}, {"transform", transform}},
                   content);
}

Markup frame(const Plot& plot, const Axes& axes)
{
    Markup result;
    for (const double x : axes.x.ticks()) {
        const double at = axes.x.place(x);
        result << line("grid", at, top, at, bottom) << text(at, bottom + 18, "middle", label(x));
    }
    for (const double y : axes.y.ticks()) {
        const double at = axes.y.place(y);
        result << line("grid", left, at, right, at) << text(left - 8, at + 4, "end", label(y));
    }
    constexpr double middle = (top + bottom) / 2;
    return result << line("axis", left, bottom, right, bottom) << line("axis", left, top, left, bottom)
                  << text((left + right) / 2, bottom + 40, "middle", plot.x_label)
                  << text(14, middle, "middle", plot.y_label, "rotate(-90 14 " + px(middle) + ")");
}

/// Circle, square, diamond, triangle, cross, plus.
Markup marker(std::size_t style, double x, double y)
{
    static constexpr std::array<const char*, styles> shapes{"a3.5 3.5 0 1 0 7 0a3.5 3.5 0 1 0 -7 0",
                                                            "m0.5 -3h6v6h-6z",
                                                            "l3.5 -4.5l3.5 4.5l-3.5 4.5z",
                                                            "m0 3l3.5 -7l3.5 7z",
                                                            "m0.5 -3l6 6m0 -6l-6 6",
                                                            "h7m-3.5 -3.5v7"};
    return empty_element("path", {{"class", "s" + std::to_string(style)},
                                  {"d", "M" + px(x - 3.5) + " " + px(y) + shapes.at(style)}});
}

Markup curve(std::size_t style, const std::string& path)
{
    return empty_element("path", {{"class", "curve s" + std::to_string(style)}, {"d", path}});
}

/// A curve or points, and in the legend what they are.
Markup series(const Series& s, std::size_t style, double legend_y, const Axes& axes)
{
    Markup points;
    std::string path;
    bool pen_down = false;
    std::size_t hidden = 0;
    for (std::size_t k = 0; k < size(s); ++k) {
        const bool shown = axes.show(s, k);
        if (shown) {
            const double x = axes.x.place(s.x[k]);
            const double y = axes.y.place(s.y[k]);
            points << marker(style, x, y);
            path += (pen_down ? "L" : "M") + px(x) + " " + px(y);
        }
        hidden += shown ? 0 : 1;
        pen_down = shown;
    }
    Markup result = s.line ? curve(style, path) << curve(style, "M" + px(left) + " " + px(legend_y) + "h28")
                           : points << marker(style, left + 14, legend_y);
    const std::string remark =
        hidden > 0 ? " (" + std::to_string(hidden) + " points have no place here)" : "";
    return result << text(left + 38, legend_y + 4, "start", s.name + remark);
}

} // namespace

Markup svg(const Plot& plot)
{
    const Axes axes = axes_of(plot);
    Markup content = frame(plot, axes);
    double y = legend_top;
    for (std::size_t k = 0; k < plot.series.size(); ++k) {
        content << series(plot.series[k], k % styles, y, axes);
        y += legend_line;
    }
    return element(
        "svg", {{"viewBox", "0 0 " + px(width) + " " + px(y)}, {"role", "img"}, {"aria-label", plot.title}},
        content);
}

} // namespace aneurysm::report
