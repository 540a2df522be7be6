// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/frame.hpp"

#include <vtkChartXY.h>
#include <vtkContextActor.h>
#include <vtkSmartPointer.h>
#include <vtkTable.h>

#include <cstdint>
#include <vector>

namespace aneurysm::pictures
{

/// Two numbers of a run over its frames.
class FrameChart
{
public:
    enum class Content {
        impact, ///< the wall's load and P_c
        wall,   ///< R, and h on the right
    };

    /// `font`: height of its letters [pixels]
    FrameChart(Content content, int font);

    vtkContextActor& actor() { return *actor_; }
    /// Where in the renderer, from its lower left corner. [pixels]
    void place(double x, double y, double width, double height);
    /// `marked`: frame of the line across the chart; the frames axis ends at `last`, or later.
    void show(const std::vector<FrameRecord>& records, std::int64_t warm_up_frames, std::int64_t marked,
              std::int64_t last);

private:
    void set_axis(int axis, double low, double high);

    Content content_;
    vtkSmartPointer<vtkContextActor> actor_;
    vtkSmartPointer<vtkChartXY> chart_;
    vtkSmartPointer<vtkTable> values_;
    vtkSmartPointer<vtkTable> mark_;
};

} // namespace aneurysm::pictures
