// SPDX-License-Identifier: Apache-2.0
#include "output/pictures/chart.hpp"

#include <vtkAxis.h>
#include <vtkBrush.h>
#include <vtkChartLegend.h>
#include <vtkContextScene.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPen.h>
#include <vtkPlot.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <array>
#include <limits>
#include <string>

namespace aneurysm::pictures
{
namespace
{

struct Line {
    const char* name;
    std::array<unsigned char, 3> color;
};

std::array<Line, 2> lines_of(FrameChart::Content content)
{
    if (content == FrameChart::Content::impact) {
        return {Line{"load [N]", {31, 90, 160}}, Line{"P_c [Pa]", {214, 92, 20}}};
    }
    return {Line{"R [m]", {20, 130, 60}}, Line{"h [mm]", {130, 60, 150}}};
}

std::array<double, 2> values_of(FrameChart::Content content, const FrameRecord& r)
{
    return content == FrameChart::Content::impact ? std::array{r.wall_load, r.critical_pressure}
                                                  : std::array{r.radius, 1000 * r.thickness};
}

/// The numbers of a line, and the part of an axis that shows them.
struct AxisRange {
    double low = std::numeric_limits<double>::infinity();
    double high = 0;

    void add(double x)
    {
        low = std::min(low, x);
        high = std::max(high, x);
    }
    double bottom() const { return std::min(low, high); }
    /// With room for the legend; R and h that don't change yet have some, too.
    double top() const { return high + 0.3 * std::max({high - bottom(), 0.01 * high, 1e-9}); }
};

vtkSmartPointer<vtkTable> make_table(const std::array<const char*, 3>& names)
{
    auto table = vtkSmartPointer<vtkTable>::New();
    for (const char* name : names) {
        vtkNew<vtkDoubleArray> column;
        column->SetName(name);
        table->AddColumn(column);
    }
    return table;
}

void set_row(vtkTable& table, vtkIdType row, const std::array<double, 3>& numbers)
{
    for (int column = 0; column < 3; ++column) {
        vtkDoubleArray::SafeDownCast(table.GetColumn(column))
            ->InsertValue(row, numbers.at(static_cast<std::size_t>(column)));
    }
}

void set_font(vtkAxis& axis, int font)
{
    axis.GetLabelProperties()->SetFontSize(font);
    axis.GetTitleProperties()->SetFontSize(font);
    axis.GetTitleProperties()->BoldOff();
    axis.GetGridPen()->SetColor(205, 210, 216);
}

} // namespace

FrameChart::FrameChart(Content content, int font)
    : content_(content), actor_(vtkSmartPointer<vtkContextActor>::New()),
      chart_(vtkSmartPointer<vtkChartXY>::New()),
      values_(make_table({"frame", lines_of(content)[0].name, lines_of(content)[1].name})),
      mark_(make_table({"frame", "low", "high"}))
{
    chart_->SetAutoSize(false);
    chart_->GetBackgroundBrush()->SetColorF(1, 1, 1, 0);
    const float width = static_cast<float>(font) / 11;
    for (int i = 0; i < 2; ++i) {
        vtkPlot* const plot = chart_->AddPlot(vtkChart::LINE);
        plot->SetInputData(values_, 0, i + 1);
        const Line line = lines_of(content).at(static_cast<std::size_t>(i));
        plot->SetColor(line.color[0], line.color[1], line.color[2], 255);
        plot->SetWidth(width);
        plot->SetLabel(line.name);
        if (content == Content::wall && i == 1) {
            chart_->SetPlotCorner(plot, 1);
        }
    }
    vtkPlot* const mark = chart_->AddPlot(vtkChart::LINE);
    mark->SetInputData(mark_, 0, 1);
    mark->SetColor(90, 90, 90, 255);
    mark->SetWidth(width);
    mark->LegendVisibilityOff();
    for (const int axis : {vtkAxis::LEFT, vtkAxis::BOTTOM, vtkAxis::RIGHT}) {
        set_font(*chart_->GetAxis(axis), font);
    }
    chart_->GetAxis(vtkAxis::BOTTOM)->SetTitle("frame");
    chart_->GetAxis(vtkAxis::LEFT)->SetTitle(content == Content::wall ? "R [m]" : "");
    chart_->GetAxis(vtkAxis::RIGHT)->SetTitle("h [mm]");
    chart_->SetShowLegend(true);
    vtkChartLegend& legend = *chart_->GetLegend();
    legend.SetLabelSize(font);
    legend.SetHorizontalAlignment(vtkChartLegend::LEFT);
    legend.SetVerticalAlignment(vtkChartLegend::TOP);
    legend.GetBrush()->SetColorF(1, 1, 1, 0.7);
    legend.GetPen()->SetLineType(vtkPen::NO_PEN);
    actor_->GetScene()->AddItem(chart_);
}

void FrameChart::place(double x, double y, double width, double height)
{
    chart_->SetSize(vtkRectf(static_cast<float>(x), static_cast<float>(y), static_cast<float>(width),
                             static_cast<float>(height)));
}

void FrameChart::set_axis(int axis, double low, double high)
{
    chart_->GetAxis(axis)->SetBehavior(vtkAxis::FIXED);
    chart_->GetAxis(axis)->SetRange(low, high);
}

void FrameChart::show(const std::vector<FrameRecord>& records, std::int64_t warm_up_frames,
                      std::int64_t marked, std::int64_t last)
{
    std::array<AxisRange, 2> ranges; // without the warm-up, whose forces are many times those of the flow
    values_->SetNumberOfRows(0);
    for (const FrameRecord& record : records) {
        const std::array<double, 2> numbers = values_of(content_, record);
        set_row(*values_, values_->GetNumberOfRows(),
                {static_cast<double>(record.frame), numbers[0], numbers[1]});
        if (record.frame > warm_up_frames || records.back().frame <= warm_up_frames) {
            ranges[0].add(numbers[0]);
            ranges[1].add(numbers[1]);
        }
    }
    while (values_->GetNumberOfRows() < 2) { // VTK complains about shorter lines
        const std::array<double, 2> numbers =
            records.empty() ? std::array<double, 2>{} : values_of(content_, records.back());
        set_row(*values_, values_->GetNumberOfRows(), {static_cast<double>(marked), numbers[0], numbers[1]});
    }
    if (content_ == Content::impact) {
        ranges[0].add(ranges[1].high);
        ranges[0].add(0);
    }
    const auto frame = static_cast<double>(marked);
    mark_->SetNumberOfRows(0);
    set_row(*mark_, 0, {frame, ranges[0].bottom(), 0});
    set_row(*mark_, 1, {frame, ranges[0].top(), 0});
    values_->Modified();
    mark_->Modified();
    const std::int64_t end = records.empty() ? last : std::max(last, records.back().frame);
    set_axis(vtkAxis::BOTTOM, 0, static_cast<double>(std::max<std::int64_t>(end, 1)));
    set_axis(vtkAxis::LEFT, ranges[0].bottom(), ranges[0].top());
    set_axis(vtkAxis::RIGHT, ranges[1].bottom(), ranges[1].top());
    chart_->RecalculateBounds();
}

} // namespace aneurysm::pictures
