// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "output/scene/canvas.hpp"
#include "output/scene/chart.hpp"
#include "output/scene/overlay.hpp"
#include "output/scene/scene.hpp"
#include "verification/pictures/worker.hpp"

#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>

#include <array>
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

namespace aneurysm::verification
{

/// A window with the artery on the left and two charts on the right.
class Window
{
public:
    Window(const Scenario& scenario, double spacing, Worker& worker, std::int64_t last, int width,
           int height);

    /// Until it is closed. `keys`: pressed by nobody, one by one.
    void run(const std::vector<std::string>& keys);

    std::int64_t frame() const { return snapshot_.record.frame; } ///< that is shown
    /// What it showed when q closed it; empty when it was closed otherwise.
    const output::Image& picture() const { return closing_; }

private:
    void on_timer();
    void on_key();
    void ignore() {}
    void press(const std::string& key);
    void save() const;
    void update(); ///< from the worker's newest state
    void place_charts();
    std::string note() const;

    const Scenario& scenario_;
    Worker& worker_;
    std::int64_t last_;
    output::Scene scene_;
    output::Look look_;
    std::array<output::Range, 2> ranges_{}; ///< by quantity; they only grow
    output::Overlay overlay_;
    output::FrameChart impact_;
    output::FrameChart wall_;
    vtkSmartPointer<vtkRenderer> charts_;
    vtkSmartPointer<vtkRenderWindow> window_;
    vtkSmartPointer<vtkRenderWindowInteractor> interactor_;
    output::Snapshot snapshot_;
    std::vector<FrameRecord> records_;
    std::deque<std::string> keys_;
    output::Image closing_;
    bool help_ = false;
    bool changed_ = true;   ///< something that the picture doesn't show yet
    bool reported_ = false; ///< the simulation's error
};

} // namespace aneurysm::verification
